// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tunnels that a start algorithm made through thin places.
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/reconstruction_report.h>

#include "advancing_front/surface_completion.h"
#include "mesh/block_loop.h"

#include <functional>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief Triangles at thin places, such as the tip of a blade: up to ten rings around
 * edges whose ends face away from each other (normals more than 107 degrees apart).
 *
 * There a start algorithm may connect two sides through the body. Such a tunnel has a
 * perfect umbrella at each point, and its edges are no sharper than those in which the
 * body ends: nothing here tells the one from the other. Cost: some 0.3 us a triangle.
 * \param[in] triangles consistently wound
 * \return ascending; nothing of use after cancelling */
std::vector<pcl::index_t>
trianglesAtThinPlaces(const Triangles& triangles,
                      const PointView& points,
                      int rings,
                      const LoopContext& context);

/** \brief Completes a mesh without some more of its given triangles. */
using CompletionWithout = std::function<CompletedMesh(
    const std::vector<pcl::index_t>& more_doubts, CompletionReport& report)>;

/** \brief Where a completed mesh has handles, and two sides of the body come near to
 * each other, grow these places anew.
 *
 * What comes out is taken if it has fewer flaws: handles (counted twice), openings and
 * free points. So true handles stay, and where the sampling does not tell the sides
 * apart nothing changes. Cost: nothing for a result of genus 0; else that of looking
 * for thin places, and of a second completion where there are any.
 * \param[in,out] result of complete() without more doubts, with its report */
void
openTunnels(const PartialMesh& mesh,
            const CompletionWithout& complete,
            const LoopContext& context,
            CompletedMesh& result,
            CompletionReport& report);

} // namespace ccaa
} // namespace pcl
