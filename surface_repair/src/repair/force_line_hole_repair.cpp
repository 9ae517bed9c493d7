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
#include "repair/whole_progress.h"
#include "run/stage_clock.h"
#include "run/threads.h"
#include "survey/survey_stages.h"
#include "verification/repaired_model.h"

#include <new>
#include <utility>

namespace pcl {

ForceLineHoleRepair::ForceLineHoleRepair() = default;

ForceLineHoleRepair::~ForceLineHoleRepair() = default;

/** PCL clears the polygons of the output between initCompute() and performProcessing():
 * they are read here, so that output may be the input mesh. */
bool
ForceLineHoleRepair::initCompute()
{
  survey_.reset();
  report_ = RepairReport();
  if (!MeshProcessing::initCompute() || !checkParameters())
    return false;
  try {
    return read();
  }
  catch (const std::bad_alloc&) {
    reportOutOfMemory("initCompute");
    return false;
  }
}

ccaa::MeshView
ForceLineHoleRepair::inputView() const
{
  return input_mesh_;
}

void
ForceLineHoleRepair::writeTriangles(ccaa::Triangles& triangles,
                                    const std::vector<pcl::index_t>& point_of_vertex,
                                    const ccaa::LoopContext& context,
                                    pcl::PolygonMesh& output)
{
  ccaa::handOut(
      std::move(triangles), point_of_vertex, context, nullptr, output.polygons);
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
  const ccaa::LoopContext context{ccaa::resolveThreads(threads_), &control};
  repair::RepairParameters parameters = parameters_;
  parameters.survey.trace_in_holes = false;
  parameters.survey.trace_between_islands = parameters.join_islands;
  if (parameters.watertight)
    parameters.filling.close = repair::CloseChoice::ALL;
  const repair::ModelSurvey survey =
      surveyModel(inputView(), free_points_.get(), parameters.survey, context);
  if (survey.cancelled || context.cancelled())
    return {};
  return isSound(survey.reading, "proposeDecisions")
             ? repair::proposeDecisions(survey, parameters)
             : repair::Decisions();
}

ccaa::ProgressCallback
ForceLineHoleRepair::wholeProgress() const
{
  return [whole = whole_](const std::string& stage, double share) {
    return whole->tell(stage, share);
  };
}

bool
ForceLineHoleRepair::read()
{
  whole_ = std::make_shared<repair::WholeProgress>(progress_);
  ccaa::RunControl control(wholeProgress());
  const ccaa::LoopContext context{ccaa::resolveThreads(threads_), &control};
  survey_ = std::make_shared<repair::ModelSurvey>(
      readSurvey(inputView(), free_points_.get(), parameters_.survey, context));
  report_.reading = survey_->reading;
  report_.cancelled = context.cancelled();
  return report_.cancelled || isSound(report_.reading, "initCompute");
}

bool
ForceLineHoleRepair::isSound(const repair::ReadingReport& reading,
                             const char* method) const
{
  if (!reading.problem.empty())
    PCL_ERROR("[pcl::%s::%s] cannot repair the mesh: %s (%zu polygons)\n",
              getClassName().c_str(),
              method,
              reading.problem.c_str(),
              reading.input_polygons);
  return reading.problem.empty();
}

void
ForceLineHoleRepair::performProcessing(pcl::PolygonMesh& output)
{
  output.polygons.clear();
  try {
    ccaa::RunControl control(wholeProgress());
    const ccaa::LoopContext context{ccaa::resolveThreads(threads_), &control};
    repair::RepairedModel repaired;
    if (!report_.cancelled) {
      repaired = repairModel(
          std::move(*survey_), input_mesh_->cloud, parameters_, context, report_);
      report_.cancelled = context.cancelled();
    }
    if (!isSound(report_.reading, "performProcessing")) {
      output.cloud = {};
      return;
    }
    write(repaired, output);
    if (report_.finished)
      whole_->tell("writing", 1.0);
  }
  catch (const std::bad_alloc&) {
    reportOutOfMemory("performProcessing");
    output.polygons.clear();
  }
}

void
ForceLineHoleRepair::write(repair::RepairedModel& repaired, pcl::PolygonMesh& output)
{
  const ccaa::StageClock clock;
  if (&output != input_mesh_.get())
    output.cloud = input_mesh_->cloud;
  if (report_.cancelled)
    return;
  auto next = static_cast<pcl::index_t>(ccaa::pointCount(output.cloud));
  ccaa::RunControl control(wholeProgress());
  repair::AddedVertices added = addedVertices(repaired, &control);
  report_.cancelled = control.cancelled();
  if (report_.cancelled)
    return;
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
    repaired.model.point_of_vertex[vertex] = next++;
  writeTriangles(repaired.model.triangles,
                 repaired.model.point_of_vertex,
                 ccaa::LoopContext{ccaa::resolveThreads(threads_)},
                 output);
  report_.finished = true;
  report_.seconds.emplace_back("writing", clock.seconds());
}

void
ForceLineHoleRepair::deinitCompute()
{
  survey_.reset();
  whole_.reset();
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
      {"coarse distance", field.coarse_distance >= 0.0},
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
