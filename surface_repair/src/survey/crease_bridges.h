// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: sharp edges of islands that go on in those of others.

#pragma once

#include "survey/model_survey.h"

#include <vector>

namespace pcl::repair {

/** \brief Bridges that carry a crease of one island on to that of another, where their
 * junction is joined: from end to end, in their directions, like an arc where both turn
 * alike. Each end has one bridge, the shortest whose frames agree best.
 * \param[in] boundaries of the survey's joined loops, one a curve
 * \param[in,out] surface_ends of the survey's model
 * \return with `is_crease`, supported by vertices; none that crosses the surface */
std::vector<Bridge>
creaseBridges(const ModelSurvey& survey,
              const BoundaryEdges& boundaries,
              SurfaceEnds& surface_ends);

} // namespace pcl::repair
