// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a chain of algorithms, applied to a cloud (thesis 3.1).
#include "consecutive/chain.h"

#include <pcl/console/print.h>

#include "consecutive/chain_results.h"
#include "mesh/polygon_access.h"
#include "mesh/side_hints.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace pcl::ccaa {
namespace {

/** No exception leaves a run: neither our own lack of memory nor what a part throws. */
template <typename Body>
bool
guarded(const Chain& chain, const ChainInput& input, const Body& body)
{
  try {
    return body();
  }
  catch (const std::exception& problem) {
    PCL_ERROR("[pcl::ConsecutiveReconstruction::performReconstruction] %s (stage '%s', "
              "%zu points)\n",
              problem.what(),
              chain.stage().c_str(),
              input.points.size);
  }
  catch (...) {
    PCL_ERROR("[pcl::ConsecutiveReconstruction::performReconstruction] unknown "
              "exception (stage '%s')\n",
              chain.stage().c_str());
  }
  return false;
}

} // namespace

Chain::Chain(const ChainInput& input, ChainOutput& result)
: input_(input)
, result_(result)
, report_(result.report)
, filter_(input.filter)
, run_(input.progress, resolveThreads(input.threads))
{}

bool
Chain::apply(PolygonMesh& mesh)
{
  if (!hasValidParts() || !selectPoints())
    return false;
  run_.current.mesh = std::make_shared<PolygonMesh>();
  std::swap(run_.current.mesh->cloud, mesh.cloud);
  // The cloud travels through the run and back: it is never copied.
  const std::shared_ptr<void> give_back(nullptr, [this, &mesh](void*) {
    if (run_.current.mesh)
      std::swap(run_.current.mesh->cloud, mesh.cloud);
  });
  run_.total_weight = double(input_.starts.size()) * (START_WEIGHT + FILTER_WEIGHT) +
                      (input_.base ? BASE_WEIGHT : 0) +
                      (input_.compute_normals ? NORMALS_WEIGHT : 0);
  for (std::size_t number = 0; number < input_.starts.size(); ++number)
    if (!applyStart(number))
      return false;
  if (!applyBase())
    return false;
  for (const std::uint8_t label : run_.current.labels)
    ++report_.stages[label].triangles;
  report_.total_seconds = clock_.seconds();
  if (input_.compute_normals)
    computeNormals();
  if (cancelled())
    return false;
  writePolygons(run_.current.triangles, run_.loop(), mesh.polygons);
  result_.labels = std::move(run_.current.labels);
  return true;
}

bool
Chain::applyBaseAlone()
{
  Triangles triangles;
  return selectPoints() && runBase(nullptr, 1, triangles);
}

bool
Chain::hasValidParts() const
{
  const auto& starts = input_.starts;
  const bool is_valid =
      !starts.empty() && starts.size() <= 255 &&
      std::find(starts.begin(), starts.end(), nullptr) == starts.end();
  if (!is_valid)
    PCL_ERROR("[pcl::ConsecutiveReconstruction::performReconstruction] 1 to 255 start "
              "algorithms are needed, none of them null (%zu given)\n",
              starts.size());
  return is_valid;
}

bool
Chain::selectPoints()
{
  run_.point_count = input_.points.size;
  const Indices& selection = *input_.selection;
  const std::string fault = indexFault(selection, run_.point_count);
  if (!fault.empty()) {
    PCL_ERROR("[pcl::ConsecutiveReconstruction::performReconstruction] %s\n",
              fault.c_str());
    return false;
  }
  run_.points = selectUsablePoints(input_.points, input_.selection, run_.loop());
  run_.sides = input_.sides;
  if (!input_.has_viewpoints)
    takeOrigin(run_.sides, viewOf(input_.points), run_.points.usable.get());
  run_.sides.try_origin = false; // the parts look at fewer points
  report_.points = selection.size();
  report_.skipped_points = run_.points.skipped;
  if (run_.points.usable->size() >= 3)
    return true;
  PCL_ERROR(
      "[pcl::ConsecutiveReconstruction::performReconstruction] %zu usable points, "
      "at least 3 are needed\n",
      run_.points.usable->size());
  return false;
}

void
Chain::computeNormals()
{
  const StageClock clock;
  StageProgress progress = run_.beginStage("normals", NORMALS_WEIGHT);
  RunControl control(progress.callback());
  const LoopContext loop{run_.threads, &control, "vertices", BLOCK_SIZE};
  const PCLPointCloud2& cloud = run_.current.mesh->cloud;
  result_.normals = std::make_shared<PointCloud<Normal>>(cloud.width, cloud.height);
  result_.normals->header = cloud.header;
  fillNormals(run_.current.triangles, cloud, loop, *result_.normals);
  report_.normals_seconds = clock.seconds();
  progress.report(1);
}

void
runChain(const ChainInput& input,
         bool has_cloud,
         pcl::PolygonMesh& output,
         ChainOutput& result)
{
  output.polygons.clear();
  result = {};
  Chain chain(input, result);
  const bool done = guarded(chain, input, [&] {
    if (!has_cloud)
      input.write_cloud(output.cloud);
    return chain.apply(output);
  });
  if (done)
    return;
  output.polygons.clear();
  result = {};
  result.report.cancelled = chain.cancelled();
}

SpeedupReport
measureChain(const ChainInput& input, ChainOutput& result)
{
  result = {};
  Chain alone(input, result);
  const bool done = guarded(alone, input, [&] { return alone.applyBaseAlone(); });
  const double base_seconds = result.report.base_seconds;
  result = {};
  result.report.cancelled = alone.cancelled();
  pcl::PolygonMesh output;
  if (done)
    runChain(input, false, output, result);
  return compareSpeed(base_seconds, result.report);
}

} // namespace pcl::ccaa
