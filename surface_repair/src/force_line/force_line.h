// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a force line of the indicator field (4.41).

#pragma once

#include "boundary/boundary_loop.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief How the tracking of a force line ended. */
enum class LineEnd : std::uint8_t {
  BRIDGE,          /**< at another boundary: the line can become a bridge */
  REPELLED,        /**< the force at the origin points back over its own island */
  NO_FIELD,        /**< no source within reach, or their forces cancel out */
  OUT_OF_REACH,    /**< the line left the L_2 region of its targets */
  TOO_LONG,        /**< longer than a bridge over the gap could be */
  CROSSES_SURFACE, /**< the line ran through the surface */
  WRONG_SIDE       /**< it came to the inner side of the other boundary */
};

/** \brief Number of these. */
constexpr std::size_t LINE_ENDS = 7;

/** \brief A sentence part for messages and reports, such as "repelled at its origin".
 */
const char*
describe(LineEnd end);

/** \brief A point on a boundary: where a line begins or ends. */
struct BoundaryPoint {
  std::size_t curve = NONE; /**< index of the source curve */
  std::size_t edge = 0;     /**< edge of the boundary curve */
  double share = 0.0;       /**< along that edge, 0 to 1 */
  Position position = Position::Zero();
};

/** \brief A traced line with the surface's normal along it. */
struct ForceLine {
  LineEnd end = LineEnd::NO_FIELD;
  BoundaryPoint origin;
  BoundaryPoint target;         /**< only of a BRIDGE */
  Positions points;             /**< from the origin to the target, both included */
  Directions normals;           /**< external, unit, perpendicular to the line */
  std::vector<double> tensions; /**< |f| at the points */
  double length = 0.0;
  double quality = 0.0; /**< mean |f| along the line (4.41) */
};

/** \brief Turn the inner normals of a line across it (its direction at a point is that
 * of the chord of the neighbours) and bring them to unit length. One along the line
 * stays as it is. */
void
bringNormalsAcross(ForceLine& line);

} // namespace pcl::repair
