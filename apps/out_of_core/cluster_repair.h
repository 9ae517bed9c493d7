// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the surface around some holes as a mesh of its own,
// repaired.
#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "out_of_core/hole_gathering.h"
#include "out_of_core/tile_steps.h"

namespace app {

/** \brief Repair a cluster, and add what is new to its tile. Loops that run where what
 * is known ends stay as they are. Left out are the new triangles of islands that would
 * have to be turned against each other, or of which one has a corner where another
 * cluster may have some (HoleGathering::mayHold()). Throws a Failure when it is
 * stopped. */
void
repairCluster(const TilePlan& plan,
              const HoleGathering& gathering,
              const HoleCluster& cluster,
              const pcl::repair::RepairParameters& method,
              const StepRun& run,
              RepairedTile& tile);

} // namespace app
