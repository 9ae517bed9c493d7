// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds in PCL's own format and as text.
#pragma once

#include "model.h"
#include "output_file.h"

namespace app {

/** \brief Binary PCD with all fields, sizes and the viewpoint. */
void
writePcd(const pcl::PCLPointCloud2& cloud,
         const Viewpoint& viewpoint,
         OutputFile& file);

/** \brief One line of numbers per point, under a comment line with their names, by
 * which readXyz() knows them again. */
void
writeXyz(const pcl::PCLPointCloud2& cloud, OutputFile& file);

} // namespace app
