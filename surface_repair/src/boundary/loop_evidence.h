// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what speaks for a hole and what for a rim.

#pragma once

#include "boundary/classification.h"

#include <vector>

namespace pcl::repair {

/** \brief The evidence for each loop of a model; of no use after cancelling. */
std::vector<LoopEvidence>
collectEvidence(const IncompleteModel& model,
                const BoundaryLoops& loops,
                const ccaa::LoopContext& context);

/** \brief Turns to the right, in full turns, while the loop is walked: the sum of what
 * the angles of the triangles at each point lack to pi (discrete geodesic curvature),
 * over -2 pi. Where the loop is pinched, the turn of its edges. */
double
turningOf(const IncompleteModel& model, const BoundaryLoop& loop);

/** \brief The same for any closed curve, by its own tangents and normals. */
double
turningOf(const BoundaryCurve& curve);

/** \brief The evidence for a curve that bounds a surface of so much area, other
 * boundaries closed: of D, turning and area only. */
LoopEvidence
evidenceOf(const BoundaryCurve& curve, double area);

/** \brief Whether a hole may be the stump of a limb that goes on elsewhere: a hole in a
 * surface has a D of its length and turns once, the mouth of a tube has none of both.
 */
bool
mayBeStump(const LoopEvidence& evidence);

/** \brief Whether a loop is the mouth of a tube for sure: D, in its length, and turning
 * are nearly none. */
bool
isMouth(const LoopEvidence& evidence);

/** \brief Between which the least surface that closes a curve has its area. */
struct AreaBounds {
  double lower = 0.0; /**< length of the vector area */
  double upper = 0.0; /**< of the cone from the centroid, or of the disc with this
                           circumference where that is less */
};

AreaBounds
leastSurface(const BoundaryCurve& curve);

} // namespace pcl::repair
