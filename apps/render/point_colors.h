// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: parts of a mesh with a colour for each point.
#pragma once

#include "render/drawing.h"
#include "render/mesh_parts.h"

namespace app {

/** \brief The faces, each connected component in a colour of its own. */
vtkSmartPointer<vtkPolyData>
colorComponents(const MeshParts& parts);

/** \brief From dark blue at 1, nearest to the camera, to light blue at 0. */
Color
colorOfNearness(double nearness);

/** \brief The free points, dark near the camera and light far from it. \a view is the
 * direction towards the camera. */
vtkSmartPointer<vtkPolyData>
colorByDepth(const MeshParts& parts, const Eigen::Vector3d& view);

/** \brief A part in the colours of its points, which must be there. */
vtkSmartPointer<vtkPolyData>
colorAsPoints(const MeshParts& parts, vtkPolyData& part);

/** \brief The faces, those in one colour that were there before, wound either way, and
 * those in another one that were not. */
vtkSmartPointer<vtkPolyData>
colorNewFaces(const MeshParts& parts);

} // namespace app
