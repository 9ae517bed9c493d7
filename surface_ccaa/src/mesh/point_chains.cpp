// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the chains of triangles around a point (thesis 3.4).
#include "mesh/point_chains.h"

#include <algorithm>

namespace pcl::ccaa {

/** The mesh as seen from one vertex. Side 0 of a triangle is its edge from the vertex
 * to the next corner, side 1 the one to the previous corner. */
struct PointChains::Surroundings {
  const Triangles& mesh;
  const TriangleAdjacency& adjacency;
  const pcl::index_t vertex;
  const AliveFlags* alive;

  bool
  isAlive(pcl::index_t triangle) const
  {
    return alive == nullptr || (*alive)[static_cast<std::size_t>(triangle)] != 0;
  }

  /** \brief Live triangle over a side, or NONE. */
  pcl::index_t
  across(pcl::index_t triangle, int side) const
  {
    const int corner = cornerOf(mesh[static_cast<std::size_t>(triangle)], vertex);
    const auto other =
        adjacency.across(triangle, side == 0 ? corner : (corner + 2) % 3);
    return other >= 0 && isAlive(other) ? other : TriangleAdjacency::NONE;
  }

  /** \brief Far corner of a side. */
  pcl::index_t
  farCorner(pcl::index_t triangle, int side) const
  {
    const Triangle& corners = mesh[static_cast<std::size_t>(triangle)];
    const int corner = cornerOf(corners, vertex);
    return corners[static_cast<std::size_t>((corner + 1 + side) % 3)];
  }
};

void
PointChains::find(const Triangles& triangles,
                  const TriangleAdjacency& adjacency,
                  pcl::index_t vertex,
                  const AliveFlags* alive)
{
  const Surroundings around{triangles, adjacency, vertex, alive};
  chains_.clear();
  members_.clear();
  candidates_.clear();
  std::copy_if(adjacency.begin(vertex),
               adjacency.end(vertex),
               std::back_inserter(candidates_),
               [&](pcl::index_t triangle) { return around.isAlive(triangle); });
  taken_.assign(candidates_.size(), 0);
  for (std::size_t i = 0; i < candidates_.size(); ++i)
    for (int side = 0; side < 2; ++side)
      if (taken_[i] == 0 &&
          around.across(candidates_[i], side) == TriangleAdjacency::NONE)
        walk(around, candidates_[i], 1 - side);
  for (std::size_t i = 0; i < candidates_.size(); ++i)
    if (taken_[i] == 0)
      walk(around, candidates_[i], 0);
}

/** Walks from a triangle over one of its sides, and on until a border or itself. */
void
PointChains::walk(const Surroundings& around, pcl::index_t start, int side)
{
  FanChain chain;
  chain.first = members_.size();
  pcl::index_t triangle = start;
  while (take(triangle)) {
    const auto next = around.across(triangle, side);
    if (next == TriangleAdjacency::NONE)
      break;
    chain.closed = next == start;
    const auto hinge = around.farCorner(triangle, side);
    side = around.farCorner(next, 0) == hinge ? 1 : 0;
    triangle = next;
  }
  chain.size = members_.size() - chain.first;
  chains_.push_back(chain);
}

/** \return false when the triangle is in a chain already */
bool
PointChains::take(pcl::index_t triangle)
{
  const auto place = static_cast<std::size_t>(
      std::lower_bound(candidates_.begin(), candidates_.end(), triangle) -
      candidates_.begin());
  if (taken_[place] != 0)
    return false;
  taken_[place] = 1;
  members_.push_back(triangle);
  return true;
}

} // namespace pcl::ccaa
