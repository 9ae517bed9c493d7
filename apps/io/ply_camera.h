// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the sensor's place in PLY files, as PCL writes it.
#pragma once

#include "model.h"
#include "output_file.h"

#include <map>
#include <string>

namespace app {

/** \brief Take the place and the axes of a sensor from the numbers of an element
 * "camera". PCL's size of its picture is that of an organised cloud. */
void
takeCamera(std::map<std::string, double>& numbers, Model& model);

/** \brief The element in the header of a file. */
void
announceCamera(const Viewpoint& viewpoint, OutputFile& file);

/** \brief Its numbers, behind those of the points of \a cloud. */
void
writeCamera(const Viewpoint& viewpoint,
            const pcl::PCLPointCloud2& cloud,
            OutputFile& file);

} // namespace app
