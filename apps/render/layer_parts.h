// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an inspection layer as VTK draws it.
#pragma once

#include <Eigen/Core>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "inspect/inspection.h"

#include <vector>

namespace app {

/** \brief The lines and faces of a layer, or a dot a point where it has neither, with a
 * colour a point. */
vtkSmartPointer<vtkPolyData>
makePart(const InspectionLayer& layer);

/** \brief Red, green and blue of each point from the field rgb or rgba; empty without
 * it.
 */
vtkSmartPointer<vtkUnsignedCharArray>
makeColors(const pcl::PCLPointCloud2& cloud);

std::vector<Eigen::Vector3d>
positionsOf(const InspectionLayer& layer);

} // namespace app
