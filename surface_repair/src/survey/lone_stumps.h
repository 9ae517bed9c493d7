// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: stumps of limbs that have one partner only.

#pragma once

#include "survey/model_survey.h"

namespace pcl::repair {

/** \brief In a body every mouth of a tube goes on somewhere, and every stump that is
 * the only boundary of its island. Two islands that are nothing but the ends of limbs,
 * side by side, do not go on in each other: that junction is DOUBTFUL. Where no
 * junction of such a boundary is sure, the one that is not far from it and much better
 * than all others is JOINED, too. \param[in,out] survey whose junctions were judged one
 * by one */
void
joinLoneStumps(const JunctionParameters& parameters, ModelSurvey& survey);

} // namespace pcl::repair
