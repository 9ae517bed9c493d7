// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: connected patches of random shape that are taken away.
#pragma once

#include <pcl/PolygonMesh.h>
#include <pcl/types.h>

#include "damage_regions.h"

#include <memory>

namespace app {

/** \brief Which points are next to which: the ends of the edges of a mesh, or, where
 * there are no polygons, the nearest points of a cloud. */
class PointNeighbors {
public:
  virtual ~PointNeighbors() = default;

  /** \brief The neighbours of a point; not the point itself. */
  virtual void
  collect(std::size_t point_index, pcl::Indices& neighbors) = 0;

  /** \brief Whether a patch may begin here: the point is on the surface. */
  virtual bool
  canStart(std::size_t point_index) const = 0;
};

/** \brief Neighbours by the edges of \a mesh, or the 8 nearest points without polygons.
 */
std::unique_ptr<PointNeighbors>
makeNeighbors(const pcl::PolygonMesh& mesh, const Points& points);

/** \brief Grow one patch of \a size points from a random point that is not removed yet,
 * by one random neighbour of the patch after the other, and mark it removed.
 * \return points in the patch; fewer than \a size where the surface ends. */
std::size_t
growPatch(PointNeighbors& neighbors,
          std::size_t size,
          RandomNumbers& random,
          std::vector<char>& removed);

/** \brief Mean distance from a point to its nearest neighbour at another place, over a
 * sample of at most 20 000 points; 0 for a cloud without two places. */
double
meanSpacing(const Points& points);

} // namespace app
