// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the stages of a chain: starts, filters, base.
#include <pcl/console/print.h>

#include "consecutive/chain.h"
#include "consecutive/stage_polygons.h"
#include "mesh/polygon_access.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace pcl::ccaa {

/** One start algorithm and the filter behind it. A step that makes internal points
 * fewer is taken back. */
bool
Chain::applyStart(std::size_t number)
{
  report_.stages.emplace_back();
  ChainStageReport& stage = report_.stages.back();
  stage.name = startName(number);
  Triangles made;
  if (!construct(number, made))
    return false;
  if (number > 0 && made.empty()) {
    run_.weight_done += FILTER_WEIGHT;
    stage.internal_points = report_.internal_points;
    return true;
  }
  ChainMesh given = joined(number, std::move(made));
  ChainMesh left;
  if (!filterTriangles(given, left))
    return false;
  stage.internal_points = countInternalPoints(left.roles);
  stage.kept = number == 0 || stage.internal_points >= report_.internal_points;
  if (!stage.kept)
    return true;
  report_.internal_points = stage.internal_points;
  report_.connected_points = countConnectedPoints(left.roles);
  run_.current = std::move(left);
  return true;
}

/** What the filter is to judge: the triangles there are and those just made. */
ChainMesh
Chain::joined(std::size_t number, Triangles made) const
{
  ChainMesh given = run_.current;
  if (number == 0) {
    given.labels.assign(made.size(), 0);
    given.triangles = std::move(made);
    return given;
  }
  given.mesh = std::make_shared<PolygonMesh>();
  given.mesh->cloud = run_.current.mesh->cloud;
  given.adjacency = nullptr;
  keepOnly(input_.starts[number]->keptTriangles(), given);
  appendNewTriangles(
      made, static_cast<std::uint8_t>(number), given.triangles, given.labels);
  return given;
}

/** One stage with the chain's settings and progress. \param[out] seconds that it took
 * \return false when it failed or was cancelled */
template <typename Body>
bool
Chain::runStage(const std::string& name,
                double weight,
                const StageSettings& settings,
                double& seconds,
                const Body& body)
{
  StageProgress progress = run_.beginStage(name, weight);
  if (!progress.report(0))
    return false;
  const StageClock clock;
  const ScopedSettings scoped(settings, input_.threads, run_.sides, progress);
  if (!body())
    return false;
  seconds = clock.seconds();
  return progress.report(1);
}

/** What the start algorithm adds, as triangles. */
bool
Chain::construct(std::size_t number, Triangles& made)
{
  ChainStageReport& stage = report_.stages.back();
  const auto body = [&] { return constructFrom(number, made); };
  const bool is_made = runStage(
      stage.name, START_WEIGHT, input_.starts[number]->settings(), stage.seconds, body);
  report_.start_seconds += stage.seconds;
  if (is_made && number == 0 && made.empty())
    PCL_WARN("[pcl::ConsecutiveReconstruction::performReconstruction] the start "
             "algorithm made no triangle (%zu points)\n",
             run_.points.usable->size());
  return is_made;
}

/** A completion is given the mesh there is, another algorithm the points that are still
 * open. */
bool
Chain::constructFrom(std::size_t number, Triangles& made)
{
  ChainPart& part = *input_.starts[number];
  if (part.completes()) {
    ChainMesh* const partial = number == 0 ? nullptr : &run_.current;
    if (!complete(partial, part, made))
      return false;
    if (partial != nullptr) {
      const auto* kept = part.keptTriangles();
      const auto count = kept ? kept->size() : partial->triangles.size();
      made.erase(made.begin(), made.begin() + std::ptrdiff_t(count));
    }
    return true;
  }
  ChainSelection selection;
  selection.chosen = number == 0 ? run_.points.usable : selectOpenPoints(run_);
  selection.is_part = number > 0 || run_.points.is_selection;
  selection.has_gaps = run_.points.skipped > 0;
  if (selection.chosen->size() < 3)
    return true;
  StageOutput output;
  const bool speaks_of_places = part.construct(selection, output);
  if (part.takesHandoff())
    made = std::move(output.handoff.made);
  else
    report_.invalid_polygons +=
        makeTriangles(output.polygons,
                      speaks_of_places ? selection.chosen.get() : nullptr,
                      run_.point_count,
                      run_.loop(),
                      made);
  return true;
}

bool
Chain::filterTriangles(ChainMesh& given, ChainMesh& left)
{
  ChainStageReport& stage = report_.stages.back();
  const std::size_t given_count = given.labels.size();
  const auto body = [&] {
    if (filter_.apply(given, run_, left))
      return true;
    PCL_ERROR("[pcl::ConsecutiveReconstruction::performReconstruction] the filter "
              "returned what it was not given (%zu triangles given, %zu polygons "
              "returned)\n",
              given_count,
              left.mesh->polygons.size());
    return false;
  };
  const bool is_done =
      runStage("filter", FILTER_WEIGHT, filter_.settings(), stage.filter_seconds, body);
  report_.filter_seconds += stage.filter_seconds;
  takeSides(filter_.settings());
  return is_done;
}

bool
Chain::applyBase()
{
  ChainMesh& current = run_.current;
  ChainPart* const base = input_.base.get();
  // Who may replace triangles can cut a one-sided region; who keeps them all cannot.
  const bool is_one_sided =
      base != nullptr && base->keptTriangles() == nullptr && filter_.leftOneSided();
  if (is_one_sided)
    PCL_WARN("[pcl::ConsecutiveReconstruction::performReconstruction] not completed: a "
             "region is one-sided (%zu triangles)\n",
             current.labels.size());
  if (base != nullptr && !is_one_sided) {
    report_.stages.emplace_back();
    report_.stages.back().name = "base";
    Triangles triangles;
    if (!runBase(&current, BASE_WEIGHT, triangles))
      return false;
    takeOver(std::move(triangles),
             base->keptTriangles(),
             static_cast<std::uint8_t>(input_.starts.size()),
             current);
    report_.stages.back().seconds = report_.base_seconds;
  }
  const std::size_t connected = countConnectedPoints(current.roles);
  report_.free_points = report_.points - std::min(report_.points, connected);
  return true;
}

/** The base algorithm, in the chain or alone; its time goes to base_seconds. */
bool
Chain::runBase(ChainMesh* partial, double weight, Triangles& triangles)
{
  const auto body = [&] { return complete(partial, *input_.base, triangles); };
  const StageSettings settings = input_.base->settings();
  const bool is_done = runStage("base", weight, settings, report_.base_seconds, body);
  takeSides(settings);
  report_.doubts = input_.base->topologyDoubts();
  return is_done;
}

/** What told the outer side in the last stage that can say. */
void
Chain::takeSides(const StageSettings& settings)
{
  if (settings.sides != nullptr)
    result_.sides = settings.sides->getSideTally();
}

/** \return whether the completion kept to the contract of MeshCompletion */
bool
Chain::complete(ChainMesh* partial, ChainPart& completion, Triangles& triangles) const
{
  StageOutput output;
  const bool hands = completion.takesHandoff();
  if (partial != nullptr && hands) {
    output.handoff.given = &partial->triangles;
    output.handoff.adjacency = std::move(partial->adjacency);
  }
  else if (partial != nullptr)
    writePolygons(partial->triangles, run_.loop(), partial->mesh->polygons);
  completion.complete(partial == nullptr || hands ? nullptr : partial->mesh,
                      run_.points.usable,
                      output);
  if (partial != nullptr)
    partial->mesh->polygons = {};
  if (cancelled())
    return false;
  auto made = hands ? std::move(output.handoff.made)
                    : readTriangles(output.polygons, run_.point_count, run_.loop());
  if (made &&
      (partial == nullptr ||
       keepsTriangles(
           partial->triangles, completion.keptTriangles(), *made, run_.loop()))) {
    triangles = std::move(*made);
    return true;
  }
  PCL_ERROR("[pcl::ConsecutiveReconstruction::performReconstruction] the algorithm of "
            "stage '%s' did not keep the given triangles (%zu given, %zu polygons "
            "returned)\n",
            run_.stage.c_str(),
            partial ? partial->triangles.size() : 0,
            output.polygons.size());
  return false;
}

} // namespace pcl::ccaa
