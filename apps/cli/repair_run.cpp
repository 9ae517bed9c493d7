// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: repairs the mesh of a file.
#include "repair_run.h"

#include <pcl/surface_repair/force_line_hole_repair.h>

#include "side_options.h"

#include <utility>

namespace app {

Status
repairMesh(const RepairTask& task,
           const Viewpoint& viewpoint,
           ProgressBar& bar,
           pcl::PolygonMesh& mesh,
           pcl::RepairReport& report)
{
  const auto input = pcl::make_shared<pcl::PolygonMesh>(std::move(mesh));
  pcl::ForceLineHoleRepair repair;
  repair.setInputMesh(input);
  pcl::repair::RepairParameters method = task.method;
  pcl::ccaa::SideHints& sides = method.survey.orientation.sides;
  sides = sidesOf(sides, viewpoint);
  repair.setParameters(method);
  repair.setNumberOfThreads(task.threads);
  repair.setProgressCallback(bar.callback());
  if (task.free_points != nullptr)
    repair.setFreePoints(pcl::make_shared<pcl::PCLPointCloud2>(*task.free_points));
  repair.process(mesh);
  report = repair.getReport();
  if (!report.reading.problem.empty())
    return Status::error(report.reading.problem);
  if (!report.cancelled && mesh.polygons.empty())
    return Status::error("the repair failed, perhaps for lack of memory");
  return {};
}

} // namespace app
