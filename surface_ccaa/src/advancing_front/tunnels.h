// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tunnels that a start algorithm made through thin places.
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/reconstruction_report.h>

#include "advancing_front/handle_opening.h"
#include "advancing_front/surface_completion.h"
#include "mesh/block_loop.h"

#include <cstdint>

namespace pcl::ccaa {

/** \brief Where a completed mesh has handles, and edges whose ends face away from each
 * other (normals more than 107 degrees apart), as at the tip of a blade, or a handle
 * that lies within four edges (see thinNecks()), grow it anew (openNarrowPlaces()).
 *
 * What comes out is taken if it has fewer flaws, handles and more pieces than one (both
 * counted twice), openings and free points, and no more handles. So true handles stay,
 * and where the sampling does not tell the sides apart nothing changes. Cost: nothing
 * for a result of genus 0; else that of looking for thin places, some 0.3 us a
 * triangle, and where there are any of reading the surface twice and more, some 1 us a
 * triangle, and of what grows around them.
 *
 * Then tell thin necks, clefts and pieces that touch (findNecks()).
 *
 * Handles that are left are in doubt (report.doubts.handles) if the result, or what
 * was given, has thin places or small handles, or if they pass through clefts (see
 * cleftVertices()): no sampling tells there whether the two sides are connected. Those
 * that handles pass through are told (report.doubts.thin_handles). \param[in] mesh
 * consistently wound \param[in] work of complete() \param[in,out] result of complete()
 * of all that is given, with its report */
void
openTunnels(PartialMesh mesh,
            const CompletionAgain& complete,
            std::uint64_t work,
            const LoopContext& context,
            CompletedMesh& result,
            CompletionReport& report);

} // namespace pcl::ccaa
