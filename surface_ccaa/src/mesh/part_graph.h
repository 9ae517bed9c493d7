// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: parts of a surface, and how the rest connects them.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/disjoint_sets.h"
#include "mesh/triangle_adjacency.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace pcl::ccaa {

/** \brief Parts of a surface, the triangles at flagged vertices as far as they are
 * connected, and the components of the rest between them. Both are nodes of a graph.
 *
 * An edge is 3 i + corner from which it leads, of the i-th triangle of all parts. What
 * it is made from must outlive it. Cost: a look at each triangle, and of those of parts
 * O(n log n); connectRest() some 0.1 us a triangle of all, on all threads. */
class PartGraph {
public:
  struct Part {
    std::size_t root = 0;      /**< its node */
    pcl::index_t flagged = -1; /**< the lowest one */
    std::size_t triangles = 0;
    std::vector<pcl::index_t> vertices, cut_vertices;
    std::vector<std::size_t> cut_edges; /**< where the part ends */
    std::vector<std::size_t> loops;     /**< one of these for each */

    long
    genus() const;
  };

  /** \param[in] adjacency of the triangles, which are a manifold and wound alike
   * \param[in] is_flagged by vertex */
  PartGraph(const Triangles& triangles,
            const TriangleAdjacency& adjacency,
            const std::vector<std::uint8_t>& is_flagged,
            int threads = 1);

  /** \brief By their nodes. */
  const std::map<std::size_t, Part>&
  parts() const
  {
    return parts_;
  }

  bool
  isPart(const Triangle& triangle) const
  {
    return isFlagged(triangle[0]) || isFlagged(triangle[1]) || isFlagged(triangle[2]);
  }

  /** \brief Triangles of all parts, ascending. */
  const std::vector<pcl::index_t>&
  triangles() const
  {
    return list_;
  }

  /** \brief Of the part with the i-th of them. */
  std::size_t
  nodeAt(std::size_t i)
  {
    return inside_.find(i);
  }

  pcl::index_t
  startOf(std::size_t edge) const
  {
    return triangleOf(edge)[edge % 3];
  }

  pcl::index_t
  endOf(std::size_t edge) const
  {
    return startOf(after(edge));
  }

  /** \brief Whether the surface ends at an edge. */
  bool
  isBorder(std::size_t edge) const
  {
    return across(edge) < 0;
  }

  /** \brief Find the components of the rest. What follows needs that.
   * \param[in] connecting along openings of at least so many edges the rest is
   * connected as if they were closed; with 0 each loop around a part leads to one
   * component */
  void
  connectRest(std::size_t connecting);

  /** \brief Those of parts are less than triangles().size(), others at least that. */
  std::size_t
  nodeCount() const
  {
    return list_.size() + is_flagged_.size();
  }

  /** \brief Of the component of the rest that a vertex of it is in. */
  std::size_t
  nodeOf(pcl::index_t vertex)
  {
    return list_.size() + outside_->find(static_cast<std::size_t>(vertex));
  }

  /** \brief Of the component of the rest to which a cut edge leads, which is no border
   * of an opening that does not connect. */
  std::size_t
  nodeBehind(std::size_t edge)
  {
    return nodeOf(startOf(edge));
  }

private:
  bool
  isFlagged(pcl::index_t vertex) const
  {
    return is_flagged_[static_cast<std::size_t>(vertex)] != 0;
  }

  const Triangle&
  triangleOf(std::size_t edge) const
  {
    return triangles_[static_cast<std::size_t>(list_[edge / 3])];
  }

  static std::size_t
  after(std::size_t edge)
  {
    return edge % 3 == 2 ? edge - 2 : edge + 1;
  }

  pcl::index_t
  across(std::size_t edge) const
  {
    return adjacency_.across(list_[edge / 3], static_cast<int>(edge % 3));
  }

  std::vector<pcl::index_t>
  listTriangles() const;
  void
  joinRest(std::size_t t);
  using Border = std::array<std::size_t, 2>; /**< the vertices at its ends */
  void
  addBorders(std::size_t t, std::vector<Border>& borders) const;
  bool
  isCut(std::size_t edge) const;
  std::size_t
  placeAcross(std::size_t edge) const;
  std::size_t
  nextCut(std::size_t edge) const;
  void
  gatherParts();

  const Triangles& triangles_;
  const TriangleAdjacency& adjacency_;
  const std::vector<std::uint8_t>& is_flagged_;
  int threads_;
  std::vector<pcl::index_t> list_;      /**< triangles of all parts, ascending */
  DisjointSets inside_;                 /**< of these: the parts */
  DisjointSets loops_;                  /**< of edges around these */
  std::optional<DisjointSets> outside_; /**< of vertices: the components of the rest */
  std::map<std::size_t, Part> parts_;
};

} // namespace pcl::ccaa
