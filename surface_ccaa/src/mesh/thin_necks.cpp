// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: rings of a few edges between two parts of a surface.
#include "mesh/thin_necks.h"

#include "mesh/corners.h"
#include "mesh/disjoint_sets.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace pcl::ccaa {
namespace {

/** What the angles at a vertex of a neck exceed those of a plane by. Around two spheres
 * that lie a spacing of their points apart every second vertex has that. */
constexpr double SADDLE = 1.0;
/** Triangles around a vertex, the fewest that may have such angles. */
constexpr std::ptrdiff_t FEWEST_AROUND = 7;
/** Rings of triangles around a vertex that may hold a neck. */
constexpr int MOST_RINGS = 4;
/** Edges around an opening beside which a neck is looked for. */
constexpr std::size_t MOST_OPENING = 40;
/** By how many rings more the annulus reaches to both sides: with none 39 bumps of a
 * noisy table scene are necks, and 10 of 159 repaired models that are right are in
 * doubt, with two none and one. */
constexpr int MORE_RINGS = 2;
static_assert(MOST_RINGS + MORE_RINGS == EDGES_AROUND_NECK);
/** By how much a loop around a cone of 60 degrees turns: 2 pi times the sine of the
 * angle from its axis to its side. */
constexpr double TURN_OF_CONE = M_PI;

/** What the angles at a vertex add up to. */
template <typename AngleOf>
double
anglesAt(pcl::index_t vertex,
         const TriangleAdjacency& adjacency,
         const AngleOf& angleOf)
{
  return std::accumulate(adjacency.begin(vertex),
                         adjacency.end(vertex),
                         0.0,
                         [&](double sum, auto t) { return sum + angleOf(t); });
}

/** Make items a part of an ascending set. \return those that are new, ascending */
std::vector<pcl::index_t>
addTo(std::vector<pcl::index_t>& set, std::vector<pcl::index_t> items)
{
  sortUnique(items);
  std::vector<pcl::index_t> added;
  std::set_difference(
      items.begin(), items.end(), set.begin(), set.end(), std::back_inserter(added));
  const auto old = static_cast<std::ptrdiff_t>(set.size());
  set.insert(set.end(), added.begin(), added.end());
  std::inplace_merge(set.begin(), set.begin() + old, set.end());
  return added;
}

/** The vertex after another on a boundary, or -1. */
pcl::index_t
nextOnBorder(pcl::index_t vertex,
             const Triangles& triangles,
             const TriangleAdjacency& adjacency)
{
  for (const auto* t = adjacency.begin(vertex); t != adjacency.end(vertex); ++t) {
    const Triangle& triangle = triangles[static_cast<std::size_t>(*t)];
    const auto corner = static_cast<std::size_t>(
        std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
    if (adjacency.across(*t, static_cast<int>(corner)) < 0)
      return triangle[(corner + 1) % 3];
  }
  return -1;
}

/** The rim of a small opening on which a vertex is the lowest; else nothing. */
std::vector<pcl::index_t>
openingFrom(pcl::index_t vertex,
            const Triangles& triangles,
            const TriangleAdjacency& adjacency)
{
  std::vector<pcl::index_t> rim;
  pcl::index_t next = vertex;
  do {
    rim.push_back(next);
    next = nextOnBorder(next, triangles, adjacency);
  }
  while (next > vertex && rim.size() < MOST_OPENING);
  if (next != vertex)
    return {};
  sortUnique(rim);
  return rim;
}

/** The triangles within some edges of a vertex or an opening. */
class Surroundings {
public:
  /** \param[in] center ascending */
  Surroundings(const std::vector<pcl::index_t>& center,
               const Triangles& triangles,
               const TriangleAdjacency& adjacency,
               const PointView& points)
  : triangles_(triangles)
  , adjacency_(adjacency)
  , points_(points)
  , vertices_(center)
  , rim_(center)
  {}

  void
  addRing()
  {
    std::vector<pcl::index_t> around, corners;
    for (const pcl::index_t vertex : rim_)
      around.insert(around.end(), adjacency_.begin(vertex), adjacency_.end(vertex));
    for (const pcl::index_t t : addTo(chosen_, std::move(around))) {
      const Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    rim_ = addTo(vertices_, std::move(corners));
    findRims();
  }

  /** Whether Euler's characteristic is 1, as nearly always. */
  bool
  areDisc() const
  {
    return vertices_.size() * 2 == chosen_.size() + rims_.size() + borders_.size() + 2;
  }

  /** Whether they are an annulus whose two rims turn like those of wide cones, but for
   * openings of which all is among them. */
  bool
  areNeck() const
  {
    if (areDisc() || reachBorder())
      return false;
    const std::vector<double> turns = turnsOf(rims_);
    return turns.size() == 2 && turns[0] >= TURN_OF_CONE && turns[1] >= TURN_OF_CONE;
  }

  /** Whether they have a genus. Where they touch themselves at a vertex, the corners of
   * each fan count as a vertex of their own. */
  bool
  haveHandle() const
  {
    if (areDisc())
      return false;
    const std::size_t n = chosen_.size();
    DisjointSets fans(3 * n);
    for (std::size_t i = 0; i < n; ++i)
      for (int corner = 0; corner < 3; ++corner)
        joinAcross(i, corner, fans);
    std::vector<std::pair<std::size_t, std::size_t>> ends;
    for (std::size_t i = 0; i < n; ++i)
      for (int corner = 0; corner < 3; ++corner)
        if (!isChosen(adjacency_.across(chosen_[i], corner)))
          ends.emplace_back(fans.find(cornerOf(i, corner)),
                            fans.find(cornerOf(i, (corner + 1) % 3)));
    const std::size_t vertices = fans.count();
    for (const auto& [from, to] : ends) // what is left of them are rims
      fans.join(from, to);
    const std::size_t rims = fans.count() + ends.size() - vertices;
    // 2 - 2 genus - rims = vertices - edges + triangles, and 2 edges = 3 n + |ends|
    return vertices * 2 + 2 * rims < n + ends.size() + 4;
  }

  const std::vector<pcl::index_t>&
  vertices() const
  {
    return vertices_;
  }

private:
  static std::size_t
  cornerOf(std::size_t place, int corner)
  {
    return 3 * place + static_cast<std::size_t>(corner);
  }

  /** Join the corners at both ends of an edge with those of the triangle across it. */
  void
  joinAcross(std::size_t place, int corner, DisjointSets& fans) const
  {
    const pcl::index_t across = adjacency_.across(chosen_[place], corner);
    if (!isChosen(across))
      return;
    const auto there = static_cast<std::size_t>(
        std::lower_bound(chosen_.begin(), chosen_.end(), across) - chosen_.begin());
    const Triangle& one = triangles_[static_cast<std::size_t>(chosen_[place])];
    const Triangle& other = triangles_[static_cast<std::size_t>(across)];
    for (const int end : {corner, (corner + 1) % 3}) {
      const auto* same =
          std::find(other.begin(), other.end(), one[static_cast<std::size_t>(end)]);
      fans.join(cornerOf(place, end),
                cornerOf(there, static_cast<int>(same - other.begin())));
    }
  }

  bool
  isChosen(pcl::index_t triangle) const
  {
    return std::binary_search(chosen_.begin(), chosen_.end(), triangle);
  }

  void
  findRims()
  {
    rims_.clear();
    borders_.clear();
    for (const pcl::index_t t : chosen_)
      for (int corner = 0; corner < 3; ++corner)
        if (const pcl::index_t across = adjacency_.across(t, corner);
            !isChosen(across)) {
          const Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
          const auto from = static_cast<std::size_t>(corner);
          (across < 0 ? borders_ : rims_)
              .push_back({triangle[from], triangle[(from + 1) % 3]});
        }
  }

  /** Whether a boundary of the surface leads out of them. */
  bool
  reachBorder() const
  {
    const auto touch = [](const auto& rim, const auto& border) {
      return rim[0] == border[1] || rim[1] == border[0];
    };
    return std::find_first_of(
               rims_.begin(), rims_.end(), borders_.begin(), borders_.end(), touch) !=
           rims_.end();
  }

  /** By how much each rim turns towards the inside, radians, 2 pi around a disc. */
  std::vector<double>
  turnsOf(const std::vector<TriangleAdjacency::Edge>& edges) const
  {
    std::vector<pcl::index_t> vertices;
    for (const auto& edge : edges)
      vertices.insert(vertices.end(), edge.begin(), edge.end());
    sortUnique(vertices);
    const auto placeOf = [&](pcl::index_t vertex) {
      return static_cast<std::size_t>(
          std::lower_bound(vertices.begin(), vertices.end(), vertex) -
          vertices.begin());
    };
    DisjointSets rims(vertices.size());
    for (const auto& [from, to] : edges)
      rims.join(placeOf(from), placeOf(to));
    std::map<std::size_t, double> turns;
    for (const auto& edge : edges)
      turns[rims.find(placeOf(edge[0]))] += M_PI;
    for (std::size_t i = 0; i < vertices.size(); ++i)
      turns[rims.find(i)] -= anglesAt(vertices[i], adjacency_, [&](pcl::index_t t) {
        const Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
        return isChosen(t) ? angleAt(triangle, vertices[i], points_) : 0.0;
      });
    std::vector<double> list;
    for (const auto& [vertex, turn] : turns)
      list.push_back(turn);
    return list;
  }

  const Triangles& triangles_;
  const TriangleAdjacency& adjacency_;
  const PointView& points_;
  std::vector<pcl::index_t> vertices_;        /**< ascending */
  std::vector<pcl::index_t> rim_;             /**< those that the last ring has added */
  std::vector<pcl::index_t> chosen_;          /**< triangles, ascending */
  std::vector<TriangleAdjacency::Edge> rims_; /**< the surface goes on there */
  std::vector<TriangleAdjacency::Edge> borders_; /**< and ends there */
};

} // namespace

std::vector<ThinNeck>
thinNecks(const Triangles& triangles,
          const TriangleAdjacency& adjacency,
          const PointView& points,
          const LoopContext& context,
          const std::vector<pcl::index_t>* among)
{
  /** Where a neck is looked for from: a vertex, or the opening that begins with it. */
  const auto centerAt = [&](pcl::index_t vertex) -> std::vector<pcl::index_t> {
    if (adjacency.fan(vertex) == Fan::OPEN)
      return openingFrom(vertex, triangles, adjacency);
    const auto angleOf = [&](pcl::index_t t) {
      return angleAt(triangles[static_cast<std::size_t>(t)], vertex, points);
    };
    const bool is_saddle =
        adjacency.fan(vertex) == Fan::CLOSED &&
        adjacency.end(vertex) - adjacency.begin(vertex) >= FEWEST_AROUND &&
        anglesAt(vertex, adjacency, angleOf) > 2.0 * M_PI + SADDLE;
    return is_saddle ? std::vector{vertex} : std::vector<pcl::index_t>();
  };
  /** What a vertex is on; nothing if neither a neck nor a handle. */
  const auto neckAt = [&](pcl::index_t vertex) -> std::optional<ThinNeck> {
    const auto center = centerAt(vertex);
    if (center.empty())
      return {};
    Surroundings around(center, triangles, adjacency, points);
    int in_a_row = 0;
    for (int ring = 1; ring <= MOST_RINGS + in_a_row; ++ring) {
      around.addRing();
      if (ring == MOST_RINGS && center.size() == 1 && around.haveHandle())
        return ThinNeck{vertex, around.vertices(), true};
      in_a_row = around.areNeck() ? in_a_row + 1 : 0;
      if (in_a_row > MORE_RINGS)
        return ThinNeck{vertex, around.vertices()};
    }
    return {};
  };
  const std::size_t count = among == nullptr ? adjacency.vertexCount() : among->size();
  std::vector<std::vector<ThinNeck>> found(context.blockCount(count));
  forEachBlock(
      count, context, [&](std::size_t block, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto vertex =
              among == nullptr ? static_cast<pcl::index_t>(i) : (*among)[i];
          if (auto neck = neckAt(vertex))
            found[block].push_back(std::move(*neck));
        }
      });
  std::vector<ThinNeck> necks;
  std::set<pcl::index_t> told;
  for (const ThinNeck& neck : joinBlocks(found)) {
    if (told.count(neck.vertex) == 0)
      necks.push_back(neck);
    told.insert(neck.around.begin(), neck.around.end());
  }
  return necks;
}

} // namespace pcl::ccaa
