// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the directed boundary edges from which a surface grows.
#pragma once

#include "mesh/triangle.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief Number of a front edge; they are never used again for another edge. */
using FrontIndex = std::int32_t;

/** \brief An edge with a triangle on one side only, directed as that triangle winds:
 * the surface lies on its left, seen from outside, what is missing on its right. */
struct FrontEdge {
  static constexpr FrontIndex NONE = -1;

  pcl::index_t from = 0;
  pcl::index_t to = 0;
  pcl::index_t apex = 0;        /**< third corner of the triangle on the edge */
  FrontIndex previous = NONE;   /**< ends where this one begins, at the same fan */
  FrontIndex next = NONE;       /**< begins where this one ends, at the same fan */
  FrontIndex next_there = NONE; /**< another edge of the front that begins at `from` */
  bool alive = false;
};

/** \brief The front: all boundary edges of a growing surface, linked to loops.
 *
 * A vertex that several open fans share is on the front once for each fan; an edge is
 * followed by the one at the other end of the same fan, so that a loop never jumps from
 * fan to fan. Two opposite edges between the same vertices cancel each other: the gap
 * between their triangles is closed there. Cost of every operation: the number of fans
 * at a vertex, nearly always one. */
class Front {
public:
  /** \brief An empty front over so many vertices. */
  explicit Front(std::size_t vertex_count) : first_at_(vertex_count, FrontEdge::NONE) {}

  /** \brief Add the boundary of a mesh: all its directed edges without a partner.
   *
   * Where the boundary leads out of what is open, loops are cut: the last edge before
   * has no next one, the first one after it no previous one.
   * \param[in] across_fan for an edge given by its ends, the vertex to which the other
   * outer edge of the fan at its end leads */
  template <typename AcrossFan>
  void
  addBoundary(const std::vector<FrontEdge>& edges, AcrossFan across_fan)
  {
    const auto first = static_cast<FrontIndex>(edges_.size());
    for (const FrontEdge& e : edges)
      insert(e.from, e.to, e.apex);
    for (auto i = first; i < static_cast<FrontIndex>(edges_.size()); ++i) {
      const pcl::index_t from = edge(i).from, to = edge(i).to;
      const FrontIndex next = find(to, across_fan(from, to));
      if (next != FrontEdge::NONE)
        link(i, next);
    }
  }

  /** \brief Put a triangle on a front edge: (to, from, apex).
   * The two new edges take the place of the old one, as far as they do not cancel. */
  void
  advance(FrontIndex edge, pcl::index_t apex);

  /** \brief Add the three edges of a triangle that stands alone. */
  void
  addTriangle(const Triangle& triangle);

  const FrontEdge&
  operator[](FrontIndex edge) const
  {
    return edges_[static_cast<std::size_t>(edge)];
  }

  /** \brief Edges ever made; those made last have the highest numbers. */
  std::size_t
  size() const
  {
    return edges_.size();
  }

  /** \brief The edge of the front between two vertices, in this direction, or NONE. */
  FrontIndex
  find(pcl::index_t from, pcl::index_t to) const;

  /** \brief Calls use(edge) for every edge of the front that begins at a vertex. */
  template <typename Use>
  void
  forEdgesFrom(pcl::index_t vertex, Use use) const
  {
    for (FrontIndex i = firstAt(vertex); i != FrontEdge::NONE;
         i = (*this)[i].next_there)
      use(i);
  }

  bool
  contains(pcl::index_t vertex) const
  {
    return firstAt(vertex) != FrontEdge::NONE;
  }

private:
  FrontEdge&
  edge(FrontIndex i)
  {
    return edges_[static_cast<std::size_t>(i)];
  }

  FrontIndex
  firstAt(pcl::index_t vertex) const
  {
    return first_at_[static_cast<std::size_t>(vertex)];
  }

  FrontIndex
  insert(pcl::index_t from, pcl::index_t to, pcl::index_t apex);
  void
  remove(FrontIndex i);
  void
  link(FrontIndex before, FrontIndex after);
  void
  cancelWithOpposite(FrontIndex i);

  std::vector<FrontEdge> edges_;
  std::vector<FrontIndex> first_at_;
};

} // namespace pcl::ccaa
