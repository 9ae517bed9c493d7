// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which side of an island is outside (4.48).

#pragma once

#include <pcl/surface_repair/model_findings.h>
#include <pcl/surface_repair/repair_parameters.h>

#include "field/indicator_field.h"
#include "icadm/incomplete_model.h"
#include "mesh/block_loop.h"
#include "mesh/orientation.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief Find the outer side of every island. Changes nothing: see turnIslands().
 * \param[in] room L_2 in gaps to the next island */
std::vector<IslandSide>
orientIslands(const IncompleteModel& model,
              const BoundaryLoops& loops,
              const OrientationParameters& parameters,
              double room,
              const ccaa::LoopContext& context);

/** \brief Wind the islands that are flipped the other way round; their normals follow.
 * Boundary loops have to be extracted anew. */
void
turnIslands(IncompleteModel& model, const std::vector<IslandSide>& sides);

} // namespace pcl::repair
