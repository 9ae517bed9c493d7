// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: ends of a surface that face each other.
#include "mesh/facing_ends.h"

#include "mesh/near_pairs.h"
#include "mesh/sort_unique.h"
#include "mesh/surroundings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace pcl::ccaa {
namespace {

/** What the angles at a vertex of an end lack to those of a plane. */
constexpr double TIP = 0.5;
/** Rings of triangles around a vertex that may be the end of a stem. */
constexpr int RINGS_OF_END = 3;
/** Mean cosine between the axes of two ends and the way from each to the other: with
 * 0.6 one of 56 wires that were cut is not told. */
constexpr double AHEAD = 0.5;

/** The end of a stem. */
struct End {
  std::vector<pcl::index_t> vertices; /**< of the disc, ascending */
  Position center;
  Position axis; /**< outward, of length 1 */

  /** Whether each is ahead of the other, and nothing belongs to both. */
  bool
  faces(const End& other) const
  {
    const Position way = (other.center - center).normalized();
    return way.dot(axis - other.axis) > 2.0 * AHEAD &&
           std::find_first_of(vertices.begin(),
                              vertices.end(),
                              other.vertices.begin(),
                              other.vertices.end()) == vertices.end();
  }
};

/** Vertices at which a surface is pointed. */
class Tips {
public:
  Tips(const Triangles& triangles,
       const TriangleAdjacency& adjacency,
       const PointView& points)
  : triangles_(triangles), adjacency_(adjacency), points_(points)
  {}

  bool
  isTip(pcl::index_t vertex) const
  {
    return adjacency_.fan(vertex) == Fan::CLOSED &&
           anglesAt(vertex, triangles_, adjacency_, points_) < 2.0 * M_PI - TIP;
  }

  /** Mean length of the edges at a vertex. */
  double
  reachOf(pcl::index_t vertex) const
  {
    double sum = 0.0;
    for (const auto* t = adjacency_.begin(vertex); t != adjacency_.end(vertex); ++t) {
      const Triangle& triangle = triangles_[static_cast<std::size_t>(*t)];
      const auto next = static_cast<std::size_t>(cornerOf(triangle, vertex) + 1) % 3;
      sum += (points_[triangle[next]] - points_[vertex]).norm();
    }
    return sum / static_cast<double>(adjacency_.end(vertex) - adjacency_.begin(vertex));
  }

  bool
  areBeside(pcl::index_t vertex, pcl::index_t other) const
  {
    return std::any_of(adjacency_.begin(vertex), adjacency_.end(vertex), [&](auto t) {
      const Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
      return std::find(triangle.begin(), triangle.end(), other) != triangle.end();
    });
  }

  std::optional<End>
  endAt(pcl::index_t vertex) const
  {
    Surroundings around({vertex}, triangles_, adjacency_, points_);
    for (int ring = 0; ring < RINGS_OF_END; ++ring) {
      around.addRing();
      if (around.areCap())
        return End{
            around.vertices(), around.center(), around.areaVector().normalized()};
    }
    return {};
  }

private:
  const Triangles& triangles_;
  const TriangleAdjacency& adjacency_;
  const PointView& points_;
};

} // namespace

std::vector<Contact>
facingEnds(const std::vector<TriangleAdjacency::Edge>& ridges,
           const Triangles& triangles,
           const TriangleAdjacency& adjacency,
           const PointView& points)
{
  const Tips surface(triangles, adjacency, points);
  std::vector<pcl::index_t> tips;
  for (const auto& ridge : ridges)
    tips.insert(tips.end(), ridge.begin(), ridge.end());
  sortUnique(tips);
  tips.erase(std::remove_if(tips.begin(),
                            tips.end(),
                            [&](auto vertex) { return !surface.isTip(vertex); }),
             tips.end());
  std::map<pcl::index_t, std::optional<End>> ends;
  const auto endAt = [&](pcl::index_t vertex) -> const std::optional<End>& {
    const auto [place, is_new] = ends.try_emplace(vertex);
    if (is_new)
      place->second = surface.endAt(vertex);
    return place->second;
  };
  std::vector<Contact> contacts;
  std::set<pcl::index_t> told;
  const auto visit = [&](pcl::index_t one, pcl::index_t other) {
    if (told.count(one) + told.count(other) > 0 || surface.areBeside(one, other) ||
        !endAt(one) || !endAt(other) || !endAt(one)->faces(*endAt(other)))
      return;
    contacts.push_back({one, other});
    for (const pcl::index_t vertex : {one, other})
      told.insert(endAt(vertex)->vertices.begin(), endAt(vertex)->vertices.end());
  };
  forNearPairs(
      tips, points, [&](auto vertex) { return surface.reachOf(vertex); }, visit);
  return contacts;
}

} // namespace pcl::ccaa
