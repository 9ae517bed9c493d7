// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the work whose stages the viewer shows.
#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>
#include <pcl/PolygonMesh.h>

#include "cli/progress.h"
#include "cli/repair_run.h"
#include "io/model.h"
#include "survey/model_survey.h"

#include <string>
#include <vector>

namespace app {

/** \brief What is to be done, and with what. */
struct ViewerTask {
  std::string input;
  std::string free_points;  /**< a file; empty: none */
  bool repairs = true;      /**< else only what is before the stage "bridges" */
  bool points_only = false; /**< take a mesh as a cloud */
  unsigned int threads = 0;
  pcl::repair::RepairParameters method;
};

/** \brief What all stages are shown from. Meshes share the points of the input, in
 * order; what comes after them is new. */
struct ViewerRun {
  bool from_cloud = false;
  Model input;                         /**< a cloud has no polygons */
  Model free_points;                   /**< a cloud of its own */
  std::vector<pcl::Vertices> start;    /**< raw triangles; of a cloud only */
  std::vector<pcl::Vertices> filtered; /**< what is right of them */
  std::vector<pcl::Vertices> added;    /**< by the base algorithm */
  std::string problem; /**< why there is nothing to survey; empty: there is */
  pcl::repair::ModelSurvey survey;
  bool repaired = false;   /**< whether there is what follows */
  pcl::PolygonMesh result; /**< the mesh to be repaired, unless it is */
  pcl::RepairReport repair;
};

/** \brief Read the input and the free points; fails for input that is of no use. */
void
readForViewer(const ViewerTask& task, ViewerRun& run);

/** \brief The repair of a run. The run has to outlive it. */
RepairTask
repairTask(const ViewerTask& task, const ViewerRun& run);

/** \brief Make a mesh of a cloud, survey and repair it. After a signal the run is of no
 * use. */
void
runForViewer(const ViewerTask& task, ProgressBar& bar, ViewerRun& run);

} // namespace app
