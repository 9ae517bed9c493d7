// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what was filled anew becomes the model of a repair.

#include "pass/surface_takeover.h"

#include "icadm/pinched_points.h"
#include "survey/survey_stages.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl::repair {

namespace {

template <typename T>
void
keepMarked(const std::vector<bool>& is_marked, std::vector<T>& list)
{
  std::size_t left = 0;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (is_marked[i])
      list[left++] = list[i];
  list.resize(left);
}

/** Triangles of each hole; one that became part of another hole is none any more. */
void
recount(RepairReport& report)
{
  std::vector<std::size_t> triangles(report.holes.size(), 0);
  for (const std::size_t hole : report.hole_of)
    if (hole != NONE)
      ++triangles[hole];
  std::vector<std::size_t> number(report.holes.size(), NONE);
  std::size_t left = 0;
  for (std::size_t h = 0; h < report.holes.size(); ++h) {
    report.holes[h].triangles = triangles[h];
    if (triangles[h] == 0 && report.holes[h].open == OpenReason::NONE)
      continue;
    number[h] = left;
    report.holes[left++] = report.holes[h];
  }
  report.holes.resize(left);
  report.origins.clear();
  for (std::size_t& hole : report.hole_of) {
    hole = hole == NONE ? NONE : number[hole];
    report.origins.push_back(hole == NONE ? TriangleOrigin::INPUT
                                          : originOf(report.holes[hole].filling));
  }
}

} // namespace

void
takeOver(GrowingSurface surface, const Course& course)
{
  course.memory.forgetNear(surface.gone());
  const ccaa::LoopContext& context = course.context;
  ModelSurvey& survey = course.survey;
  RepairReport& report = course.report;
  IncompleteModel& model = survey.model;
  ccaa::spend(context.control, surface.triangles.size());
  keepMarked(surface.is_there, surface.triangles);
  keepMarked(surface.is_there, surface.hole);
  report.hole_of = std::move(surface.hole);
  recount(report);
  model.triangles = std::move(surface.triangles);
  model.positions = std::move(surface.positions);
  model.point_of_vertex = std::move(surface.point_of_vertex);
  if (!model.viewpoints.empty())
    model.viewpoints.resize(
        model.positions.size(),
        Position::Constant(std::numeric_limits<double>::quiet_NaN()));
  const std::vector<pcl::index_t> number = separatePinches(context, model);
  const auto of_input =
      number.begin() + static_cast<std::ptrdiff_t>(course.input_vertices);
  course.input_vertices -= // those that were welded
      static_cast<std::size_t>(std::count(number.begin(), of_input, pcl::UNAVAILABLE));
  const std::vector<bool> none_used(model.free_points.size(), false);
  survey = putInOrder(std::move(survey), none_used, context);
}

} // namespace pcl::repair
