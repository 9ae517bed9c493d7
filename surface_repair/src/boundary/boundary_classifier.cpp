// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what each boundary of a mesh bounds: hole, rim or border.
#include <pcl/console/print.h>
#include <pcl/surface_repair/boundary_classifier.h>

#include "boundary/classification.h"
#include "boundary/extraction.h"
#include "icadm/icm_class.h"
#include "icadm/model_reading.h"
#include "mesh/block_loop.h"
#include "run/threads.h"

#include <new>

namespace pcl {
namespace {

std::vector<ClassifiedBoundary>
inCloudIndices(const repair::IncompleteModel& model,
               const repair::BoundaryLoops& loops,
               const std::vector<repair::LoopClass>& classes)
{
  std::vector<ClassifiedBoundary> boundaries(classes.size());
  for (std::size_t i = 0; i < classes.size(); ++i) {
    ClassifiedBoundary& boundary = boundaries[i];
    for (const pcl::index_t vertex : loops[i].vertices)
      boundary.vertices.push_back(
          model.point_of_vertex[static_cast<std::size_t>(vertex)]);
    boundary.boundary_class = classes[i].boundary_class;
    boundary.confidence = classes[i].confidence;
    boundary.evidence = classes[i].evidence;
    boundary.faced = classes[i].faced;
    boundary.island = loops[i].island;
    boundary.length = loops[i].length;
  }
  return boundaries;
}

bool
isShare(double value)
{
  return value >= 0.0 && value <= 1.0; // NaN is none
}

} // namespace

bool
BoundaryClassifier::classify(std::vector<ClassifiedBoundary>& boundaries)
{
  boundaries.clear();
  report_ = BoundaryReport();
  bool done = false;
  try {
    done = checkParameters() && run(boundaries);
  }
  catch (const std::bad_alloc&) {
    PCL_ERROR("[pcl::BoundaryClassifier::classify] out of memory (%zu polygons)\n",
              input_mesh_ ? input_mesh_->polygons.size() : std::size_t{0});
  }
  if (!done)
    boundaries.clear();
  return done;
}

bool
BoundaryClassifier::checkParameters() const
{
  if (!isShare(parameters_.decided_from))
    PCL_ERROR("[pcl::BoundaryClassifier::classify] the minimum confidence must be "
              "between 0 and 1 (%f)\n",
              parameters_.decided_from);
  else if (!isShare(parameters_.faced_from))
    PCL_ERROR("[pcl::BoundaryClassifier::classify] the minimum faced share must be "
              "between 0 and 1 (%f)\n",
              parameters_.faced_from);
  else
    return true;
  return false;
}

bool
BoundaryClassifier::run(std::vector<ClassifiedBoundary>& boundaries)
{
  ccaa::RunControl control(progress_);
  ccaa::LoopContext context;
  context.threads = ccaa::resolveThreads(threads_);
  context.control = &control;
  context.stage = "reading";
  const repair::ReadModel read = repair::readModel(input_mesh_, nullptr, context);
  report_.reading = read.report;
  if (!read.report.problem.empty() && !control.cancelled())
    PCL_ERROR("[pcl::BoundaryClassifier::classify] %s (%zu polygons)\n",
              read.report.problem.c_str(),
              input_mesh_ ? input_mesh_->polygons.size() : std::size_t{0});
  if (!read.report.problem.empty())
    return false;
  if (read.report.invalid_polygons > 0)
    PCL_WARN("[pcl::BoundaryClassifier::classify] left out invalid polygons (%zu of "
             "%zu)\n",
             read.report.invalid_polygons,
             read.report.input_polygons);
  context.stage = "boundaries";
  const repair::BoundaryLoops loops = repair::extractBoundaries(read.model);
  const auto classes =
      repair::classifyBoundaries(read.model, loops, parameters_, context);
  if (!control.report("boundaries", 1.0))
    return false;
  boundaries = inCloudIndices(read.model, loops, classes);
  count(read.model, boundaries);
  return true;
}

void
BoundaryClassifier::count(const repair::IncompleteModel& model,
                          const std::vector<ClassifiedBoundary>& boundaries)
{
  std::vector<std::size_t> hole_edges;
  for (const ClassifiedBoundary& boundary : boundaries)
    switch (boundary.boundary_class) {
    case repair::BoundaryClass::HOLE:
      hole_edges.push_back(boundary.vertices.size());
      break;
    case repair::BoundaryClass::ISLAND_RIM:
      ++report_.island_rims;
      break;
    case repair::BoundaryClass::OUTER_BORDER:
      ++report_.outer_borders;
      break;
    case repair::BoundaryClass::UNDECIDED:
      ++report_.undecided;
    }
  report_.triangles = model.triangles.size();
  report_.free_points = model.free_points.size();
  for (const repair::Island& island : model.islands)
    report_.one_sided_islands += island.one_sided ? 1 : 0;
  report_.counts =
      repair::countHoles(model.islands.size(), hole_edges, simple_hole_edges_);
  report_.icm_class = repair::classOf(report_.counts);
}

} // namespace pcl
