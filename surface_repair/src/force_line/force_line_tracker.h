// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tracing force lines through the indicator field
// (4.41, 4.44).

#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "field/indicator_field.h"
#include "force_line/boundary_edges.h"
#include "force_line/force_line.h"
#include "mesh/block_loop.h"

#include <vector>

namespace pcl::repair {

class Shield;

/** \brief Where a line is to begin, and what the field is asked along it. */
struct LineOrigin {
  BoundaryPoint point;
  Direction tangent; /**< tau of the boundary, positive direction */
  Direction normal;  /**< external normal of the island, perpendicular to tau */
  FieldQuery query; /**< L_1, L_2, chi and the charges; its position is not looked at */
  double room = DEFAULT_ROOM; /**< gaps left that L_2 spans at most, along the line */
};

/** \brief Traces lines dX/dl = f / |f|, f = H n, where n answers 4.44-1 at each point.
 *
 * Since the plane allowed for n depends on the direction of the line, and that on n,
 * both are found together at each point, which needs the tension there only once. Then
 * the direction depends on the place alone, and an embedded Runge-Kutta method of third
 * order (Bogacki and Shampine 1989) chooses the steps.
 *
 * What the tracker looks at must outlive it. Const methods may be called from several
 * threads.
 */
class ForceLineTracker {
public:
  /** \brief \param[in] field its source curves are those of \a targets, in their order
   * \param[in] obstacle lines may not run through it; null: they may */
  ForceLineTracker(const IndicatorField& field,
                   const BoundaryEdges& targets,
                   const TrackerParameters& parameters,
                   const Shield* obstacle = nullptr);

  /** \brief Trace one line. A line that is no bridge is given as far as it went. Cost:
   * some 20 to 40 evaluations of the field. */
  ForceLine
  track(const LineOrigin& origin) const;

  /** \brief Trace many, in parallel. */
  std::vector<ForceLine>
  track(const std::vector<LineOrigin>& origins, const ccaa::LoopContext& context) const;

private:
  const IndicatorField& field_;
  const BoundaryEdges& targets_;
  TrackerParameters parameters_;
  const Shield* obstacle_;
};

/** \brief The same line with points at equal distances of about \a spacing, on a cubic
 * through its points and directions; normals are interpolated and brought across the
 * line. Ends stay where they are. */
ForceLine
resampled(const ForceLine& line, double spacing);

} // namespace pcl::repair
