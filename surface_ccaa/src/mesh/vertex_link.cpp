// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: matching the triangles around one vertex edge by edge.
#include "mesh/vertex_link.h"

#include <algorithm>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace pcl::ccaa {
namespace {

constexpr std::uint32_t NO_PARTNER = std::numeric_limits<std::uint32_t>::max();
constexpr unsigned int NEXT[3] = {1, 2, 0};

static_assert(sizeof(pcl::index_t) == sizeof(std::int32_t),
              "corners are compared as 32-bit lanes");

/** \brief Which corner of a triangle a vertex is; it must be one. */
inline unsigned int
cornerNumber(const Triangle& triangle, pcl::index_t vertex)
{
  return static_cast<unsigned int>(triangle[1] == vertex) +
         2 * static_cast<unsigned int>(triangle[2] == vertex);
}

/** \brief Number of the lowest bit set; there must be one. */
inline unsigned int
lowestBit(std::uint32_t bits)
{
#if defined(__GNUC__) || defined(__clang__)
  return static_cast<unsigned int>(__builtin_ctz(bits));
#else
  unsigned int bit = 0;
  while (((bits >> bit) & 1u) == 0)
    ++bit;
  return bit;
#endif
}

/** \brief Whether exactly one bit is set. */
inline bool
isSingle(std::uint32_t bits)
{
  return bits != 0 && (bits & (bits - 1u)) == 0;
}

/** \brief One bit for each of eight corners: is it the one looked for? */
inline std::uint32_t
equalToEight(const std::int32_t* corners, std::int32_t corner)
{
#ifdef __SSE2__
  const auto* lanes = reinterpret_cast<const __m128i*>(corners);
  const __m128i all = _mm_set1_epi32(corner);
  const __m128i low = _mm_cmpeq_epi32(_mm_load_si128(lanes), all);
  const __m128i high = _mm_cmpeq_epi32(_mm_load_si128(lanes + 1), all);
  const __m128i bytes =
      _mm_packs_epi16(_mm_packs_epi32(low, high), _mm_setzero_si128());
  return static_cast<std::uint32_t>(_mm_movemask_epi8(bytes));
#else
  std::uint32_t same = 0;
  for (unsigned int i = 0; i < 8; ++i)
    same |= static_cast<std::uint32_t>(corners[i] == corner) << i;
  return same;
#endif
}

/** \brief Link of a vertex with up to LANES triangles. The two ends of triangle i lie
 * at places i and i + LANES, so place ^ LANES is the other end of the same triangle. */
template <unsigned int LANES>
class SmallLink {
public:
  SmallLink(const Triangles& triangles,
            pcl::index_t vertex,
            const pcl::index_t* first,
            const pcl::index_t* last)
  : vertex_(vertex), count_(static_cast<unsigned int>(last - first)), triangles_(first)
  {
    std::fill(std::begin(ends_), std::end(ends_), pcl::index_t{-1});
    for (unsigned int i = 0; i < count_; ++i) {
      const Triangle& triangle = triangles[static_cast<std::size_t>(first[i])];
      const unsigned int corner = cornerNumber(triangle, vertex);
      const unsigned int previous = NEXT[NEXT[corner]];
      const std::size_t slot = 3 * static_cast<std::size_t>(first[i]);
      ends_[i] = triangle[NEXT[corner]];
      ends_[i + LANES] = triangle[previous];
      slots_[i] = slot + corner;
      slots_[i + LANES] = slot + previous;
    }
  }

  /** \brief Match all ends; gives up with OVERFULL at an end that fits twice. */
  Fan
  match(pcl::index_t* across)
  {
    return matchRing(across) ? Fan::CLOSED : matchChains(across);
  }

private:
  /** \brief Match one closed chain, which most vertices have: walks both ways at once,
   * because one way waits for the previous step most of the time.
   * \return false when it is anything else; then nothing is settled yet */
  bool
  matchRing(pcl::index_t* across)
  {
    unsigned int forward = LANES, backward = 0;
    for (unsigned int length = 1; length <= count_; length += 2) {
      const std::uint32_t same_forward = sameCorner(forward);
      const std::uint32_t same_backward = sameCorner(backward);
      if (!isSingle(same_forward) || !isSingle(same_backward))
        return false;
      const unsigned int ahead = lowestBit(same_forward);
      const unsigned int behind = lowestBit(same_backward);
      connect(across, forward, ahead);
      connect(across, backward, behind);
      if (ahead == backward)
        return length == count_ && length > 2;
      if (ahead % LANES == behind % LANES)
        return length + 1 == count_ && length > 2;
      forward = ahead ^ LANES;
      backward = behind ^ LANES;
    }
    return false;
  }

  /** \brief Match any number of open and closed chains. */
  Fan
  matchChains(pcl::index_t* across)
  {
    std::uint32_t todo = (1u << count_) - 1u;
    Fan fan = Fan::NONE;
    while (todo != 0) {
      const Fan chain = walk(todo, across);
      if (chain == Fan::OVERFULL)
        return chain;
      fan = fan == Fan::NONE ? chain : Fan::SEVERAL;
    }
    return fan;
  }

  /** \brief Places whose corner equals the one at a place, without that place. */
  std::uint32_t
  sameCorner(unsigned int place) const
  {
    std::uint32_t same = equalToEight(ends_, ends_[place]);
    for (unsigned int i = 8; i < 2 * LANES; i += 8)
      same |= equalToEight(ends_ + i, ends_[place]) << i;
    return same & ~(1u << place);
  }

  /** \brief Walk the chain of the first triangle still to do. */
  Fan
  walk(std::uint32_t& todo, pcl::index_t* across)
  {
    const unsigned int start = lowestBit(todo);
    todo &= todo - 1u;
    const Fan forward = walkFrom(start + LANES, start, todo, across);
    return forward == Fan::OPEN ? walkFrom(start, start, todo, across) : forward;
  }

  /** \brief Walk on from a place until a border or the start triangle is reached. */
  Fan
  walkFrom(unsigned int place,
           unsigned int start,
           std::uint32_t& todo,
           pcl::index_t* across)
  {
    for (unsigned int length = 1;; ++length) {
      const std::uint32_t same = sameCorner(place);
      if ((same & (same - 1u)) != 0)
        return Fan::OVERFULL;
      if (same == 0) {
        write(across, place, TriangleAdjacency::NONE);
        return Fan::OPEN;
      }
      const unsigned int partner = lowestBit(same);
      const unsigned int next = partner % LANES;
      connect(across, place, partner);
      if (next == start)
        return length > 2 ? Fan::CLOSED : Fan::SEVERAL;
      todo &= ~(1u << next);
      place = partner ^ LANES;
    }
  }

  /** \brief Write that two places meet. */
  void
  connect(pcl::index_t* across, unsigned int place, unsigned int partner)
  {
    write(across, place, triangles_[partner % LANES]);
    write(across, partner, triangles_[place % LANES]);
  }

  /** \brief Write the slot of a place unless the other end of the edge has to. */
  void
  write(pcl::index_t* across, unsigned int place, pcl::index_t value)
  {
    pcl::index_t elsewhere = 0;
    *(ends_[place] > vertex_ ? across + slots_[place] : &elsewhere) = value;
  }

  pcl::index_t vertex_;
  unsigned int count_;
  const pcl::index_t* triangles_;
  alignas(16) pcl::index_t ends_[2 * LANES];
  std::size_t slots_[2 * LANES];
};

} // namespace

Fan
VertexLink::match(const Triangles& triangles,
                  pcl::index_t vertex,
                  const pcl::index_t* first,
                  const pcl::index_t* last,
                  pcl::index_t* across)
{
  const auto count = last - first;
  Fan fan = Fan::OVERFULL;
  if (count <= 8)
    fan = SmallLink<8>(triangles, vertex, first, last).match(across);
  else if (count <= 16)
    fan = SmallLink<16>(triangles, vertex, first, last).match(across);
  return fan != Fan::OVERFULL ? fan : matchMany(triangles, vertex, first, last, across);
}

Fan
VertexLink::matchMany(const Triangles& triangles,
                      pcl::index_t vertex,
                      const pcl::index_t* first,
                      const pcl::index_t* last,
                      pcl::index_t* across)
{
  collectEnds(triangles, vertex, first, last);
  return pairEnds(vertex, first, across) ? walkPartners() : Fan::OVERFULL;
}

void
VertexLink::collectEnds(const Triangles& triangles,
                        pcl::index_t vertex,
                        const pcl::index_t* first,
                        const pcl::index_t* last)
{
  ends_.clear();
  slots_.clear();
  for (const auto* item = first; item != last; ++item) {
    const Triangle& triangle = triangles[static_cast<std::size_t>(*item)];
    const unsigned int corner = cornerNumber(triangle, vertex);
    const unsigned int previous = NEXT[NEXT[corner]];
    const std::size_t slot = 3 * static_cast<std::size_t>(*item);
    const auto place = static_cast<std::uint32_t>(slots_.size());
    ends_.emplace_back(triangle[NEXT[corner]], place);
    ends_.emplace_back(triangle[previous], place + 1);
    slots_.push_back(slot + corner);
    slots_.push_back(slot + previous);
  }
  std::sort(ends_.begin(), ends_.end());
}

/** \return false when an edge is overfull */
bool
VertexLink::pairEnds(pcl::index_t vertex,
                     const pcl::index_t* first,
                     pcl::index_t* across)
{
  partners_.assign(ends_.size(), NO_PARTNER);
  overfull_.clear();
  bool manifold = true;
  for (auto begin = ends_.begin(), end = begin; begin != ends_.end(); begin = end) {
    end = std::find_if(begin, ends_.end(), [&](const End& other) {
      return other.first != begin->first;
    });
    const auto fill = end - begin;
    if (fill == 2) {
      partners_[begin[0].second] = begin[1].second;
      partners_[begin[1].second] = begin[0].second;
    }
    manifold = manifold && fill <= 2;
    if (begin->first < vertex)
      continue;
    if (fill > 2)
      overfull_.insert(overfull_.end(), begin, end);
    for (auto item = begin; item != end; ++item) {
      const std::uint32_t partner = partners_[item->second];
      across[slots_[item->second]] = fill > 2    ? TriangleAdjacency::OVERFULL
                                     : fill == 1 ? TriangleAdjacency::NONE
                                                 : first[partner / 2];
    }
  }
  return manifold;
}

/** \brief The fan of a link without overfull edges. */
Fan
VertexLink::walkPartners()
{
  std::uint32_t start = 0;
  const auto border = std::find(partners_.begin(), partners_.end(), NO_PARTNER);
  const bool open = border != partners_.end();
  if (open)
    start = static_cast<std::uint32_t>(border - partners_.begin()) ^ 1u;
  std::size_t length = 1;
  std::uint32_t place = partners_[start];
  for (const std::uint32_t stop = open ? NO_PARTNER : start ^ 1u; place != stop;
       ++length)
    place = partners_[place ^ 1u];
  if (2 * length != partners_.size())
    return Fan::SEVERAL;
  return open ? Fan::OPEN : Fan::CLOSED;
}

void
VertexLink::appendOverfull(
    pcl::index_t vertex,
    const pcl::index_t* first,
    std::vector<std::pair<TriangleAdjacency::Edge, pcl::index_t>>& edges) const
{
  for (const auto& [far_corner, place] : overfull_)
    edges.emplace_back(TriangleAdjacency::Edge{vertex, far_corner}, first[place / 2]);
}

} // namespace pcl::ccaa
