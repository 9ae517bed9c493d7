// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tunnels that a start algorithm made through thin places.
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/reconstruction_report.h>

#include "advancing_front/surface_completion.h"
#include "mesh/block_loop.h"

#include <functional>
#include <vector>

namespace pcl::ccaa {

/** \brief Completes a mesh without some more of its given triangles. */
using CompletionWithout = std::function<CompletedMesh(
    const std::vector<pcl::index_t>& more_doubts, CompletionReport& report)>;

/** \brief Where a completed mesh has handles, and edges whose ends face away from each
 * other (normals more than 107 degrees apart), as at the tip of a blade, grow up to
 * twenty rings around these anew.
 *
 * What comes out is taken if it has fewer flaws: handles (counted twice), openings and
 * free points. So true handles stay, and where the sampling does not tell the sides
 * apart nothing changes. Cost: nothing for a result of genus 0; else that of looking
 * for thin places, some 0.3 us a triangle, and of one or two more completions where
 * there are any.
 *
 * Handles that are left are in doubt (report.doubtful_handles) if the result or what
 * was given has thin places: no sampling tells there whether the two sides are
 * connected. Of nine closed models three have some, and come out with wrong handles;
 * those with the right ones have none. \param[in] mesh consistently wound
 * \param[in,out] result of complete() without more doubts, with its report */
void
openTunnels(const PartialMesh& mesh,
            const CompletionWithout& complete,
            const LoopContext& context,
            CompletedMesh& result,
            CompletionReport& report);

} // namespace pcl::ccaa
