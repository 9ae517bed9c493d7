// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which holes meet, and so have vertices in common and are
// closed together.

#pragma once

#include "listing/hole_list.h"

namespace pcl::repair {

/** \brief Let holes that meet in a point have one vertex there: pinched vertices, and
 * the ends of bridges without a length. \param[in,out] list of which polygons and
 * `replaced` are brought up to date */
void
weldHoles(const ModelSurvey& survey, HoleList& list);

/** \brief Group the holes to be closed into regions: those that a bridge connects, or
 * that meet twice, are closed together. \param[in,out] list of welded holes */
void
groupHoles(HoleList& list);

} // namespace pcl::repair
