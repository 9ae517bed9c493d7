// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where another topology is as likely as the repaired one.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "verification/repaired_model.h"

#include <vector>

namespace pcl::repair {

/** \brief Judge the finished model by its new triangles, whatever way they came about.
 *
 * TUNNEL: two caps of areas A, B on opposite sides of a piece, with rims of lengths L,
 * M and a distance h between them: (L + M) / 2 h, the area of a tube between the rims,
 * is at most 1.25 (A + B). Crumbs within a cap are part of it. None where the user does
 * not want the two joined.
 *
 * LONG_GAP: a junction is joined although its log odds are low, since the mouth of a
 * tube has no other partner (joinLoneStumps()), or are at most 0.2 above what joins; or
 * it joins an island to itself and does not surely carry a handle
 * (surelyCarriesHandle()), and the result has some. None where the user wants the two
 * joined. Or a crumb lies farther from the rim of the patch that took it in than 0.3 of
 * its length.
 *
 * PARTED: a junction is joined by its evidence, but its two boundaries are in different
 * pieces. None where the user decides about junctions, or limits bridges.
 *
 * UNJOINED: the mouths of two tubes lack at most 1 in log odds to be joined, and
 * neither is joined to another loop, none where the user does not want the two joined;
 * or two closed pieces touch (ccaa::pieceContacts()), one of them with new triangles.
 *
 * UNSUPPORTED, of a body (isSeenFromAllSides()) or what is closed now: those of
 * COMPLETION have measured corners, samples support what joins stumps over them, and a
 * flat patch is where something stood. Nothing supports the others within one loop, nor
 * rings over lost bridges, and those between loops are supported by the junctions: w =
 * (0.75 - c) / 0.25, at least 0 and at most 1, of their area counts as unsupported,
 * where c is the confidence of the weakest junction that is joined. The doubt: it is
 * more than RepairParameters::greatest_unsupported of the whole area, or than a quarter
 * of that where the surface has handles: it may have lost another. CloseChoice::ALL
 * asks for it, and gives none.
 *
 * Cost: n log n in the new triangles and linear in all.
 * \param[in] repaired with its adjacency
 * \param[in] report of its holes and junctions
 * \return tunnels by their points, ascending, then long gaps, parted and unjoined
 * loops by theirs, UNSUPPORTED */
std::vector<RepairDoubt>
doubtsAbout(const RepairedModel& repaired,
            const RepairReport& report,
            const RepairParameters& parameters);

} // namespace pcl::repair
