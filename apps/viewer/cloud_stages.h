// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the viewer's stages from a cloud to a mesh.
#pragma once

#include "viewer/stages.h"

#include <vector>

namespace app {

/** \brief Cloud, start, filter and base.
 * \param[in] view direction to the camera, by which the points are shaded */
std::vector<Stage>
cloudStages(const ViewerRun& run, const Eigen::Vector3d& view);

/** \brief What stands for them when a mesh was read. */
Stage
meshStage(const ViewerRun& run);

} // namespace app
