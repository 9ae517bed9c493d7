// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from islands and complex holes to one correct surface.

#include <pcl/console/print.h>
#include <pcl/search/search.h>
#include <pcl/surface_ccaa/impl/checked_construction.hpp>
#include <pcl/surface_repair/force_line_hole_repair.h>

#include "mesh/cloud_access.h"
#include "mesh/polygon_access.h"
#include "repair/decision_proposal.h"
#include "repair/new_vertices.h"
#include "repair/repair_method.h"
#include "repair/repaired_model.h"
#include "run/threads.h"

#include <chrono>
#include <new>
#include <utility>

namespace pcl {

ForceLineHoleRepair::ForceLineHoleRepair() = default;

ForceLineHoleRepair::~ForceLineHoleRepair() = default;

/** PCL clears the polygons of the output between initCompute() and performProcessing():
 * the repair runs here, so that output may be the input mesh. */
bool
ForceLineHoleRepair::initCompute()
{
  repaired_.reset();
  report_ = RepairReport();
  if (!MeshProcessing::initCompute() || !checkParameters())
    return false;
  try {
    return run();
  }
  catch (const std::bad_alloc&) {
    reportOutOfMemory("initCompute");
    return false;
  }
}

repair::Decisions
ForceLineHoleRepair::proposeDecisions() const
{
  if (!input_mesh_) {
    PCL_ERROR("[pcl::%s::proposeDecisions] no input mesh\n", getClassName().c_str());
    return {};
  }
  if (!checkParameters())
    return {};
  try {
    return propose();
  }
  catch (const std::bad_alloc&) {
    reportOutOfMemory("proposeDecisions");
    return {};
  }
}

repair::Decisions
ForceLineHoleRepair::propose() const
{
  ccaa::RunControl control(progress_);
  ccaa::LoopContext context;
  context.threads = ccaa::resolveThreads(threads_);
  context.control = &control;
  repair::RepairParameters parameters = parameters_;
  parameters.survey.trace_in_holes = false;
  parameters.survey.trace_between_islands = parameters.join_islands;
  if (parameters.watertight)
    parameters.filling.close = repair::CloseChoice::ALL;
  const repair::ModelSurvey survey =
      surveyModel(input_mesh_, free_points_.get(), parameters.survey, context);
  if (survey.cancelled || context.cancelled())
    return {};
  const std::string& problem = survey.reading.problem;
  if (problem.empty())
    return repair::proposeDecisions(survey, parameters);
  PCL_ERROR("[pcl::%s::proposeDecisions] cannot survey the mesh: %s (%zu polygons)\n",
            getClassName().c_str(),
            problem.c_str(),
            input_mesh_->polygons.size());
  return {};
}

bool
ForceLineHoleRepair::run()
{
  ccaa::RunControl control(progress_);
  ccaa::LoopContext context;
  context.threads = ccaa::resolveThreads(threads_);
  context.control = &control;
  repaired_ = std::make_shared<repair::RepairedModel>(repair::runRepair(
      input_mesh_, free_points_.get(), parameters_, context, report_));
  if (report_.cancelled)
    return true;
  const std::string& problem = report_.reading.problem;
  if (!problem.empty())
    PCL_ERROR("[pcl::%s::initCompute] cannot repair the mesh: %s (%zu polygons)\n",
              getClassName().c_str(),
              problem.c_str(),
              input_mesh_->polygons.size());
  return problem.empty();
}

void
ForceLineHoleRepair::performProcessing(pcl::PolygonMesh& output)
{
  const auto start = std::chrono::steady_clock::now();
  if (&output != input_mesh_.get())
    output.cloud = input_mesh_->cloud;
  try {
    write(output);
  }
  catch (const std::bad_alloc&) {
    reportOutOfMemory("performProcessing");
    output.polygons.clear();
  }
  const std::chrono::duration<double> seconds =
      std::chrono::steady_clock::now() - start;
  report_.seconds.emplace_back("writing", seconds.count());
}

void
ForceLineHoleRepair::write(pcl::PolygonMesh& output)
{
  output.polygons.clear();
  if (!repaired_ || report_.cancelled)
    return;
  auto next = static_cast<pcl::index_t>(ccaa::pointCount(output.cloud));
  repair::AddedVertices added = addedVertices(*repaired_);
  const Eigen::Vector3d& shift = report_.reading.global_shift;
  for (ccaa::NewVertex& vertex : added.vertices)
    if (!shift.isZero(0.0)) // which would make 0 of -0
      vertex.position += shift;
  const ccaa::CloudProblem problem = ccaa::appendVertices(output.cloud, added.vertices);
  if (problem != ccaa::CloudProblem::NONE) {
    PCL_ERROR("[pcl::%s::performProcessing] cannot append vertices: %s (%zu)\n",
              getClassName().c_str(),
              ccaa::describe(problem),
              added.vertices.size());
    return;
  }
  report_.new_vertices = added.vertices.size();
  for (const std::size_t vertex : added.numbers)
    repaired_->model.point_of_vertex[vertex] = next++;
  ccaa::LoopContext context;
  context.threads = ccaa::resolveThreads(threads_);
  ccaa::writePolygons(repaired_->model.triangles,
                      repaired_->model.point_of_vertex,
                      context,
                      output.polygons);
  report_.finished = true;
}

void
ForceLineHoleRepair::deinitCompute()
{
  repaired_.reset();
  MeshProcessing::deinitCompute();
}

void
ForceLineHoleRepair::reportOutOfMemory(const char* method) const
{
  PCL_ERROR("[pcl::%s::%s] out of memory (%zu points)\n",
            getClassName().c_str(),
            method,
            ccaa::pointCount(input_mesh_->cloud));
}

bool
ForceLineHoleRepair::checkParameters() const
{
  const repair::FieldParameters& field = parameters_.survey.field;
  const std::pair<const char*, bool> checks[] = {
      {"interpolation (k_i)", field.interpolation >= 0.0},
      {"falloff exponent (chi)", field.falloff_exponent > 0.0},
      {"near radius (L_1)", field.near >= 0.0},
      {"far radius (L_2)", field.far >= 0.0},
      {"greatest bridge", parameters_.survey.greatest_bridge.value >= 0.0},
      {"least area of islands",
       parameters_.survey.dropped.area >= 0.0 &&
           parameters_.survey.dropped.share_of_all_area >= 0.0},
      {"greatest hole length", parameters_.filling.greatest_length.value >= 0.0},
      {"room", field.room > 1.0},
      {"free point near radius (R_1)", field.free_point_near >= 0.0},
      {"free point far radius (R_2)", field.free_point_far >= 0.0},
      {"free point exponent (gamma)", field.free_point_exponent > 0.0},
      {"trust (k_t)", field.trust >= 0.0 && field.trust < 1.0},
      {"hole threshold (T)",
       parameters_.survey.hole_threshold > 0.0 &&
           parameters_.survey.hole_threshold <= 0.5},
      {"bridge spacing", parameters_.survey.bridge_spacing > 0.0},
      {"line spacing", parameters_.survey.line_spacing > 0.0},
      {"edge length", parameters_.refinement.edge_length > 0.0},
      {"relaxation rounds", parameters_.relaxation.rounds > 0},
      {"relaxation reach", parameters_.relaxation.reach > 0.0},
  };
  for (const auto& [name, in_range] : checks)
    if (!in_range) {
      PCL_ERROR("[pcl::%s::initCompute] the %s is out of range\n",
                getClassName().c_str(),
                name);
      return false;
    }
  // Free points come as a plain list.
  const bool can_search = ccaa::canSearch(field.search.get(), PointCloud<PointXYZ>());
  if (!can_search)
    PCL_ERROR("[pcl::%s::initCompute] the search method %s needs an organised cloud, "
              "free points are not\n",
              getClassName().c_str(),
              field.search->getName().c_str());
  return can_search;
}

} // namespace pcl
