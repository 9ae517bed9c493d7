// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: why a loop that no bridge touches is not to be closed.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "survey/model_survey.h"

#include <cstddef>

namespace pcl::repair {

/** \brief Whether a loop that stays open for this reason might not, if it were joined
 * to another one. */
inline bool
couldBeJoined(OpenReason reason)
{
  return reason == OpenReason::NOT_JOINED || reason == OpenReason::UNDECIDED;
}

/** \brief What the user decided about a loop, else what the choice for all loops makes
 * of its class. NONE: it is to be closed. */
OpenReason
reasonForLoop(const ModelSurvey& survey, CloseChoice choice, std::size_t loop);

} // namespace pcl::repair
