// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the stages of the method as the viewer draws them.
#pragma once

#include <Eigen/Core>

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "inspect/inspection.h"
#include "viewer/view_state.h"

#include <string>
#include <vector>

namespace app {

struct ViewerRun;

/** \brief Something that is drawn. */
struct StagePart {
  Layer layer = Layer::SURFACE; /**< by which it is shown or hidden */
  vtkSmartPointer<vtkActor> actor;
  double size = 0.0; /**< of lines and dots: pixels of a picture 900 high */
};

/** \brief An entry of the legend, which is there as long as its layer is shown. */
struct StageColor {
  Layer layer = Layer::SURFACE;
  LegendEntry entry;
};

/** \brief One step of the method, and what it left. */
struct Stage {
  std::string name;  /**< one word, for the command line */
  std::string title; /**< for people */
  std::string text;  /**< what happens here, or why there is nothing to see */
  std::vector<StageColor> legend;
  std::vector<StagePart> parts;
};

/** \brief Names of all stages: those of a cloud and, last, "mesh", with which a mesh
 * begins in place of the first four. */
const std::vector<std::string>&
stageNames();

/** \brief All stages of a run.
 * \param[in] view direction to the camera, by which the points of a cloud are shaded */
std::vector<Stage>
makeStages(const ViewerRun& run, const Eigen::Vector3d& view);

} // namespace app
