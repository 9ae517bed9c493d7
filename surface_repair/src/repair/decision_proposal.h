// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a repair would decide, for a user to change.

#pragma once

#include <pcl/surface_repair/decisions.h>
#include <pcl/surface_repair/repair_parameters.h>

#include "survey/model_survey.h"

namespace pcl::repair {

/** \brief What ForceLineHoleRepair would do about the boundary loops of a mesh and the
 * junctions between them, as decisions. Given back as they are they change nothing.
 *
 * A loop that is to be joined to others, or of which it is not clear what it is, is
 * AUTO: closing or leaving it open is for the user to say. \code
 * auto decisions = std::make_shared<pcl::repair::Decisions>(
 *     pcl::repair::proposeDecisions(survey, parameters));
 * decisions->loops[0].wish = pcl::repair::LoopWish::LEAVE_OPEN;
 * repair.setDecisions(decisions);
 * \endcode
 * \param[in] survey of a mesh by surveyModel(), with the survey parameters among these,
 * bridges between islands included */
Decisions
proposeDecisions(const ModelSurvey& survey, const RepairParameters& parameters);

} // namespace pcl::repair
