// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the normal that a force line has at a point (4.44).

#pragma once

#include "field/indicator_field.h"

namespace pcl::repair {

/** \brief The normal n in the plane across p that the field answers most to. */
struct FieldNormal {
  Direction normal;       /**< unit; its sign is open: -n gives the opposite force */
  double tension = 0.0;   /**< |H n| */
  double clearness = 0.0; /**< 1 - (lesser / greater |H n| over the plane), 0 to 1: near
                               0 the normal is not determined (4.44) */
};

/** \brief Solve max |H n|, |n| = 1, n . p = 0 (4.44-1) in closed form: the symmetric
 * 2 x 2 eigenproblem of (H E)^T (H E) in a basis E of the plane across p.
 * \param[in] across p, unit
 * \return tension 0 where the field is zero on the whole plane; then any normal */
FieldNormal
searchNormal(const Tension& tension, const Direction& across);

/** \brief The force on an origin, before any line is traced. */
struct OriginForce {
  Direction normal = Direction::Zero(); /**< of the line there, on the island's side */
  Eigen::Vector3d force = Eigen::Vector3d::Zero(); /**< f = H n */
  double outward = 0.0; /**< f . m: above 0 the origin is attracted, else repelled */
};

/** \brief Answer 4.44-1a where a line may begin: n across tau with n . n_island > 0.
 * \param[in] tangent tau of the boundary, positive direction
 * \param[in] normal external normal of the island, perpendicular to tau */
OriginForce
forceAtOrigin(const Direction& tangent,
              const Direction& normal,
              const Tension& tension);

} // namespace pcl::repair
