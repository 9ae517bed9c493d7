// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: rings of a few edges between two parts of a surface.
#include "mesh/thin_necks.h"

#include "mesh/corners.h"
#include "mesh/disjoint_sets.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <array>
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

/** The triangles within some edges of a vertex. */
class Surroundings {
public:
  Surroundings(pcl::index_t center,
               const Triangles& triangles,
               const TriangleAdjacency& adjacency,
               const PointView& points)
  : triangles_(triangles)
  , adjacency_(adjacency)
  , points_(points)
  , vertices_{center}
  , rim_{center}
  {}

  void
  addRing()
  {
    std::vector<pcl::index_t> around, corners;
    for (const pcl::index_t vertex : rim_) {
      is_inside_ = is_inside_ && adjacency_.fan(vertex) == Fan::CLOSED;
      around.insert(around.end(), adjacency_.begin(vertex), adjacency_.end(vertex));
    }
    for (const pcl::index_t t : addTo(chosen_, std::move(around))) {
      const Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    }
    rim_ = addTo(vertices_, std::move(corners));
    rims_ = rimEdges();
  }

  /** Whether Euler's characteristic is 1, as nearly always. */
  bool
  areDisc() const
  {
    return vertices_.size() * 2 == chosen_.size() + rims_.size() + 2;
  }

  /** Whether they are an annulus whose two rims turn like those of wide cones, and no
   * boundary is near. */
  bool
  areNeck() const
  {
    if (!is_inside_ || areDisc())
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
    std::vector<std::array<std::size_t, 2>> ends;
    for (std::size_t i = 0; i < n; ++i)
      for (int corner = 0; corner < 3; ++corner)
        if (!isChosen(adjacency_.across(chosen_[i], corner)))
          ends.push_back({fans.find(cornerOf(i, corner)),
                          fans.find(cornerOf(i, (corner + 1) % 3))});
    const std::size_t vertices = fans.count();
    for (const auto& [from, to] : ends) // what is left of them are rims
      fans.join(from, to);
    const std::size_t inner = vertices - ends.size(); // each rim has as many vertices
    const std::size_t rims = fans.count() - inner;
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
    const auto found = std::lower_bound(chosen_.begin(), chosen_.end(), across);
    if (found == chosen_.end() || *found != across)
      return;
    const Triangle& one = triangles_[static_cast<std::size_t>(chosen_[place])];
    const Triangle& other = triangles_[static_cast<std::size_t>(across)];
    for (const int end : {corner, (corner + 1) % 3})
      fans.join(
          cornerOf(place, end),
          cornerOf(static_cast<std::size_t>(found - chosen_.begin()),
                   static_cast<int>(std::find(other.begin(),
                                              other.end(),
                                              one[static_cast<std::size_t>(end)]) -
                                    other.begin())));
  }

  bool
  isChosen(pcl::index_t triangle) const
  {
    return std::binary_search(chosen_.begin(), chosen_.end(), triangle);
  }

  std::vector<TriangleAdjacency::Edge>
  rimEdges() const
  {
    std::vector<TriangleAdjacency::Edge> edges;
    for (const pcl::index_t t : chosen_)
      for (int corner = 0; corner < 3; ++corner)
        if (!isChosen(adjacency_.across(t, corner))) {
          const Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
          const auto from = static_cast<std::size_t>(corner);
          edges.push_back({triangle[from], triangle[(from + 1) % 3]});
        }
    return edges;
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
  std::vector<pcl::index_t> vertices_; /**< ascending */
  std::vector<pcl::index_t> rim_;      /**< those that the last ring has added */
  std::vector<pcl::index_t> chosen_;   /**< triangles, ascending */
  std::vector<TriangleAdjacency::Edge> rims_;
  bool is_inside_ = true; /**< the rings before the last have met no boundary */
};

} // namespace

std::vector<ThinNeck>
thinNecks(const Triangles& triangles,
          const TriangleAdjacency& adjacency,
          const PointView& points,
          const LoopContext& context,
          const std::vector<pcl::index_t>* among)
{
  const auto isSaddle = [&](pcl::index_t vertex) {
    const auto angleOf = [&](pcl::index_t t) {
      return angleAt(triangles[static_cast<std::size_t>(t)], vertex, points);
    };
    return adjacency.fan(vertex) == Fan::CLOSED &&
           adjacency.end(vertex) - adjacency.begin(vertex) >= FEWEST_AROUND &&
           anglesAt(vertex, adjacency, angleOf) > 2.0 * M_PI + SADDLE;
  };
  /** What a vertex is on; nothing if neither a neck nor a handle. */
  const auto neckAt = [&](pcl::index_t vertex) -> std::optional<ThinNeck> {
    Surroundings around(vertex, triangles, adjacency, points);
    int in_a_row = 0;
    for (int ring = 1; ring <= MOST_RINGS + in_a_row; ++ring) {
      around.addRing();
      if (ring == MOST_RINGS && around.haveHandle())
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
          if (!isSaddle(vertex))
            continue;
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

std::vector<pcl::index_t>
verticesOf(const std::vector<ThinNeck>& necks)
{
  std::vector<pcl::index_t> vertices;
  for (const ThinNeck& neck : necks)
    if (!neck.is_handle)
      vertices.push_back(neck.vertex);
  return vertices;
}

} // namespace pcl::ccaa
