// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: consecutive application of algorithms (thesis 3.1).
#pragma once

#include <pcl/console/print.h>
#include <pcl/surface_ccaa/consecutive/chain_results.h>
#include <pcl/surface_ccaa/consecutive/filter_stage.h>
#include <pcl/surface_ccaa/consecutive/stage_polygons.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_ccaa/impl/greedy_start.hpp>
#include <pcl/surface_ccaa/impl/projection_completion.hpp>
#include <pcl/surface_ccaa/search/block_search.h>
#include <pcl/surface_ccaa/search/cloud_points.h>
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
  check_tree_ = false; // the parts decide for themselves what a tree is to hold
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

/** One start algorithm and the filter behind it. A step that makes internal points
 * fewer is taken back. */
template <typename PointT>
bool
ConsecutiveReconstruction<PointT>::applyStart(std::size_t number, ccaa::ChainRun& run)
{
  report_.stages.emplace_back();
  ChainStageReport& stage = report_.stages.back();
  stage.name = ccaa::startName(number);
  std::vector<Vertices> made;
  if (!construct(number, run, made))
    return false;
  if (number > 0 && made.empty()) {
    run.weight_done += ccaa::FILTER_WEIGHT;
    stage.internal_points = report_.internal_points;
    return true;
  }
  ccaa::ChainMesh given = run.current;
  if (number == 0) {
    given.labels.assign(made.size(), 0);
    given.mesh->polygons = std::move(made);
  }
  else {
    given.mesh = std::make_shared<pcl::PolygonMesh>(*run.current.mesh);
    auto* const completion =
        dynamic_cast<MeshCompletion<PointT>*>(starts_[number].get());
    if (completion != nullptr)
      ccaa::keepOnly(completion->keptTriangles(), given);
    ccaa::appendNewTriangles(
        made, static_cast<std::uint8_t>(number), given.mesh->polygons, given.labels);
  }
  ccaa::ChainMesh left;
  if (!filterTriangles(given, run, left))
    return false;
  stage.internal_points = ccaa::countInternalPoints(left.roles);
  stage.kept = number == 0 || stage.internal_points >= report_.internal_points;
  if (!stage.kept)
    return true;
  report_.internal_points = stage.internal_points;
  report_.connected_points = ccaa::countConnectedPoints(left.roles);
  run.current = std::move(left);
  return true;
}

/** What the start algorithm adds, as triangles. */
template <typename PointT>
bool
ConsecutiveReconstruction<PointT>::construct(std::size_t number,
                                             ccaa::ChainRun& run,
                                             std::vector<Vertices>& made)
{
  ChainStageReport& stage = report_.stages.back();
  ccaa::StageProgress progress = run.beginStage(stage.name, ccaa::START_WEIGHT);
  if (!progress.report(0))
    return false;
  const ccaa::StageClock clock;
  Algorithm& algorithm = *starts_[number];
  const ccaa::LentSettings lent(&algorithm, threads_, progress);
  auto* const completion = dynamic_cast<MeshCompletion<PointT>*>(&algorithm);
  if (completion != nullptr) {
    const auto partial_mesh = number == 0 ? nullptr : run.current.mesh;
    if (!completeFrom(partial_mesh, *completion, run, made))
      return false;
    if (partial_mesh) {
      const auto* kept = completion->keptTriangles();
      const auto count = kept ? kept->size() : partial_mesh->polygons.size();
      made.erase(made.begin(), made.begin() + std::ptrdiff_t(count));
    }
  }
  else {
    const auto chosen = number == 0 ? run.points.usable : ccaa::selectOpenPoints(run);
    if (chosen->size() >= 3)
      ccaa::constructFrom(chainInput(), chosen, run.points, algorithm, made);
  }
  report_.invalid_polygons += ccaa::makeTriangles(made, run.point_count, run.loop());
  stage.seconds = clock.seconds();
  report_.start_seconds += stage.seconds;
  if (number == 0 && made.empty() && !run.control.cancelled())
    PCL_WARN("[pcl::%s::performReconstruction] the start algorithm made no triangle "
             "(%zu points)\n",
             getClassName().c_str(),
             run.points.usable->size());
  return progress.report(1);
}

template <typename PointT>
bool
ConsecutiveReconstruction<PointT>::filterTriangles(ccaa::ChainMesh& given,
                                                   ccaa::ChainRun& run,
                                                   ccaa::ChainMesh& left)
{
  ccaa::StageProgress progress = run.beginStage("filter", ccaa::FILTER_WEIGHT);
  if (!progress.report(0))
    return false;
  const std::size_t given_count = given.labels.size();
  const ccaa::StageClock clock;
  const ccaa::LentSettings lent(filter_.get(), threads_, progress);
  const bool is_sound = ccaa::applyFilter(given, filter_.get(), run, left);
  if (!is_sound)
    PCL_ERROR("[pcl::%s::performReconstruction] the filter returned what it was not "
              "given (%zu triangles given, %zu polygons returned)\n",
              getClassName().c_str(),
              given_count,
              left.mesh->polygons.size());
  ChainStageReport& stage = report_.stages.back();
  stage.filter_seconds = clock.seconds();
  report_.filter_seconds += stage.filter_seconds;
  return is_sound && progress.report(1);
}

template <typename PointT>
bool
ConsecutiveReconstruction<PointT>::applyBase(ccaa::ChainRun& run)
{
  ccaa::ChainMesh& current = run.current;
  // Who may replace triangles can cut a one-sided region; who keeps them all cannot.
  const bool is_one_sided =
      base_ && base_->keptTriangles() == nullptr && ccaa::leftOneSided(filter_.get());
  if (is_one_sided)
    PCL_WARN("[pcl::%s::performReconstruction] not completed: a region is one-sided "
             "(%zu triangles)\n",
             getClassName().c_str(),
             current.labels.size());
  if (base_ && !is_one_sided) {
    report_.stages.emplace_back();
    report_.stages.back().name = "base";
    std::vector<Vertices> polygons;
    if (!runBase(current.mesh, ccaa::BASE_WEIGHT, run, polygons))
      return false;
    ccaa::takeOver(std::move(polygons),
                   base_->keptTriangles(),
                   static_cast<std::uint8_t>(starts_.size()),
                   current);
    report_.stages.back().seconds = report_.base_seconds;
  }
  const std::size_t connected = ccaa::countConnectedPoints(current.roles);
  report_.free_points = report_.points - std::min(report_.points, connected);
  return true;
}

/** The base algorithm, in the chain or alone; its time goes to base_seconds. */
template <typename PointT>
bool
ConsecutiveReconstruction<PointT>::runBase(const PolygonMeshConstPtr& partial_mesh,
                                           double weight,
                                           ccaa::ChainRun& run,
                                           std::vector<Vertices>& polygons)
{
  ccaa::StageProgress progress = run.beginStage("base", weight);
  if (!progress.report(0))
    return false;
  const ccaa::StageClock clock;
  const ccaa::LentSettings lent(base_.get(), threads_, progress);
  if (!completeFrom(partial_mesh, *base_, run, polygons))
    return false;
  report_.base_seconds = clock.seconds();
  return progress.report(1);
}

template <typename PointT>
bool
ConsecutiveReconstruction<PointT>::completeFrom(const PolygonMeshConstPtr& partial_mesh,
                                                MeshCompletion<PointT>& completion,
                                                const ccaa::ChainRun& run,
                                                std::vector<Vertices>& polygons) const
{
  if (ccaa::complete(chainInput(), partial_mesh, run, completion, polygons))
    return !run.control.cancelled();
  PCL_ERROR("[pcl::%s::performReconstruction] the algorithm of stage '%s' did not keep "
            "the given triangles (%zu given, %zu polygons returned)\n",
            getClassName().c_str(),
            run.stage.c_str(),
            partial_mesh ? partial_mesh->polygons.size() : 0,
            polygons.size());
  return false;
}

template <typename PointT>
void
ConsecutiveReconstruction<PointT>::computeNormals(const pcl::PolygonMesh& mesh,
                                                  ccaa::ChainRun& run)
{
  const ccaa::StageClock clock;
  ccaa::StageProgress progress = run.beginStage("normals", ccaa::NORMALS_WEIGHT);
  ccaa::RunControl control(progress.callback());
  const ccaa::LoopContext loop{run.threads, &control, "vertices", ccaa::BLOCK_SIZE};
  normals_ = std::make_shared<PointCloud<Normal>>(input_->width, input_->height);
  normals_->header = input_->header;
  ccaa::fillNormals(mesh, loop, *normals_);
  report_.normals_seconds = clock.seconds();
  progress.report(1);
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
  if (!base_ || !this->initCompute())
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
