// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds in PCL's own format and as text.
#pragma once

#include "model.h"
#include "output_file.h"

namespace app {

/** \brief Binary PCD with all fields, sizes, the viewpoint and the remarks. */
void
writePcd(const pcl::PCLPointCloud2& cloud, const FileExtras& extras, OutputFile& file);

/** \brief One line of numbers per point, under a comment line with their names, by
 * which readXyz() knows them again. */
void
writeXyz(const pcl::PCLPointCloud2& cloud, const Remarks& remarks, OutputFile& file);

} // namespace app
