// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: meshes with holes that tell methods of filling apart.
#pragma once

#include "support/shapes.h"

#include <string>
#include <vector>

namespace bench {

/** \brief A damaged mesh and the surface that it was. */
struct HoleInput {
  std::string name;
  pcl::ccaa::test::Shape truth;
  pcl::ccaa::test::Shape damaged;
  pcl::ccaa::Position view; /**< pictures are taken from there */
};

/** \brief Seven of some 20 000 triangles each: many small holes, a large hole, a cube
 * without a corner, a hole around an island, a body in three pieces, a terrain whose
 * border is no hole, and two close shells. */
std::vector<HoleInput>
makeHoleInputs();

} // namespace bench
