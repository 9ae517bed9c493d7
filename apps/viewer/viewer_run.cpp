// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the work whose stages the viewer shows.
#include "viewer/viewer_run.h"

#include "cli/reconstruct_run.h"
#include "io/interrupt.h"
#include "io/model_io.h"
#include "io/position_check.h"

#include <utility>

namespace app {
namespace {

void
readInput(const ViewerTask& task, ViewerRun& run)
{
  require(readModel(task.input, run.input));
  if (task.points_only)
    run.input.mesh.polygons.clear();
  // A file for meshes that has no polygons holds a cloud.
  run.from_cloud = run.input.mesh.polygons.empty();
  noteShift(run.input);
  if (run.from_cloud)
    requireTrianglePoints(run.input.mesh.cloud, nameForPeople(task.input));
}

/** \brief The chain up to a stage; the triangles of its start stage come first. */
void
runChain(const ViewerTask& task,
         const char* until,
         ProgressBar& bar,
         const ViewerRun& run,
         ReconstructResult& result)
{
  ReconstructSettings settings;
  settings.until = until;
  settings.threads = task.threads;
  settings.sides = task.method.survey.orientation.sides;
  result.model = run.input;
  runReconstruction(settings, bar.callback(), result);
}

void
reconstruct(const ViewerTask& task, ProgressBar& bar, ViewerRun& run)
{
  ReconstructResult start;
  ReconstructResult base;
  runChain(task, "start", bar, run, start);
  if (!interrupted())
    runChain(task, "base", bar, run, base);
  if (interrupted())
    return;
  run.start = std::move(start.model.mesh.polygons);
  for (std::size_t t = 0; t < base.model.mesh.polygons.size(); ++t)
    (base.labels[t] == 0 ? run.filtered : run.added)
        .push_back(std::move(base.model.mesh.polygons[t]));
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

} // namespace

void
readForViewer(const ViewerTask& task, ViewerRun& run)
{
  readInput(task, run);
  if (!task.free_points.empty())
    require(readCloud(task.free_points, run.free_points));
}

RepairTask
repairTask(const ViewerTask& task, const ViewerRun& run)
{
  return {task.method,
          task.free_points.empty() ? nullptr : &run.free_points.mesh.cloud,
          task.threads};
}

void
runForViewer(const ViewerTask& task, ProgressBar& bar, ViewerRun& run)
{
  if (run.from_cloud) {
    reconstruct(task, bar, run);
    if (interrupted())
      return;
  }
  run.result = completeMesh(run);
  if (run.result.polygons.empty()) {
    run.problem = "no triangle could be made of these points";
    return;
  }
  const RepairTask repair = repairTask(task, run);
  run.survey = surveyMesh(repair, run.input.viewpoint, bar, run.result);
  run.problem = run.survey.reading.problem;
  if (!run.problem.empty() && task.method.survey.decisions)
    throw Failure(nameForPeople(task.input) + ": " + run.problem);
  if (!run.problem.empty() || !task.repairs || interrupted())
    return;
  run.repaired = true;
  repairMesh(repair, run.input.viewpoint, bar, run.result, run.repair);
}

} // namespace app
