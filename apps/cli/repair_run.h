// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: repairs the mesh of a file.
#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>

#include "io/model.h"
#include "progress.h"

namespace app {

/** \brief What to do, and with what. */
struct RepairTask {
  pcl::repair::RepairParameters method;
  const pcl::PCLPointCloud2* free_points = nullptr; /**< null: none */
  unsigned int threads = 0;
};

/** \brief Repair a mesh in place; its points stay byte for byte and with the same
 * fields. Fails for a mesh that has no triangle. After a signal it is of no use. */
Status
repairMesh(const RepairTask& task,
           const Viewpoint& viewpoint,
           ProgressBar& bar,
           pcl::PolygonMesh& mesh,
           pcl::RepairReport& report);

} // namespace app
