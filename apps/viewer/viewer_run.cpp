// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the work whose stages the viewer shows.
#include "viewer/viewer_run.h"

#include "cli/reconstruct_run.h"
#include "cli/repair_run.h"
#include "cli/side_options.h"
#include "io/interrupt.h"
#include "io/model_io.h"
#include "io/position_check.h"
#include "run/threads.h"

#include <utility>

namespace app {
namespace {

Status
readInput(const ViewerTask& task, ViewerRun& run)
{
  const Status status = readModel(task.input, run.input);
  if (!status.ok())
    return status;
  if (task.points_only)
    run.input.mesh.polygons.clear();
  // A file for meshes that has no polygons holds a cloud.
  run.from_cloud = run.input.mesh.polygons.empty();
  noteShift(run.input);
  return run.from_cloud
             ? requireTrianglePoints(run.input.mesh.cloud, nameForPeople(task.input))
             : Status();
}

ReconstructSettings
chainSettings(const ViewerTask& task, const char* until)
{
  const pcl::ccaa::GreedyParameters greedy;
  const auto degrees = [](double angle) { return angle * 180.0 / M_PI; };
  ReconstructSettings settings;
  settings.until = until;
  settings.threads = task.threads;
  settings.sides = task.method.survey.orientation.sides;
  settings.neighbors = greedy.neighbors;
  settings.minimum_angle = degrees(greedy.minimum_angle);
  settings.certified_minimum_angle = degrees(greedy.certified_minimum_angle);
  settings.length_factor = greedy.length_factor;
  settings.minimum_internal_points =
      static_cast<unsigned int>(pcl::UmbrellaFilter().getMinimumInternalPoints());
  return settings;
}

/** \brief The chain up to a stage; the triangles of its start stage come first. */
Status
runChain(const ViewerTask& task,
         const char* until,
         ProgressBar& bar,
         const ViewerRun& run,
         ReconstructResult& result)
{
  result.model = run.input;
  return runReconstruction(chainSettings(task, until), bar, result);
}

Status
reconstruct(const ViewerTask& task, ProgressBar& bar, ViewerRun& run)
{
  ReconstructResult start;
  ReconstructResult base;
  Status status = runChain(task, "start", bar, run, start);
  if (status.ok() && !interrupted())
    status = runChain(task, "base", bar, run, base);
  if (!status.ok() || interrupted())
    return status;
  run.start = std::move(start.model.mesh.polygons);
  for (std::size_t t = 0; t < base.model.mesh.polygons.size(); ++t)
    (base.labels[t] == 0 ? run.filtered : run.added)
        .push_back(std::move(base.model.mesh.polygons[t]));
  return {};
}

/** \brief The mesh that is repaired. */
pcl::PolygonMesh
completeMesh(const ViewerRun& run)
{
  pcl::PolygonMesh mesh = run.input.mesh;
  mesh.polygons.insert(mesh.polygons.end(), run.filtered.begin(), run.filtered.end());
  mesh.polygons.insert(mesh.polygons.end(), run.added.begin(), run.added.end());
  return mesh;
}

/** \brief Survey run.result, which is not repaired yet. */
void
survey(const ViewerTask& task,
       const pcl::PCLPointCloud2* free_points,
       ProgressBar& bar,
       ViewerRun& run)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(run.result);
  pcl::repair::SurveyParameters parameters = task.method.survey;
  pcl::ccaa::SideHints& sides = parameters.orientation.sides;
  sides = sidesOf(sides, run.input.viewpoint);
  pcl::ccaa::RunControl control(bar.callback());
  pcl::ccaa::LoopContext context;
  context.threads = pcl::ccaa::resolveThreads(task.threads);
  context.control = &control;
  run.survey = surveyModel(mesh, free_points, parameters, context);
  run.problem = run.survey.reading.problem;
}

} // namespace

Status
readForViewer(const ViewerTask& task, ViewerRun& run)
{
  const Status status = readInput(task, run);
  if (!status.ok() || task.free_points.empty())
    return status;
  return readCloud(task.free_points, run.free_points);
}

Status
runForViewer(const ViewerTask& task, ProgressBar& bar, ViewerRun& run)
{
  if (run.from_cloud) {
    const Status status = reconstruct(task, bar, run);
    if (!status.ok() || interrupted())
      return status;
  }
  run.result = completeMesh(run);
  if (run.result.polygons.empty()) {
    run.problem = "no triangle could be made of these points";
    return {};
  }
  const auto* const free_points =
      task.free_points.empty() ? nullptr : &run.free_points.mesh.cloud;
  survey(task, free_points, bar, run);
  if (!run.problem.empty() && task.method.survey.decisions)
    return Status::error(nameForPeople(task.input) + ": " + run.problem);
  if (!run.problem.empty() || !task.repairs || interrupted())
    return {};
  run.repaired = true;
  return repairMesh({task.method, free_points, task.threads},
                    run.input.viewpoint,
                    bar,
                    run.result,
                    run.repair);
}

} // namespace app
