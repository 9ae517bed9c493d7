// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: winding the given islands alike before they are joined.
#include "advancing_front/island_alignment.h"

#include "advancing_front/tuning.h"
#include "mesh/corners.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pcl::ccaa {
namespace {

Position
normalAt(const PartPoint& at,
         const Triangles& triangles,
         const TriangleAdjacency& adjacency,
         const Islands& parts,
         const PointView& points)
{
  Position sum = Position::Zero();
  for (const auto* t = adjacency.begin(at.point); t != adjacency.end(at.point); ++t)
    if (const auto triangle = static_cast<std::size_t>(*t); parts[triangle] == at.part)
      sum += areaNormal(cornersOf(triangles[triangle], points));
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

using Pair = std::pair<std::size_t, std::size_t>;
using Votes = std::map<Pair, double>;

/** Of two parts: positive for alike. */
Votes
votesOfParts(const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const Islands& parts,
             const PointView& points,
             const std::vector<PartContact>& contacts)
{
  Votes votes;
  for (const auto& [one, other] : contacts) {
    const Position across = (points[other.point] - points[one.point]).normalized();
    const Position n = normalAt(one, triangles, adjacency, parts, points);
    const Position m = normalAt(other, triangles, adjacency, parts, points);
    if (std::abs(n.dot(across)) < tuning::LARGEST_RISE &&
        std::abs(m.dot(across)) < tuning::LARGEST_RISE)
      votes[std::minmax(one.part, other.part)] += n.dot(m);
  }
  return votes;
}

/** The largest part of each island stays, and the others that do not speak against it;
 * the rest become islands behind the given ones. \return how many islands there are */
std::size_t
partOpposed(const Votes& votes,
            const std::vector<std::size_t>& part_sizes,
            std::size_t count,
            std::vector<std::size_t>& island_of)
{
  const std::size_t parts = part_sizes.size();
  std::vector<double> alike(parts, 0.0);
  for (const auto& [pair, sum] : votes)
    if (island_of[pair.first] == island_of[pair.second])
      for (const std::size_t part : {pair.first, pair.second})
        alike[part] += sum;
  std::vector<std::size_t> largest(count, parts);
  for (std::size_t part = 0; part < parts; ++part)
    if (std::size_t& most = largest[island_of[part]];
        most == parts || part_sizes[part] > part_sizes[most])
      most = part;
  for (std::size_t part = 0; part < parts; ++part)
    if (alike[part] < 0.0 && part != largest[island_of[part]])
      island_of[part] = count++;
  return count;
}

std::vector<std::uint8_t>
againstNeighbors(const IslandVotes& votes, const std::vector<double>& evidence)
{
  std::vector<std::pair<double, Pair>> pairs;
  for (const auto& [pair, sum] : votes.between)
    pairs.emplace_back(sum, pair);
  std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(-std::abs(a.first), a.second) <
           std::make_tuple(-std::abs(b.first), b.second);
  });
  TurnedGroups groups(votes.sizes, evidence);
  for (const auto& [sum, pair] : pairs)
    groups.join(pair.first, pair.second, sum < 0.0);
  return groups.turned();
}

} // namespace

IslandVotes
askNeighbors(const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const Islands& islands,
             const Islands& parts,
             const PointView& points,
             const std::vector<PartContact>& contacts)
{
  const Votes of_parts = votesOfParts(triangles, adjacency, parts, points, contacts);
  IslandVotes votes;
  std::vector<std::size_t>& island_of = votes.island_of_part;
  island_of.resize(parts.count);
  std::vector<std::size_t> part_sizes(parts.count, 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    island_of[parts[t]] = islands[t];
    ++part_sizes[parts[t]];
  }
  votes.sizes.resize(partOpposed(of_parts, part_sizes, islands.count, island_of), 0);
  for (std::size_t part = 0; part < parts.count; ++part)
    votes.sizes[island_of[part]] += part_sizes[part];
  for (const auto& [pair, sum] : of_parts)
    if (const std::size_t one = island_of[pair.first], other = island_of[pair.second];
        one != other)
      votes.between[std::minmax(one, other)] += sum;
  return votes;
}

bool
alignIslands(Triangles& triangles,
             TriangleAdjacency& adjacency,
             const Islands& parts,
             const IslandVotes& votes,
             std::vector<double> evidence)
{
  if (!evidence.empty())
    evidence.resize(votes.sizes.size(), 0.0);
  const std::vector<std::uint8_t> reverse = againstNeighbors(votes, evidence);
  bool any = false;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (reverse[votes.island_of_part[parts[t]]] != 0) {
      adjacency.turn(static_cast<pcl::index_t>(t), triangles);
      any = true;
    }
  return any;
}

} // namespace pcl::ccaa
