// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what lies within a few edges of a vertex of a surface.
#include "mesh/surroundings.h"

#include "mesh/sort_unique.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace pcl::ccaa {
namespace {

/** By how much a loop around a cone of 60 degrees turns: 2 pi times the sine of the
 * angle from its axis to its side. */
constexpr double TURN_OF_CONE = M_PI;
/** The same around a cone of 10 degrees: less, and it is a tube. */
constexpr double TURN_OF_TUBE = M_PI / 3.0;

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

} // namespace

void
Surroundings::addRing()
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

bool
Surroundings::areCap() const
{
  return areDisc() && borders_.empty() && turnsOf(rims_).front() < TURN_OF_TUBE;
}

Position
Surroundings::center() const
{
  Position sum = Position::Zero();
  for (const pcl::index_t vertex : vertices_)
    sum += points_[vertex];
  return sum / static_cast<double>(vertices_.size());
}

Position
Surroundings::areaVector() const
{
  Position sum = Position::Zero();
  for (const pcl::index_t t : chosen_)
    sum += areaNormal(cornersOf(triangles_[static_cast<std::size_t>(t)], points_));
  return sum;
}

void
Surroundings::joinAcross(std::size_t place, int corner, DisjointSets& fans) const
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
Surroundings::isChosen(pcl::index_t triangle) const
{
  return std::binary_search(chosen_.begin(), chosen_.end(), triangle);
}

void
Surroundings::findRims()
{
  rims_.clear();
  borders_.clear();
  for (const pcl::index_t t : chosen_)
    for (int corner = 0; corner < 3; ++corner)
      if (const pcl::index_t across = adjacency_.across(t, corner); !isChosen(across)) {
        const Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
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
          return isChosen(t);
        });
  std::vector<double> list;
  for (const auto& [vertex, turn] : turns)
    list.push_back(turn);
  return list;
}

} // namespace pcl::ccaa
