// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: islands that are too small to be joined by bridges.

#include "crumb/crumbs.h"

#include "crumb/crumb_laying.h"
#include "icadm/model_assembly.h"
#include "icadm/vertex_numbers.h"
#include "pass/surface_takeover.h"
#include "pass/surface_tries.h"
#include "region/region_parts.h"
#include "survey/survey_stages.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

namespace pcl::repair {

namespace {

/** Share of the largest island's triangles up to which one is a crumb, as bodies with
 * eight such islands seldom came out right by bridges, and up to which it is laid where
 * bridges have not joined it. */
constexpr double LARGEST_SHARE = 0.03;
constexpr double LARGEST_LAID = 0.1;

/** Of each island: a disc, small enough. */
std::vector<bool>
areCrumbs(const IncompleteModel& model, std::size_t fewer_than, double largest_share)
{
  std::size_t largest = 0;
  for (const Island& island : model.islands)
    largest = std::max(largest, island.triangles);
  std::vector<std::size_t> rim_edges(model.islands.size(), 0);
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    for (int corner = 0; corner < 3; ++corner)
      if (model.adjacency.across(static_cast<pcl::index_t>(t), corner) < 0)
        ++rim_edges[model.island_of[t]];
  std::vector<std::size_t> vertices(model.islands.size(), 0);
  for (std::size_t v = 0; v < model.positions.size(); ++v) {
    const pcl::index_t first = *model.adjacency.begin(static_cast<pcl::index_t>(v));
    ++vertices[model.island_of[static_cast<std::size_t>(first)]];
  }
  std::vector<bool> are_crumbs(model.islands.size(), false);
  for (std::size_t i = 0; i < model.islands.size(); ++i) {
    const std::size_t triangles = model.islands[i].triangles;
    // A disc of n triangles and a rim of b edges has (n + b) / 2 + 1 vertices.
    are_crumbs[i] =
        triangles < fewer_than && !model.islands[i].one_sided &&
        static_cast<double>(triangles) < largest_share * static_cast<double>(largest) &&
        2 * vertices[i] == triangles + rim_edges[i] + 2;
  }
  return are_crumbs;
}

/** The triangles of each island that may be laid, ascending. */
std::vector<std::vector<std::size_t>>
crumbsOf(const IncompleteModel& model, std::size_t fewer_than)
{
  const std::vector<bool> are_crumbs = areCrumbs(model, fewer_than, LARGEST_LAID);
  std::map<std::size_t, std::vector<std::size_t>> of_island;
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    if (are_crumbs[model.island_of[t]])
      of_island[model.island_of[t]].push_back(t);
  std::vector<std::vector<std::size_t>> crumbs;
  for (auto& [island, triangles] : of_island)
    crumbs.push_back(std::move(triangles));
  return crumbs;
}

/** Split a list in two by a mark of each entry; the marked ones are returned. */
template <typename T>
std::vector<T>
takeMarked(const std::vector<bool>& is_marked, std::vector<T>& list)
{
  std::vector<T> taken, left;
  for (std::size_t i = 0; i < list.size(); ++i)
    (is_marked[i] ? taken : left).push_back(list[i]);
  list = std::move(left);
  return taken;
}

/** Free points stay what they are. */
void
keepInOrder(const ccaa::LoopContext& context, ModelSurvey& survey)
{
  IncompleteModel& model = survey.model;
  rebuildAdjacency(context, model);
  const std::vector<bool> none_used(model.free_points.size(), false);
  survey = putInOrder(std::move(survey), none_used, context);
}

template <typename T>
void
insertAt(std::size_t place, const std::vector<T>& more, std::vector<T>& list)
{
  list.insert(
      list.begin() + static_cast<std::ptrdiff_t>(place), more.begin(), more.end());
}

/** \param[in] are_crumbs of each island */
Crumbs
takeOut(const std::vector<bool>& are_crumbs,
        const ccaa::LoopContext& context,
        ModelSurvey& survey)
{
  Crumbs crumbs;
  IncompleteModel& model = survey.model;
  std::vector<bool> is_taken(model.triangles.size(), false);
  std::vector<bool> is_moved(model.positions.size(), false);
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    if (are_crumbs[model.island_of[t]]) {
      is_taken[t] = true;
      crumbs.places.push_back(t);
      for (const pcl::index_t corner : model.triangles[t])
        is_moved[static_cast<std::size_t>(corner)] = true;
    }
  if (crumbs.places.empty())
    return crumbs;
  crumbs.triangles = takeMarked(is_taken, model.triangles);
  numberWithoutGaps(model.positions.size(), crumbs.triangles);
  numberWithoutGaps(model.positions.size(), model.triangles);
  crumbs.positions = takeMarked(is_moved, model.positions);
  crumbs.point_of_vertex = takeMarked(is_moved, model.point_of_vertex);
  if (!model.viewpoints.empty())
    crumbs.viewpoints = takeMarked(is_moved, model.viewpoints);
  keepInOrder(context, survey);
  return crumbs;
}

} // namespace

Crumbs
setCrumbsAside(std::size_t fewer_than,
               const ccaa::LoopContext& context,
               ModelSurvey& survey)
{
  return takeOut(areCrumbs(survey.model, fewer_than, LARGEST_SHARE), context, survey);
}

Crumbs
setUnjoinedAside(std::size_t fewer_than,
                 const std::set<pcl::index_t>& unjoined,
                 const Course& course)
{
  const IncompleteModel& model = course.survey.model;
  const std::vector<bool> are_small = areCrumbs(model, fewer_than, LARGEST_LAID);
  std::vector<bool> are_new(model.islands.size(), false);
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    if (course.report.hole_of[t] != NONE)
      are_new[model.island_of[t]] = true;
  std::vector<bool> wait(model.islands.size(), false);
  for (const pcl::index_t vertex : unjoined) {
    const auto triangle = static_cast<std::size_t>(*model.adjacency.begin(vertex));
    const std::size_t island = model.island_of[triangle];
    wait[island] = are_small[island] && !are_new[island];
  }
  Crumbs crumbs = takeOut(wait, course.context, course.survey);
  course.log.leaveOut(crumbs.triangles.size());
  course.input_vertices -= crumbs.positions.size();
  return crumbs;
}

void
putCrumbsBack(const Crumbs& crumbs, const Course& course)
{
  course.log.takeIn(crumbs.triangles.size());
  std::size_t& input_vertices = course.input_vertices;
  IncompleteModel& model = course.survey.model;
  const auto added = static_cast<pcl::index_t>(crumbs.positions.size());
  const auto first = static_cast<pcl::index_t>(input_vertices);
  for (Triangle& triangle : model.triangles)
    for (pcl::index_t& corner : triangle)
      corner += corner < first ? 0 : added;
  Triangles all;
  auto next = model.triangles.begin();
  for (std::size_t i = 0; i < crumbs.triangles.size(); ++i) {
    while (all.size() < crumbs.places[i])
      all.push_back(*next++);
    Triangle triangle = crumbs.triangles[i];
    for (pcl::index_t& corner : triangle)
      corner += first;
    all.push_back(triangle);
  }
  all.insert(all.end(), next, model.triangles.end());
  model.triangles = std::move(all);
  insertAt(input_vertices, crumbs.positions, model.positions);
  insertAt(input_vertices, crumbs.point_of_vertex, model.point_of_vertex);
  if (!model.viewpoints.empty())
    insertAt(input_vertices, crumbs.viewpoints, model.viewpoints);
  input_vertices += crumbs.positions.size();
  keepInOrder(course.context, course.survey);
}

void
layCrumbs(std::size_t fewer_than, const Course& course)
{
  const IncompleteModel& model = course.survey.model;
  const std::vector<std::vector<std::size_t>> crumbs = crumbsOf(model, fewer_than);
  if (crumbs.empty())
    return;
  std::size_t size = 0;
  for (const std::vector<std::size_t>& crumb : crumbs)
    size += crumb.size();
  std::uint64_t work_left = workFor(size);
  const double edge =
      ccaa::meanEdge(model.triangles, model.triangles.size(), model.positions);
  ccaa::RunControl* const control = course.context.control;
  GrowingSurface surface(model, course.report.hole_of, control);
  const auto isPatch = [&](const std::vector<std::size_t>& crumb) {
    return surface.hole[crumb.front()] != NONE; // that hangs on bridges alone
  };
  const auto tryOut = [&](std::size_t i, const ccaa::LoopContext& context) {
    const std::vector<std::size_t>& crumb = crumbs[i];
    const bool is_fin = model.islands[model.island_of[crumb.front()]].is_fin;
    return isPatch(crumb) || is_fin || work_left == 0
               ? LaidCrumb()
               : layCrumb(crumb, edge, course, context.control, surface);
  };
  const auto make = [&](std::size_t i, const LaidCrumb& laid) {
    const std::vector<std::size_t>& crumb = crumbs[i];
    if (isPatch(crumb))
      return surface.remove(crumb);
    const bool is_laid = laid.ring && work_left > 0;
    work_left -= std::min(work_left, laid.work);
    if (!is_laid)
      return surface.remove(surface.meeting(crumb, control));
    ccaa::Box changed = surface.replace(*laid.ring, laid.hole);
    for (const auto& [t, triangle] : laid.crumb) {
      surface.triangles[t] = triangle;
      changed.extend(ccaa::boxOf(ccaa::cornersOf(triangle, surface.positions)));
    }
    return changed;
  };
  makeInTurn(crumbs.size(), course.context, tryOut, make);
  if (course.context.cancelled())
    return;
  if (surface.hasChanged())
    takeOver(std::move(surface), course);
}

} // namespace pcl::repair
