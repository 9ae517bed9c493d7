// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: repairs the mesh of a file.
#include "repair_run.h"

#include <pcl/surface_repair/force_line_hole_repair.h>

#include "run/threads.h"

#include <utility>

namespace app {
namespace {

/** Points of the slice through the field along its longer side. */
constexpr std::size_t SLICE_COLUMNS = 400;

} // namespace

pcl::ccaa::SideHints
sidesOf(pcl::ccaa::SideHints told, const Viewpoint& viewpoint)
{
  if (viewpoint.known)
    told.viewpoint = viewpoint.position;
  told.try_origin = viewpoint.may_be_origin;
  return told;
}

pcl::repair::ModelSurvey
surveyMesh(const RepairTask& task,
           const Viewpoint& viewpoint,
           ProgressBar& bar,
           const pcl::PolygonMesh& mesh,
           pcl::repair::FieldSlice* slice)
{
  pcl::repair::SurveyParameters parameters = task.method.survey;
  pcl::ccaa::SideHints& sides = parameters.orientation.sides;
  sides = sidesOf(sides, viewpoint);
  pcl::ccaa::RunControl control(bar.callback());
  pcl::ccaa::LoopContext context;
  context.threads = pcl::ccaa::resolveThreads(task.threads);
  context.control = &control;
  auto survey = surveyModel(mesh, task.free_points, parameters, context);
  if (slice != nullptr && survey.reading.problem.empty() && !survey.cancelled)
    *slice = sliceField(survey, parameters.field, SLICE_COLUMNS, context);
  return survey;
}

void
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
    throw Failure(report.reading.problem);
  if (!report.cancelled && mesh.polygons.empty())
    throw Failure("the repair failed, perhaps for lack of memory");
}

} // namespace app
