// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points in which islands touch.

#pragma once

#include "survey/model_survey.h"

#include <vector>

namespace pcl::repair {

/** \brief Bridges without a length, from the vertex of one boundary to that of another
 * one at the same point of the cloud: there the islands meet already, and the gap
 * between them is divided. None where the boundaries run along the same edge (a seam),
 * where the islands show different sides, and where users keep them apart.
 * \param[in] boundaries of the loops that survey.joined lists */
std::vector<Bridge>
touchingBridges(const ModelSurvey& survey, const BoundaryEdges& boundaries);

} // namespace pcl::repair
