// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: stumps of one limb, by the samples between them.

#pragma once

#include "listing/hole_list.h"

#include <vector>

namespace pcl::repair {

/** \brief Pairs of loops of different islands of a body that free points link, each
 * pair as one hole: the ring between them, cut open over the shortest way. However long
 * the gap is, what was measured in it goes from one to the other. None where bridges
 * lead elsewhere, or the gap is short enough for them. \param[in] longest gap */
std::vector<OpenHole>
ringsOverSamples(const ModelSurvey& survey, double longest);

} // namespace pcl::repair
