// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what was filled anew becomes the model of a repair.

#pragma once

#include "pass/passes.h"
#include "patch/growing_surface.h"

namespace pcl::repair {

/** \brief The surface is what survey and report are about from now on. */
void
takeOver(GrowingSurface surface, const Course& course);

} // namespace pcl::repair
