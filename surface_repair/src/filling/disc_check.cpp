// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether triangles are what a filling promises to be.

#include "filling/disc_check.h"

#include <algorithm>
#include <array>
#include <vector>

namespace pcl::repair {

namespace {

using HalfEdge = std::array<pcl::index_t, 2>;

/** A side of a triangle, in the direction in which it is run through. */
struct Side {
  HalfEdge edge;
  std::size_t triangle;

  bool
  operator<(const Side& other) const
  {
    return edge != other.edge ? edge < other.edge : triangle < other.triangle;
  }
};

std::vector<Side>
sortedSides(const Triangles& triangles)
{
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      sides.push_back({{triangles[t][i], triangles[t][(i + 1) % 3]}, t});
  std::sort(sides.begin(), sides.end());
  return sides;
}

bool
anyEdgeTwice(const std::vector<Side>& sides)
{
  return std::adjacent_find(
             sides.begin(), sides.end(), [](const Side& a, const Side& b) {
               return a.edge == b.edge;
             }) != sides.end();
}

/** The triangle that runs through an edge backwards, or NONE. */
std::size_t
triangleAcross(const std::vector<Side>& sides, const HalfEdge& edge)
{
  const HalfEdge backwards{edge[1], edge[0]};
  const auto other = std::lower_bound(sides.begin(), sides.end(), Side{backwards, 0});
  return other != sides.end() && other->edge == backwards ? other->triangle : NONE;
}

bool
cornersAreValid(const Triangles& triangles, std::size_t vertices)
{
  return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] &&
           std::all_of(t.begin(), t.end(), [&](pcl::index_t corner) {
             return corner >= 0 && static_cast<std::size_t>(corner) < vertices;
           });
  });
}

/** Whether exactly the edges of the polygon have one side, the backward one. */
bool
borderIsPolygon(const std::vector<Side>& sides, std::size_t polygon_size)
{
  std::size_t open = 0;
  for (const Side& side : sides) {
    if (triangleAcross(sides, side.edge) != NONE)
      continue;
    const auto from = static_cast<std::size_t>(side.edge[1]);
    const auto to = static_cast<std::size_t>(side.edge[0]);
    if (from >= polygon_size || to != (from + 1) % polygon_size)
      return false;
    ++open;
  }
  return open == polygon_size;
}

bool
usesEveryVertex(const Triangles& triangles, std::size_t vertices)
{
  std::vector<bool> used(vertices, false);
  for (const Triangle& triangle : triangles)
    for (const pcl::index_t corner : triangle)
      used[static_cast<std::size_t>(corner)] = true;
  return std::all_of(used.begin(), used.end(), [](bool is_used) { return is_used; });
}

/** Whether edges lead from each triangle to every other. */
bool
isConnected(const std::vector<Side>& sides, std::size_t triangles)
{
  std::vector<std::vector<std::size_t>> neighbours(triangles);
  for (const Side& side : sides) {
    const std::size_t across = triangleAcross(sides, side.edge);
    if (across != NONE)
      neighbours[side.triangle].push_back(across);
  }
  std::vector<bool> reached(triangles, false);
  std::vector<std::size_t> open{0};
  reached[0] = true;
  for (std::size_t i = 0; i < open.size(); ++i)
    for (const std::size_t next : neighbours[open[i]])
      if (!reached[next]) {
        reached[next] = true;
        open.push_back(next);
      }
  return open.size() == triangles;
}

} // namespace

bool
isDisc(const Triangles& triangles, std::size_t polygon_size, std::size_t vertices)
{
  if (polygon_size < 3 || triangles.empty() || !cornersAreValid(triangles, vertices) ||
      !usesEveryVertex(triangles, vertices))
    return false;
  const std::vector<Side> sides = sortedSides(triangles);
  if (anyEdgeTwice(sides) || !borderIsPolygon(sides, polygon_size) ||
      !isConnected(sides, triangles.size()))
    return false;
  // Connected, with one border: the characteristic is 1 at most, and pinched vertices
  // would make it less.
  const std::size_t edges = (sides.size() + polygon_size) / 2;
  return vertices + triangles.size() == edges + 1;
}

bool
isDisc(const Filling& filling, std::size_t polygon_size)
{
  return filling.closed() && filling.free_point.size() == filling.inner.size() &&
         isDisc(filling.triangles, polygon_size, polygon_size + filling.inner.size());
}

} // namespace pcl::repair
