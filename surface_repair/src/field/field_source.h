// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the elementary sources of the indicator field (4.43, 4.46).

#pragma once

#include "boundary/boundary_loop.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief One elementary source {O, n, tau, h} (4.43). */
struct FieldSource {
  Position position;  /**< O */
  Direction tangent;  /**< tau, unit, positive direction */
  Direction normal;   /**< n, unit, external, perpendicular to tau */
  double charge = 1.; /**< h: the length of boundary it stands for, relative to the mean
                           source spacing, so that linear density is equal everywhere */
  double arc = 0.;    /**< arc length from the first point of its curve */
};

/** \brief The sources of one boundary, in the order of the boundary. */
struct SourceCurve {
  std::size_t island = NONE;
  std::size_t loop = NONE;
  double length = 0.0;  /**< of the boundary */
  double spacing = 0.0; /**< arc length between its sources */
  std::vector<FieldSource> sources;
};

/** \brief Sources of several boundaries. */
struct SourceSet {
  std::vector<SourceCurve> curves;
  double spacing = 0.0; /**< mean over all sources: what charge 1 stands for */

  std::size_t
  size() const;
};

} // namespace pcl::repair
