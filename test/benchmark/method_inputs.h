// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds that tell methods of reconstruction apart.
#pragma once

#include "input_clouds.h"
#include "support/shapes.h"

#include <optional>
#include <string>
#include <vector>

namespace bench {

/** \brief A cloud and the surface that it was taken from. */
struct MethodInput {
  std::string name;
  Cloud::Ptr cloud;
  pcl::ccaa::test::Shape truth; /**< all of it, also what was not measured */
  pcl::ccaa::test::Shape seen;  /**< what a good result has; empty: all */
  std::optional<pcl::ccaa::Position> sensor;
  pcl::ccaa::Position view = pcl::ccaa::Position::UnitZ(); /**< pictures are taken from
                                                                there */
};

/** \brief Ten seeded ones of some 10 000 points each: clean, uneven, noise of 0.3 and
 * of 1.5 spacings, six scans that disagree, two sheets three spacings apart, sharp
 * edges, several objects seen from one place, large holes, outliers. */
std::vector<MethodInput>
makeMethodInputs();

} // namespace bench
