// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a surface to which triangles are added one by one.
#pragma once

#include "advancing_front/front.h"
#include "advancing_front/open_surface.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief The rim and all triangles made so far, with the front between them and what
 * is missing. Every triangle is on the side of its neighbors: an edge has at most two
 * triangles, which run through it in opposite directions. */
class GrowingSurface {
public:
  static constexpr std::int32_t NO_TRIANGLE = -1;

  explicit GrowingSurface(const OpenSurface& open);

  /** \brief Put a triangle on a front edge. All its edges must be free to take one. */
  void
  advance(FrontIndex edge, pcl::index_t apex);

  /** \brief Begin anew with a triangle whose corners have none. */
  void
  addTriangle(const Triangle& triangle);

  const Position&
  position(pcl::index_t vertex) const
  {
    return positions_[static_cast<std::size_t>(vertex)];
  }

  const Front&
  front() const
  {
    return front_;
  }

  /** \brief The rim, then the triangles made, in the order in which they were made. */
  const Triangles&
  triangles() const
  {
    return triangles_;
  }

  bool
  hasTriangles(pcl::index_t vertex) const
  {
    return head_[static_cast<std::size_t>(vertex)] != NO_TRIANGLE;
  }

  /** \brief Whether a vertex can still take triangles. */
  bool
  isOpen(pcl::index_t vertex) const
  {
    return !hasTriangles(vertex) || front_.contains(vertex);
  }

  /** \brief Sum of the unit normals of the triangles at a vertex, each times its angle
   * there. */
  const Position&
  normalSum(pcl::index_t vertex) const
  {
    return normal_sums_[static_cast<std::size_t>(vertex)];
  }

  /** \brief Calls use(triangle index) for all triangles at a vertex. */
  template <typename Use>
  void
  forTrianglesAt(pcl::index_t vertex, Use use) const
  {
    std::int32_t place = head_[static_cast<std::size_t>(vertex)];
    while (place != NO_TRIANGLE) {
      use(static_cast<pcl::index_t>(place / 3));
      place = following_[static_cast<std::size_t>(place)];
    }
  }

  /** \brief Whether an edge may take a triangle that runs through it from \a from to
   * \a to: it is new, or the front holds it the other way round. */
  bool
  takesEdge(pcl::index_t from, pcl::index_t to) const
  {
    return front_.find(to, from) != FrontEdge::NONE || !hasEdge(from, to);
  }

  /** \brief Whether some triangle has this edge, in whatever direction. */
  bool
  hasEdge(pcl::index_t one, pcl::index_t other) const;

private:
  pcl::index_t
  endOfFan(pcl::index_t from, pcl::index_t at) const;
  void
  record(const Triangle& triangle);

  const Positions& positions_;
  Triangles triangles_;
  std::vector<std::int32_t> head_; /**< of a vertex: its latest corner */
  std::vector<std::int32_t>
      following_; /**< of a corner: the one before at its vertex */
  std::vector<Position> normal_sums_;
  Front front_;
};

} // namespace pcl::ccaa
