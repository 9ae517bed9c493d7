// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: matching the triangles around one vertex edge by edge.
#pragma once

#include "mesh/triangle_adjacency.h"

#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief The link of a vertex: of each triangle around it the two other corners. Two
 * triangles with an equal corner meet over the edge to that corner.
 *
 * This is the innermost loop of the umbrella filter. Up to 16 triangles are matched
 * by comparing with all corners at once, which compiles to vector code without a
 * branch; more are sorted.
 */
class VertexLink {
public:
  /** \brief Match the triangles [first, last) around a vertex.
   * \param[out] across slots of edges to higher vertices are written here, those to
   * lower vertices are left to those: each slot has one writer */
  Fan
  match(const Triangles& triangles,
        pcl::index_t vertex,
        const pcl::index_t* first,
        const pcl::index_t* last,
        pcl::index_t* across);

  /** \brief After match() has returned OVERFULL: append the overfull edges to higher
   * vertices, each once for every triangle on it, in ascending order. */
  void
  appendOverfull(
      pcl::index_t vertex,
      const pcl::index_t* first,
      std::vector<std::pair<TriangleAdjacency::Edge, pcl::index_t>>& edges) const;

private:
  /** \brief A corner and its place: 2 i or 2 i + 1 for triangle i around the vertex. */
  using End = std::pair<pcl::index_t, std::uint32_t>;

  Fan
  matchMany(const Triangles& triangles,
            pcl::index_t vertex,
            const pcl::index_t* first,
            const pcl::index_t* last,
            pcl::index_t* across);
  void
  collectEnds(const Triangles& triangles,
              pcl::index_t vertex,
              const pcl::index_t* first,
              const pcl::index_t* last);
  bool
  pairEnds(pcl::index_t vertex, const pcl::index_t* first, pcl::index_t* across);
  Fan
  walkPartners();

  std::vector<End> ends_;               /**< sorted by corner */
  std::vector<std::size_t> slots_;      /**< of a place: its slot in across */
  std::vector<std::uint32_t> partners_; /**< of a place: the one over the edge */
  std::vector<End> overfull_;           /**< the ends at overfull edges */
};

} // namespace pcl::ccaa
