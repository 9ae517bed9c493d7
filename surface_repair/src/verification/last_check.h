// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the proof that what is written is a manifold.

#pragma once

#include <pcl/surface_repair/repair_report.h>

#include "mesh/block_loop.h"
#include "verification/repaired_model.h"

namespace pcl::repair {

/** \brief Prove that a repaired model is a manifold whose triangles are wound alike, by
 * the numbers of its vertices; on one-sided islands those of the input need not be.
 *
 * Each patch has been tested before; here only the adjacency is believed. Where the
 * proof fails the patches of the holes in question are taken back, the holes are left
 * open (NOT_MANIFOLD) and count as shortfalls, and the rest is proved again: one hole
 * at each place, that which was closed last. Triangles of the input are never taken;
 * where they alone are at fault, fans get vertices of their own. Cost: linear, about
 * 0.3 us a triangle. \param[in,out] repaired of whose model positions, points,
 * triangles and adjacency are up to date, and afterwards the pieces that triangles are
 * of (island_of) \param[in,out] report of holes, shortfalls and triangles, and `after`
 * \return false where all that did not help, and after cancelling */
bool
proveManifold(const ccaa::LoopContext& context,
              RepairedModel& repaired,
              RepairReport& report);

} // namespace pcl::repair
