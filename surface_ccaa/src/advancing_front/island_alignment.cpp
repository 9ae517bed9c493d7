// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: winding the given islands alike before they are joined.
#include "advancing_front/island_alignment.h"

#include "advancing_front/tuning.h"
#include "mesh/corners.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace pcl::ccaa {
namespace {

Position
normalAt(pcl::index_t vertex,
         const Triangles& triangles,
         const TriangleAdjacency& adjacency,
         const PointView& points)
{
  Position sum = Position::Zero();
  for (const auto* t = adjacency.begin(vertex); t != adjacency.end(vertex); ++t)
    sum += areaNormal(cornersOf(triangles[static_cast<std::size_t>(*t)], points));
  return sum.normalized();
}

/** Islands in groups; each knows whether it is turned against the head of its group. */
class TurnedGroups {
public:
  TurnedGroups(const std::vector<std::size_t>& sizes,
               const std::vector<double>& evidence)
  : sizes_(sizes)
  , head_(sizes.size())
  , turned_(sizes.size(), 0)
  , is_evident_(sizes.size(), 0)
  , members_(sizes.size())
  {
    std::iota(head_.begin(), head_.end(), std::size_t(0));
    for (std::size_t i = 0; i < sizes.size(); ++i)
      members_[i] = {i};
    for (std::size_t i = 0; i < evidence.size(); ++i) {
      turned_[i] = evidence[i] < 0.0;
      is_evident_[i] = evidence[i] != 0.0;
    }
  }

  /** \brief Join the groups of two islands: the one without evidence to the one with
   * it, else the smaller one to the larger one. Evidence is not outvoted. */
  void
  join(std::size_t one, std::size_t other, bool opposite)
  {
    std::size_t stays = head_[one], goes = head_[other];
    if (stays == goes || (is_evident_[stays] != 0 && is_evident_[goes] != 0))
      return;
    const bool turn = (turned_[one] != turned_[other]) != opposite;
    if (isBefore(goes, stays))
      std::swap(stays, goes);
    for (const std::size_t island : members_[goes]) {
      head_[island] = stays;
      turned_[island] = turned_[island] != turn;
      members_[stays].push_back(island);
    }
    members_[goes].clear();
  }

  const std::vector<std::uint8_t>&
  turned() const
  {
    return turned_;
  }

private:
  /** Whether a head stays before another one. */
  bool
  isBefore(std::size_t head, std::size_t other) const
  {
    return std::make_tuple(is_evident_[head], sizes_[head], other) >
           std::make_tuple(is_evident_[other], sizes_[other], head);
  }

  const std::vector<std::size_t>& sizes_;
  std::vector<std::size_t> head_;
  std::vector<std::uint8_t> turned_;
  std::vector<std::uint8_t> is_evident_; /**< of a head */
  std::vector<std::vector<std::size_t>> members_;
};

using IslandPair = std::pair<std::size_t, std::size_t>;

/** What the contacts say: positive for alike. */
std::map<IslandPair, double>
votes(const Triangles& triangles,
      const TriangleAdjacency& adjacency,
      const Islands& islands,
      const PointView& points,
      const std::vector<IslandContact>& contacts)
{
  const auto island_of = [&](pcl::index_t vertex) {
    return islands[static_cast<std::size_t>(*adjacency.begin(vertex))];
  };
  std::map<IslandPair, double> sums;
  for (const IslandContact& contact : contacts) {
    const std::size_t one = island_of(contact.one), other = island_of(contact.other);
    if (one == other)
      continue;
    const Position across = (points[contact.other] - points[contact.one]).normalized();
    const Position n = normalAt(contact.one, triangles, adjacency, points);
    const Position m = normalAt(contact.other, triangles, adjacency, points);
    if (std::abs(n.dot(across)) < tuning::LARGEST_RISE &&
        std::abs(m.dot(across)) < tuning::LARGEST_RISE)
      sums[std::minmax(one, other)] += n.dot(m);
  }
  return sums;
}

std::vector<std::uint8_t>
againstNeighbors(const std::map<IslandPair, double>& sums,
                 const std::vector<std::size_t>& sizes,
                 const std::vector<double>& evidence)
{
  std::vector<std::pair<double, IslandPair>> pairs;
  for (const auto& [pair, sum] : sums)
    pairs.emplace_back(sum, pair);
  std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(-std::abs(a.first), a.second) <
           std::make_tuple(-std::abs(b.first), b.second);
  });
  TurnedGroups groups(sizes, evidence);
  for (const auto& [sum, pair] : pairs)
    groups.join(pair.first, pair.second, sum < 0.0);
  return groups.turned();
}

} // namespace

bool
alignIslands(Triangles& triangles,
             TriangleAdjacency& adjacency,
             const Islands& islands,
             const PointView& points,
             const std::vector<double>& evidence,
             const std::vector<IslandContact>& contacts)
{
  std::vector<std::size_t> sizes(islands.count, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    ++sizes[islands[t]];
  const std::vector<std::uint8_t> reverse = againstNeighbors(
      votes(triangles, adjacency, islands, points, contacts), sizes, evidence);
  bool any = false;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (reverse[islands[t]] != 0) {
      adjacency.turn(static_cast<pcl::index_t>(t), triangles);
      any = true;
    }
  return any;
}

} // namespace pcl::ccaa
