// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the chains of triangles around a point (thesis 3.4).
#pragma once

#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief One flag for each triangle: not yet deleted. */
using AliveFlags = std::vector<std::uint8_t>;

/** \brief A chain: triangles at a point, each sharing an edge at the point with the
 * next; of a closed one the last also with the first. */
struct FanChain {
  bool closed = false;
  std::size_t first = 0; /**< place in PointChains::triangles() */
  std::size_t size = 0;  /**< number of triangles, at least 1 */
};

/** \brief Finds the chains of triangles around a point, whatever their winding.
 *
 * One object serves many points, one after the other, without allocating anew. Edges
 * with three triangles or more end a chain: the umbrella filter repairs them first
 * (C3.4-1). Cost: d log d for d triangles at the point.
 */
class PointChains {
public:
  /** \brief Find the chains around a vertex.
   * \param[in] alive flags of the triangles that count; null: all count */
  void
  find(const Triangles& triangles,
       const TriangleAdjacency& adjacency,
       pcl::index_t vertex,
       const AliveFlags* alive = nullptr);

  /** \brief Open chains first; each kind by its lowest triangle at an end of the chain
   * (open) or anywhere (closed). */
  const std::vector<FanChain>&
  chains() const
  {
    return chains_;
  }

  /** \brief The triangles of all chains, in the order of the chains. */
  const std::vector<pcl::index_t>&
  triangles() const
  {
    return members_;
  }

private:
  struct Surroundings;

  void
  walk(const Surroundings& around, pcl::index_t start, int side);
  bool
  take(pcl::index_t triangle);

  std::vector<FanChain> chains_;
  std::vector<pcl::index_t> members_;
  std::vector<pcl::index_t> candidates_; /**< live triangles at the point, ascending */
  std::vector<std::uint8_t> taken_;      /**< of a candidate: is in a chain */
};

} // namespace pcl::ccaa
