// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a triangle must pass before it joins a surface.
#pragma once

#include "advancing_front/growing_surface.h"
#include "advancing_front/nearby_triangles.h"
#include "advancing_front/open_surface.h"
#include "mesh/box_tree.h"
#include "mesh/intersection.h"

#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief Tests of a triangle against the samples and against the surface around it.
 * Keeps marks between calls, so one object serves one thread. */
class TriangleTrial {
public:
  /** \param[in] open with complete spacings
   * \param[in] support see CompletionParameters
   * \param[in] nearby what else must not be crossed, or null */
  TriangleTrial(const OpenSurface& open,
                const GrowingSurface& surface,
                double support,
                const NearbyTriangles* nearby);

  /** \brief Distance between samples around an open point, see completeSpacings(). */
  double
  spacing(pcl::index_t vertex) const
  {
    return open_.spacings[static_cast<std::size_t>(vertex)];
  }

  /** \brief See PartialSurface::setLargestRoom(). */
  double
  largestRoom() const
  {
    return open_.largest_room;
  }

  /** \brief Whether a vertex is one of the open points; only these take triangles. */
  bool
  isOpenPoint(pcl::index_t vertex) const
  {
    return static_cast<std::size_t>(vertex) < open_.open_points;
  }

  /** \brief Whether the samples on a front edge are close enough to each other to
   * support a triangle that spans to an apex: its circumradius, or its new edges, are
   * short against the spacing. A triangle without new edges always is supported.
   * \param[in] radius the circumradius */
  bool
  isSupported(const FrontEdge& edge, pcl::index_t apex, double radius) const;

  /** \brief The same for a triangle that stands alone. */
  bool
  isSupported(const Triangle& triangle) const;

  /** \brief The same with the densest sampling of the three corners: what an outlier
   * and two points of a surface form does not pass. */
  bool
  isSupportedByAll(const Triangle& triangle) const;

  /** \brief Whether a triangle meets the surface elsewhere than in common corners and
   * edges, or has no area. Exact. Tested are the triangles up to the neighbors of its
   * corners and what is nearby. */
  bool
  crossesSurface(const Triangle& triangle);

  Corners
  cornersOf(const Triangle& triangle) const
  {
    return {surface_.position(triangle[0]),
            surface_.position(triangle[1]),
            surface_.position(triangle[2])};
  }

private:
  bool
  isSupported(const Triangle& triangle, double spacing_there, double radius) const;
  double
  circumradius(const Triangle& triangle) const;
  bool
  isShort(pcl::index_t a, pcl::index_t b, double radius) const;
  void
  noteBoxes();
  bool
  meets(const Corners& corners, const Box& box, pcl::index_t triangle);
  bool
  meetsAt(const Corners& corners, const Box& box, pcl::index_t vertex);

  const OpenSurface& open_;
  const GrowingSurface& surface_;
  double support_;
  const NearbyTriangles* nearby_;
  std::vector<Box> boxes_;           /**< of the triangles of the surface */
  std::vector<Box> around_;          /**< of a vertex: around its triangles */
  std::vector<std::uint32_t> seen_;  /**< of a triangle: the last call that met it */
  std::vector<std::uint32_t> asked_; /**< of a vertex, likewise */
  std::uint32_t call_ = 0;
};

} // namespace pcl::ccaa
