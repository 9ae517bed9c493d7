// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what lies within a few edges of a vertex of a surface.
#include "mesh/surroundings.h"

#include "mesh/sort_unique.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::ccaa {
namespace {

/** By how much a loop around a cone of 60 degrees turns: 2 pi times the sine of the
 * angle from its axis to its side. */
constexpr double TURN_OF_CONE = M_PI;
/** The same around a cone of 10 degrees: less, and it is a tube. */
constexpr double TURN_OF_TUBE = M_PI / 3.0;

} // namespace

void
Surroundings::addRing()
{
  const std::size_t first_added = chosen_.size();
  for (std::size_t i = rim_; i < vertices_.size(); ++i) {
    const pcl::index_t vertex = vertices()[i];
    for (const auto* t = adjacency_.begin(vertex); t != adjacency_.end(vertex); ++t)
      chosen_.insert(*t);
  }
  rim_ = vertices_.size();
  for (std::size_t i = first_added; i < chosen_.size(); ++i)
    for (const pcl::index_t corner :
         triangles_[static_cast<std::size_t>(triangles()[i])])
      vertices_.insert(corner);
  findRims(first_added);
}

bool
Surroundings::areNeck() const
{
  if (areDisc() || reachBorder())
    return false;
  const std::vector<double> turns = turnsOf(rims_);
  return turns.size() == 2 && turns[0] >= TURN_OF_CONE && turns[1] >= TURN_OF_CONE;
}

bool
Surroundings::haveHandle() const
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
      if (!chosen_.contains(adjacency_.across(triangles()[i], corner)))
        ends.emplace_back(fans.find(cornerOf(i, corner)),
                          fans.find(cornerOf(i, (corner + 1) % 3)));
  const std::size_t vertices = fans.count();
  for (const auto& [from, to] : ends) // what is left of them are rims
    fans.join(from, to);
  const std::size_t rims = fans.count() + ends.size() - vertices;
  // 2 - 2 genus - rims = vertices - edges + triangles, and 2 edges = 3 n + |ends|
  return vertices * 2 + 2 * rims < n + ends.size() + 4;
}

bool
Surroundings::areCap() const
{
  return areDisc() && borders_.empty() && turnsOf(rims_).front() < TURN_OF_TUBE;
}

Position
Surroundings::center() const
{
  Position sum = Position::Zero();
  for (const pcl::index_t vertex : vertices())
    sum += points_[vertex];
  return sum / static_cast<double>(vertices_.size());
}

Position
Surroundings::areaVector() const
{
  Position sum = Position::Zero();
  for (const pcl::index_t t : triangles())
    sum += areaNormal(cornersOf(triangles_[static_cast<std::size_t>(t)], points_));
  return sum;
}

void
Surroundings::joinAcross(std::size_t place, int corner, DisjointSets& fans) const
{
  const pcl::index_t across = adjacency_.across(triangles()[place], corner);
  const pcl::index_t there = chosen_.placeOf(across);
  if (there < 0)
    return;
  const Triangle& one = triangles_[static_cast<std::size_t>(triangles()[place])];
  const Triangle& other = triangles_[static_cast<std::size_t>(across)];
  for (const int end : {corner, (corner + 1) % 3}) {
    const auto* same =
        std::find(other.begin(), other.end(), one[static_cast<std::size_t>(end)]);
    fans.join(cornerOf(place, end),
              cornerOf(static_cast<std::size_t>(there),
                       static_cast<int>(same - other.begin())));
  }
}

/** All triangles at the vertices before the last ring are chosen, so only those that it
 * has added have rims. */
void
Surroundings::findRims(std::size_t first_added)
{
  rims_.clear();
  for (std::size_t i = first_added; i < chosen_.size(); ++i)
    for (int corner = 0; corner < 3; ++corner) {
      const pcl::index_t across = adjacency_.across(triangles()[i], corner);
      if (chosen_.contains(across))
        continue;
      const Triangle& triangle = triangles_[static_cast<std::size_t>(triangles()[i])];
      const auto from = static_cast<std::size_t>(corner);
      (across < 0 ? borders_ : rims_)
          .push_back({triangle[from], triangle[(from + 1) % 3]});
    }
}

bool
Surroundings::reachBorder() const
{
  const auto touch = [](const auto& rim, const auto& border) {
    return rim[0] == border[1] || rim[1] == border[0];
  };
  return std::find_first_of(
             rims_.begin(), rims_.end(), borders_.begin(), borders_.end(), touch) !=
         rims_.end();
}

std::vector<double>
Surroundings::turnsOf(const std::vector<TriangleAdjacency::Edge>& edges) const
{
  std::vector<pcl::index_t> vertices;
  for (const auto& edge : edges)
    vertices.insert(vertices.end(), edge.begin(), edge.end());
  sortUnique(vertices);
  const auto placeOf = [&](pcl::index_t vertex) {
    return static_cast<std::size_t>(
        std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin());
  };
  DisjointSets rims(vertices.size());
  for (const auto& [from, to] : edges)
    rims.join(placeOf(from), placeOf(to));
  std::map<std::size_t, double> turns;
  for (const auto& edge : edges)
    turns[rims.find(placeOf(edge[0]))] += M_PI;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    turns[rims.find(i)] -=
        anglesAt(vertices[i], triangles_, adjacency_, points_, [&](pcl::index_t t) {
          return chosen_.contains(t);
        });
  std::vector<double> list;
  for (const auto& [vertex, turn] : turns)
    list.push_back(turn);
  return list;
}

} // namespace pcl::ccaa
