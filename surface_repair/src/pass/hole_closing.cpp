// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one pass over all holes that are to be closed.

#include "pass/hole_closing.h"

#include "icadm/model_assembly.h"
#include "listing/sample_shares.h"
#include "pass/regions_closing.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl::repair {

namespace {

/** The cap of holes that are closed together. */
Cap
capOf(const HoleList& list, const std::vector<std::size_t>& holes, Cap usual)
{
  const auto cap_of = [&](std::size_t hole) {
    const Cap cap = list.holes[hole].cap;
    return cap == Cap::AUTO ? usual : cap;
  };
  const bool all_flat = std::all_of(holes.begin(), holes.end(), [&](std::size_t hole) {
    return cap_of(hole) == Cap::FLAT;
  });
  if (all_flat)
    return Cap::FLAT;
  const OpenHole& first = list.holes[holes.front()];
  const bool is_loop =
      holes.size() == 1 && first.loop != NONE && first.other_loop == NONE;
  return is_loop ? cap_of(holes.front()) : Cap::SMOOTH;
}

std::vector<Region>
regionsOf(const HoleList& list, Cap usual)
{
  std::vector<Region> regions;
  for (const std::vector<std::size_t>& holes : list.regions) {
    Region region;
    region.bridge_vertices = list.bridge_vertices;
    for (const std::size_t hole : holes) {
      region.holes.push_back(list.holes[hole].polygon);
      for (const pcl::index_t vertex : region.holes.back().vertices)
        if (const auto on = list.creases.find(vertex); on != list.creases.end())
          region.creases.insert(*on);
      region.is_certain.push_back(list.holes[hole].is_wanted ||
                                  !list.holes[hole].bridges.empty());
    }
    region.cap = capOf(list, holes, usual);
    regions.push_back(std::move(region));
  }
  return regions;
}

/** The patch joins what was closed. \param[in] reported of each of its holes its place
 * in the report */
void
addPatch(const Patch& patch,
         const std::vector<std::size_t>& reported,
         const IncompleteModel& model,
         ClosedHoles& closed,
         RepairLog& log)
{
  std::vector<pcl::index_t> number = patch.rim;
  for (std::size_t v = patch.rim.size(); v < patch.positions.size(); ++v) {
    number.push_back(
        static_cast<pcl::index_t>(model.positions.size() + closed.positions.size()));
    closed.positions.push_back(patch.positions[v]);
    const std::size_t free_point = patch.free_point[v];
    const bool is_own = free_point != NONE && !closed.used[free_point];
    if (is_own) // of two patches at one free point the later one gets a copy
      closed.used[free_point] = true;
    closed.point_of_vertex.push_back(is_own ? model.point_of_free_point[free_point]
                                            : pcl::UNAVAILABLE);
  }
  std::vector<bool> is_counted(patch.positions.size(), false);
  for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
    Triangle triangle = patch.triangles[t];
    for (pcl::index_t& corner : triangle) {
      const auto vertex = static_cast<std::size_t>(corner);
      if (patch.free_point[vertex] != NONE && !is_counted[vertex])
        log.addFreePoint(reported[patch.hole[t]]);
      is_counted[vertex] = true;
      corner = number[vertex];
    }
    closed.triangles.push_back(triangle);
    log.addTriangle(reported[patch.hole[t]]);
  }
}

/** \param[in] holes of the region, in the list */
void
accept(const ClosedRegion& region,
       const std::vector<std::size_t>& holes,
       const HoleList& list,
       const IncompleteModel& model,
       ClosedHoles& closed,
       RepairLog& log)
{
  std::vector<std::size_t> reported(holes.size(), NONE);
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const OpenHole& hole = list.holes[holes[i]];
    if (region.holes[i].open == OpenReason::NONE) {
      reported[i] = log.add(hole, region.holes[i]);
      if (hole.loop == NONE || hole.other_loop != NONE || !list.replaced.empty())
        closed.has_changed_others = true;
      continue;
    }
    for (const pcl::index_t vertex : hole.polygon.vertices)
      if (static_cast<std::size_t>(vertex) < model.positions.size())
        closed.failed[vertex] = {region.holes[i].open, region.holes[i].tries};
  }
  addPatch(region.patch, reported, model, closed, log);
}

/** The model without welded points. */
void
takeBack(Triangles triangles, const ccaa::LoopContext& context, IncompleteModel& model)
{
  model.triangles = std::move(triangles);
  rebuildAdjacency(context, model);
}

template <typename T>
void
append(const std::vector<T>& more, std::vector<T>& list)
{
  list.insert(list.end(), more.begin(), more.end());
}

} // namespace

bool
isObstructed(const Failures& failed, pcl::index_t vertex)
{
  const auto failure = failed.find(vertex);
  return failure != failed.end() && failure->second.open == OpenReason::INTERSECTION;
}

ClosedHoles
closeHoles(const RepairParameters& parameters,
           const CloudFrame& frame,
           const ccaa::LoopContext& context,
           const char* stage,
           HoleList& list,
           ModelSurvey& survey,
           RegionMemory& memory,
           RepairLog& log)
{
  const auto tell = [&](double share) {
    if (context.control != nullptr)
      context.control->report(stage, share);
  };
  tell(0.0);
  Triangles given = list.replaced.empty() ? Triangles() : survey.model.triangles;
  if (!list.replaced.empty())
    weldPinches(list.replaced, context, survey.model);
  std::vector<Region> regions = regionsOf(list, parameters.filling.cap);
  if (survey.guides && survey.guides->free_points) {
    auto shares = shareSamples(
        survey.model, *survey.guides->free_points, regions, context.control);
    for (std::size_t r = 0; r < regions.size(); ++r)
      regions[r].samples = std::move(shares[r]);
  }
  ClosedHoles closed;
  closed.used.assign(survey.model.free_points.size(), false);
  log.beginPass();
  const SurveyGuides none;
  const ClosingPlace place{
      survey.model, survey.guides ? *survey.guides : none, parameters, frame};
  const std::vector<ClosedRegion> regions_closed =
      closeRegions(place, regions, context, memory, tell);
  for (std::size_t r = 0; r < regions.size() && !context.cancelled(); ++r)
    accept(regions_closed[r], list.regions[r], list, survey.model, closed, log);
  if (closed.triangles.empty() && !list.replaced.empty()) {
    takeBack(std::move(given), context, survey.model);
    list.replaced.clear();
  }
  return closed;
}

void
addToModel(const ccaa::LoopContext& context,
           HoleList& list,
           ClosedHoles& closed,
           IncompleteModel& model,
           std::size_t& input_vertices)
{
  const VertexMap slits = slitsBetween(model, closed.triangles);
  if (!slits.empty())
    weldPinches(slits, context, model);
  for (Triangle& triangle : closed.triangles)
    for (pcl::index_t& corner : triangle) {
      const auto slit = slits.find(corner);
      corner = slit == slits.end() ? corner : slit->second;
    }
  append(closed.triangles, model.triangles);
  append(closed.positions, model.positions);
  append(closed.point_of_vertex, model.point_of_vertex);
  if (!model.viewpoints.empty()) // no sensor has measured the new ones
    model.viewpoints.resize(
        model.positions.size(),
        Position::Constant(std::numeric_limits<double>::quiet_NaN()));
  closed.triangles.clear();
  closed.positions.clear();
  closed.point_of_vertex.clear();
  if (list.replaced.empty() && slits.empty()) {
    model.adjacency.follow(
        {}, model.triangles, model.positions.size(), context.threads, context.control);
    return;
  }
  list.replaced.clear();
  const std::vector<pcl::index_t> number = separatePinches(context, model);
  const auto of_input = number.begin() + static_cast<std::ptrdiff_t>(input_vertices);
  input_vertices -=
      static_cast<std::size_t>(std::count(number.begin(), of_input, pcl::UNAVAILABLE));
  Failures failed;
  for (const auto& [vertex, failure] : closed.failed)
    failed.emplace(number[static_cast<std::size_t>(vertex)], failure);
  closed.failed = std::move(failed);
  for (auto& [one, other] : closed.failed_pairs) {
    one = number[static_cast<std::size_t>(one)];
    other = number[static_cast<std::size_t>(other)];
  }
}

} // namespace pcl::repair
