// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: keeps only the correct triangles of any mesh (thesis 3.4).
#include <pcl/console/print.h>
#include <pcl/surface_ccaa/global_shift.h>
#include <pcl/surface_ccaa/umbrella_filter.h>

#include "mesh/cloud_access.h"
#include "run/threads.h"
#include "umbrella/filter_run.h"

#include <new>

namespace pcl {

namespace {

/** What is looked at, less the global shift. */
ccaa::FilterViews
nearOrigin(const pcl::PCLPointCloud2& cloud, const Eigen::Vector3d& offset)
{
  return {ccaa::positionView(cloud).relativeTo(offset),
          ccaa::normalView(cloud),
          ccaa::viewpointView(cloud).relativeTo(offset)};
}

} // namespace

/** PCL clears the polygons of the output between initCompute() and performProcessing():
 * they are read here, so that output may be the input mesh. */
bool
UmbrellaFilter::initCompute()
{
  run_.reset();
  roles_.clear();
  report_ = UmbrellaReport();
  side_tally_ = {};
  if (!MeshProcessing::initCompute() || !checkInput())
    return false;
  try {
    readInput();
  }
  catch (const std::bad_alloc&) {
    reportOutOfMemory("initCompute");
    return false;
  }
  return true;
}

bool
UmbrellaFilter::checkInput() const
{
  const auto& cloud = input_mesh_->cloud;
  if (ccaa::pointCount(cloud) == 0)
    return true;
  const auto problem = ccaa::checkCloud(cloud);
  if (problem != ccaa::CloudProblem::NONE)
    PCL_ERROR("[pcl::%s::initCompute] cannot read the cloud: %s (%zu points)\n",
              getClassName().c_str(),
              ccaa::describe(problem),
              ccaa::pointCount(cloud));
  return problem == ccaa::CloudProblem::NONE;
}

void
UmbrellaFilter::readInput()
{
  const auto& cloud = input_mesh_->cloud;
  ccaa::FilterSettings settings;
  settings.minimum_internal_points = minimum_internal_points_;
  settings.consistent_orientation = consistent_orientation_;
  settings.twist_limits.largest_share = largest_twist_share_;
  settings.sides = side_hints_;
  settings.threads = ccaa::resolveThreads(threads_);
  ccaa::FilterViews views;
  if (ccaa::pointCount(cloud) > 0) {
    const Eigen::Vector3d offset = GlobalShift::of(cloud).offset();
    views = nearOrigin(cloud, offset);
    settings.sides = ccaa::relativeTo(offset, side_hints_);
  }
  run_ = std::make_shared<ccaa::FilterRun>(views, settings, progress_);
  run_->read(handoff_ != nullptr ? ccaa::viewOf(*handoff_->given)
                                 : ccaa::PolygonView(input_mesh_->polygons));
}

void
UmbrellaFilter::performProcessing(pcl::PolygonMesh& output)
{
  try {
    filter(output);
  }
  catch (const std::bad_alloc&) {
    reportOutOfMemory("performProcessing");
    clearResult(output);
  }
}

void
UmbrellaFilter::deinitCompute()
{
  run_.reset();
  MeshProcessing::deinitCompute();
}

void
UmbrellaFilter::filter(pcl::PolygonMesh& output)
{
  const auto outcome = run_->filter();
  if (outcome == ccaa::FilterOutcome::TOO_MANY_TRIANGLES)
    PCL_ERROR("[pcl::%s::performProcessing] too many triangles (%zu polygons)\n",
              getClassName().c_str(),
              run_->report().input_polygons);
  if (outcome != ccaa::FilterOutcome::DONE || !run_->write(handoff_, output.polygons)) {
    clearResult(output);
    report_.cancelled = outcome != ccaa::FilterOutcome::TOO_MANY_TRIANGLES;
    return;
  }
  if (&output != input_mesh_.get() && handoff_ == nullptr) // a chain has the cloud
    output.cloud = input_mesh_->cloud;
  roles_ = run_->pointRoles();
  report_ = run_->report();
  side_tally_ = run_->sideTally();
  if (handoff_ != nullptr && consistent_orientation_)
    handoff_->adjacency =
        std::make_shared<ccaa::VertexAdjacency>(run_->takeAdjacency());
  if (report_.invalid_polygons > 0)
    PCL_WARN("[pcl::%s::performProcessing] left out invalid polygons (%zu of %zu)\n",
             getClassName().c_str(),
             report_.invalid_polygons,
             report_.input_polygons);
}

void
UmbrellaFilter::reportOutOfMemory(const char* method) const
{
  PCL_ERROR("[pcl::%s::%s] out of memory (%zu points)\n",
            getClassName().c_str(),
            method,
            ccaa::pointCount(input_mesh_->cloud));
}

/** The cloud stays what it is in the input; nothing was reconstructed on it. */
void
UmbrellaFilter::clearResult(pcl::PolygonMesh& output)
{
  if (&output != input_mesh_.get())
    output.cloud = input_mesh_->cloud;
  output.polygons.clear();
  if (handoff_ != nullptr)
    handoff_->made.clear();
  roles_.clear();
  report_ = UmbrellaReport();
  side_tally_ = {};
}

} // namespace pcl
