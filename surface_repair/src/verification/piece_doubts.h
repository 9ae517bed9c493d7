// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pieces of a result that may belong together.

#pragma once

#include <pcl/surface_repair/repair_report.h>

#include "survey/model_survey.h"
#include "verification/repaired_model.h"

#include <vector>

namespace pcl::repair {

/** \brief Closed pieces that touch each other (ccaa::pieceContacts()), one of them
 * partly new; then those of which islands were joined around a bend (carriesHandle()),
 * and which lie, with what is new of them, within half their extent of what is new of a
 * larger closed one: tips of fingers may have been joined to each other in place of to
 * the hand. The latter not where the user has decided what is joined. Cost: linear, and
 * n log n in what is new. */
std::vector<RepairDoubt>
doubtfulPieces(const RepairedModel& repaired,
               const RepairReport& report,
               const SurveyParameters& parameters);

} // namespace pcl::repair
