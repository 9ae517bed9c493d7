// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an inspection layer as VTK draws it.
#pragma once

#include <Eigen/Core>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "common/inspection.h"

#include <vector>

namespace app {

/** \brief The lines and faces of a layer, or a dot a point where it has neither, with a
 * colour a point. */
vtkSmartPointer<vtkPolyData>
makePart(const InspectionLayer& layer);

std::vector<Eigen::Vector3d>
positionsOf(const InspectionLayer& layer);

} // namespace app
