// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: survey and repair of a mesh, for every program.
#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "io/model.h"
#include "progress.h"
#include "survey/model_survey.h"

namespace app {

/** \brief What to do, and with what. */
struct RepairTask {
  pcl::repair::RepairParameters method;
  const pcl::PCLPointCloud2* free_points = nullptr; /**< null: none */
  unsigned int threads = 0;
};

/** \brief What the user has told about the outer side, and what the file tells. */
pcl::ccaa::SideHints
sidesOf(pcl::ccaa::SideHints told, const Viewpoint& viewpoint);

/** \brief What is missing of a mesh. Of no use after a signal.
 * \param[out] slice through the field; null: none is wanted */
pcl::repair::ModelSurvey
surveyMesh(const RepairTask& task,
           const Viewpoint& viewpoint,
           ProgressBar& bar,
           const pcl::PolygonMesh& mesh,
           pcl::repair::FieldSlice* slice = nullptr);

/** \brief Repair a mesh in place; its points stay byte for byte and with the same
 * fields. Fails for a mesh that has no triangle. After a signal it is of no use. */
void
repairMesh(const RepairTask& task,
           const Viewpoint& viewpoint,
           ProgressBar& bar,
           pcl::PolygonMesh& mesh,
           pcl::RepairReport& report);

} // namespace app
