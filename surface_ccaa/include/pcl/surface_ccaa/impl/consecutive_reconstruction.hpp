// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: consecutive application of algorithms (thesis 3.1).
#pragma once

#include <pcl/console/print.h>
#include <pcl/surface_ccaa/consecutive/chain_results.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_ccaa/impl/consecutive_stages.hpp>
#include <pcl/surface_ccaa/impl/greedy_start.hpp>
#include <pcl/surface_ccaa/impl/projection_completion.hpp>
#include <pcl/surface_ccaa/search/block_search.h>
#include <pcl/surface_ccaa/search/cloud_points.h>
#include <pcl/surface_ccaa/search/cloud_sides.h>
#include <pcl/conversions.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

namespace pcl {

template <typename PointT>
ConsecutiveReconstruction<PointT>::ConsecutiveReconstruction()
: filter_(std::make_shared<UmbrellaFilter>())
{
  side_hints_.try_origin = true;
  side_hints_.guess_plane = true; // the start algorithm winds in any way
  const auto start = std::make_shared<GreedyStart<PointT>>();
  start->setSearchMethod(std::make_shared<search::BlockSearch<PointT>>());
  starts_.push_back(start);
  const auto base = std::make_shared<ProjectionCompletion<PointT>>();
  base->setKeepGiven(false); // a start algorithm has a right of mistake
  base_ = base;
}

template <typename PointT>
void
ConsecutiveReconstruction<PointT>::performReconstruction(pcl::PolygonMesh& output)
{
  reconstructInto(output, true);
}

template <typename PointT>
void
ConsecutiveReconstruction<PointT>::performReconstruction(
    std::vector<pcl::Vertices>& polygons)
{
  pcl::PolygonMesh output;
  reconstructInto(output, false);
  polygons = std::move(output.polygons);
}

template <typename PointT>
void
ConsecutiveReconstruction<PointT>::clearResult(pcl::PolygonMesh& output)
{
  output.polygons.clear();
  labels_.clear();
  normals_.reset();
  report_ = {};
  side_tally_ = {};
}

/** No exception leaves a run: neither our own lack of memory nor what a part throws. */
template <typename PointT>
template <typename Body>
bool
ConsecutiveReconstruction<PointT>::guarded(const ccaa::ChainRun& run,
                                           const Body& body) const
{
  try {
    return body();
  }
  catch (const std::exception& problem) {
    PCL_ERROR("[pcl::%s::performReconstruction] %s (stage '%s', %zu points)\n",
              getClassName().c_str(),
              problem.what(),
              run.stage.c_str(),
              input_->size());
  }
  catch (...) {
    PCL_ERROR("[pcl::%s::performReconstruction] unknown exception (stage '%s')\n",
              getClassName().c_str(),
              run.stage.c_str());
  }
  return false;
}

/** The cloud of the output travels through the run and back: it is never copied. */
template <typename PointT>
void
ConsecutiveReconstruction<PointT>::reconstructInto(pcl::PolygonMesh& output,
                                                   bool has_cloud)
{
  clearResult(output);
  const ccaa::StageClock clock;
  ccaa::ChainRun run(progress_, ccaa::resolveThreads(threads_));
  const bool done = guarded(run, [&] {
    run.current.mesh = std::make_shared<pcl::PolygonMesh>();
    if (has_cloud)
      std::swap(run.current.mesh->cloud, output.cloud);
    else
      pcl::toPCLPointCloud2(*input_, run.current.mesh->cloud);
    if (!applyChain(run))
      return false;
    report_.total_seconds = clock.seconds();
    if (compute_normals_)
      computeNormals(*run.current.mesh, run);
    return !run.control.cancelled();
  });
  if (has_cloud && run.current.mesh)
    std::swap(run.current.mesh->cloud, output.cloud);
  if (done) {
    output.polygons = std::move(run.current.mesh->polygons);
    labels_ = std::move(run.current.labels);
    return;
  }
  clearResult(output);
  report_.cancelled = run.control.cancelled();
}

/** Scheme S2 of the thesis: start, filter, base. */
template <typename PointT>
bool
ConsecutiveReconstruction<PointT>::applyChain(ccaa::ChainRun& run)
{
  if (!hasValidParts() || !selectPoints(run))
    return false;
  run.total_weight =
      double(starts_.size()) * (ccaa::START_WEIGHT + ccaa::FILTER_WEIGHT) +
      (base_ ? ccaa::BASE_WEIGHT : 0) + (compute_normals_ ? ccaa::NORMALS_WEIGHT : 0);
  for (std::size_t number = 0; number < starts_.size(); ++number)
    if (!applyStart(number, run))
      return false;
  if (!applyBase(run))
    return false;
  for (const std::uint8_t label : run.current.labels)
    ++report_.stages[label].triangles;
  return true;
}

template <typename PointT>
bool
ConsecutiveReconstruction<PointT>::hasValidParts() const
{
  const bool is_valid =
      !starts_.empty() && starts_.size() <= 255 &&
      std::find(starts_.begin(), starts_.end(), nullptr) == starts_.end();
  if (!is_valid)
    PCL_ERROR("[pcl::%s::performReconstruction] 1 to 255 start algorithms are needed, "
              "none of them null (%zu given)\n",
              getClassName().c_str(),
              starts_.size());
  return is_valid;
}

template <typename PointT>
bool
ConsecutiveReconstruction<PointT>::selectPoints(ccaa::ChainRun& run)
{
  const std::string name = getClassName();
  run.point_count = input_->size();
  const auto outside = ccaa::findIndexOutside(*indices_, run.point_count);
  if (outside != indices_->end()) {
    PCL_ERROR("[pcl::%s::performReconstruction] index %d is outside the cloud of %zu "
              "points\n",
              name.c_str(),
              static_cast<int>(*outside),
              run.point_count);
    return false;
  }
  run.points =
      ccaa::selectUsablePoints(ccaa::pointArrayOf(*input_), indices_, run.loop());
  run.sides = ccaa::sidesOf(*input_, side_hints_);
  if (ccaa::viewpointArrayOf(*input_).size == 0)
    ccaa::takeOrigin(
        run.sides, ccaa::viewOf(ccaa::pointArrayOf(*input_)), run.points.usable.get());
  run.sides.try_origin = false; // the parts look at fewer points
  report_.points = indices_->size();
  report_.skipped_points = run.points.skipped;
  if (run.points.usable->size() >= 3)
    return true;
  PCL_ERROR("[pcl::%s::performReconstruction] %zu usable points, at least 3 are "
            "needed\n",
            name.c_str(),
            run.points.usable->size());
  return false;
}

template <typename PointT>
SpeedupReport
ConsecutiveReconstruction<PointT>::measureSpeedup()
{
  pcl::PolygonMesh output;
  clearResult(output);
  if (!base_)
    PCL_ERROR("[pcl::%s::measureSpeedup] no base algorithm to compare with\n",
              getClassName().c_str());
  if (!base_ || !this->hasUsableCloud("measureSpeedup") || !this->initCompute())
    return {};
  ccaa::ChainRun alone(progress_, ccaa::resolveThreads(threads_));
  std::vector<Vertices> polygons;
  const bool done = guarded(alone, [&] {
    return selectPoints(alone) && runBase(nullptr, 1, alone, polygons);
  });
  const double base_seconds = report_.base_seconds;
  clearResult(output);
  report_.cancelled = alone.control.cancelled();
  if (done)
    reconstructInto(output, false);
  this->deinitCompute();
  return ccaa::compareSpeed(base_seconds, report_);
}

} // namespace pcl

#define PCL_INSTANTIATE_ConsecutiveReconstruction(T)                                   \
  template class PCL_EXPORTS pcl::ConsecutiveReconstruction<T>;
