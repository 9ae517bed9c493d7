// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the stages of a chain: starts, filters, base, normals.
#pragma once

#include <pcl/console/print.h>
#include <pcl/surface_ccaa/consecutive/chain_results.h>
#include <pcl/surface_ccaa/consecutive/filter_stage.h>
#include <pcl/surface_ccaa/consecutive/stage_polygons.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace pcl {

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
  const ccaa::LentSides sides(&algorithm, run.sides);
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
  const ccaa::LentSides sides(filter_.get(), run.sides);
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
  if (sides.tally() != nullptr)
    side_tally_ = *sides.tally();
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
  const ccaa::LentSides sides(base_.get(), run.sides);
  if (!completeFrom(partial_mesh, *base_, run, polygons))
    return false;
  side_tally_ = *sides.tally();
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

} // namespace pcl
