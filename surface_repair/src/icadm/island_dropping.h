// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: leaves out islands that are too small to be wanted.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>

#include "icadm/model_reading.h"
#include "mesh/block_loop.h"

#include <cstddef>

namespace pcl::repair {

/** \brief Take small islands out of a model. Their points are neither vertices nor free
 * points of it any more: they draw nothing. What is dropped is counted in the report;
 * where nothing is left, that is its problem. Cost: that of assembleModel() where
 * anything is dropped. */
void
dropIslands(const SmallIslands& small,
            const ccaa::LoopContext& context,
            ReadModel& read);

} // namespace pcl::repair
