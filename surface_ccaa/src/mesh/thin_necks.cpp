// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: rings of a few edges between two parts of a surface.
#include "mesh/thin_necks.h"

#include "mesh/surroundings.h"

#include <algorithm>
#include <cmath>
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
  return rim;
}

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
    const bool is_saddle =
        adjacency.fan(vertex) == Fan::CLOSED &&
        adjacency.end(vertex) - adjacency.begin(vertex) >= FEWEST_AROUND &&
        anglesAt(vertex, triangles, adjacency, points) > 2.0 * M_PI + SADDLE;
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
