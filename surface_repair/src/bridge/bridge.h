// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a bridge between two supporting points (4.32).

#pragma once

#include "force_line/boundary_edges.h"
#include "force_line/force_line.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A curve that connects two boundary points of A, with the external normal
 * along it (D4.32-1). An overlay: it is no part of the mesh until a hole beside it is
 * filled. */
struct Bridge {
  BoundaryPoint begin;    /**< supporting point at points.front() */
  BoundaryPoint end;      /**< supporting point at points.back() */
  Positions points;       /**< at least two */
  Directions normals;     /**< unit, one a point */
  double quality = 0.0;   /**< mean tension (4.41) */
  bool is_crease = false; /**< the surface along it is creased, and runs through it */
};

/** \brief The bridge along a force line that reached another boundary. */
Bridge
bridgeAlong(const ForceLine& line);

/** \brief The bridge with its ends moved to the nearest vertices of the boundaries:
 * triangles of A are never split. Its other points go along, the less the further away
 * they are. */
Bridge
supportedByVertices(Bridge bridge, const BoundaryEdges& boundaries);

/** \brief How near supporting points of a boundary may be to each other (C4.47-2). A
 * boundary that is too short for six of them gets a sixth of its length. */
struct SupportSpacing {
  double share = 1.0; /**< least arc length, in lengths of the line that asks */
  double least = 0.0; /**< least arc length in any case, units of the cloud, above 0 */
};

/** \brief Choose bridges among force lines, supported by vertices: those that reached a
 * boundary, the best first, each with room on both of its boundaries. The best has the
 * highest quality by the square of its length: |f| grows with L_2, and L_2 with the
 * gap, so that quality alone would prefer wide gaps. Equal ones go by index.
 *
 * A boundary that gets less than three that way may have more, nearer to their
 * neighbours, down to `least`: bridges of others may have taken the places that its
 * lines reach, and with one bridge alone it would lose it (C4.47-3).
 * \param[in] boundaries the curves that the lines' ends refer to
 * \param[in] given bridges that there are already: they have taken their places, and
 * are not among what is returned */
std::vector<Bridge>
selectBridges(const std::vector<ForceLine>& lines,
              const BoundaryEdges& boundaries,
              const SupportSpacing& spacing,
              const std::vector<Bridge>& given = {});

} // namespace pcl::repair
