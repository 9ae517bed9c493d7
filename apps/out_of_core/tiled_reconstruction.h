// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pcl_ccaa_reconstruct --tiles.
#pragma once

#include "cli/cli.h"
#include "cli/reconstruct_run.h"

namespace app {

/** \brief Mesh all inputs as one cloud tile by tile, and write the shards, the merged
 * mesh and the report as far as they are wanted. Without a folder for tiles that stays
 * there is one beside the output as long as the run lasts. */
Outcome
reconstructInTiles(const ReconstructSettings& settings);

} // namespace app
