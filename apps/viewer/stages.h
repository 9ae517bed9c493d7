// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the stages of the method as the viewer draws them.
#pragma once

#include <Eigen/Core>

#include "render/stage_builder.h"

#include <string>
#include <vector>

namespace app {

struct ViewerRun;

/** \brief Names of all stages: those of a cloud and, last, "mesh", with which a mesh
 * begins in place of the first four. */
const std::vector<std::string>&
stageNames();

/** \brief All stages of a run.
 * \param[in] view direction to the camera, by which the points of a cloud are shaded */
std::vector<Stage>
makeStages(const ViewerRun& run, const Eigen::Vector3d& view);

/** \brief Cloud, start, filter and base.
 * \param[in] view direction to the camera, by which the points are shaded */
std::vector<Stage>
cloudStages(const ViewerRun& run, const Eigen::Vector3d& view);

/** \brief What stands for them when a mesh was read. */
Stage
meshStage(const ViewerRun& run);

} // namespace app
