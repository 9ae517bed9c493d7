// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: patches that are in the way of another one.

#include "pass/hole_reopening.h"

#include "pass/surface_takeover.h"
#include "patch/opening.h"
#include "region/opening_closing.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl::repair {

namespace {

/** Rings of new triangles around a hole that are opened, one try after the other. */
constexpr std::array<int, 4> WIDER_RINGS = {1, 2, 4, 8};
/** What is looked at around a hole, in its extents. */
constexpr double AROUND_EXTENTS = 3.0;
/** Operations for a triangle around a hole each time that some are opened. */
constexpr std::uint64_t WIDENING_WORK = 5;
/** At least, in mean edges of the hole. */
constexpr double AROUND_EDGES = 20.0;

/** Closes one hole. */
class HoleReopening {
public:
  HoleReopening(const BoundaryLoop& loop, const Course& course, GrowingSurface& surface)
  : loop_(loop)
  , parameters_(course.parameters)
  , frame_(course.frame)
  , context_(course.context)
  , surface_(surface)
  {}

  /** \param[in] of_hole that new triangles close \return how; still open where no way
   * was found */
  HoleOutcome
  run(std::size_t of_hole);

private:
  const BoundaryLoop& loop_;
  const RepairParameters& parameters_;
  const CloudFrame& frame_;
  const ccaa::LoopContext& context_;
  GrowingSurface& surface_;
  ccaa::Box around_;
  ModelPart part_;
};

HoleOutcome
HoleReopening::run(std::size_t of_hole)
{
  ccaa::Box box;
  for (const Position& point : loop_.curve.points)
    box.extend(point);
  const double edge = loop_.length / static_cast<double>(loop_.vertices.size());
  around_ = ccaa::widened(
      box, std::max(AROUND_EXTENTS * box.diagonal().norm(), AROUND_EDGES * edge));
  part_ = surface_.part(surface_.near(around_, context_.control), context_.control);
  HoleOutcome outcome;
  outcome.open = OpenReason::INTERSECTION;
  if (context_.cancelled())
    return outcome;
  std::vector<pcl::index_t> hole;
  std::vector<bool> at_hole(part_.triangles.size(), false);
  for (const pcl::index_t vertex : loop_.vertices) {
    const auto found = part_.number_of.find(vertex);
    if (found == part_.number_of.end())
      return outcome;
    hole.push_back(found->second);
    const auto& adjacency = part_.model.adjacency;
    for (const pcl::index_t* triangle = adjacency.begin(hole.back());
         triangle != adjacency.end(hole.back());
         ++triangle)
      at_hole[static_cast<std::size_t>(*triangle)] =
          part_.is_new[static_cast<std::size_t>(*triangle)];
  }
  std::size_t opened = 0;
  for (const int rings : WIDER_RINGS) {
    if (!ccaa::spend(context_.control, WIDENING_WORK * part_.triangles.size()))
      break;
    const Opening opening =
        openFrom(part_, hole, ringsAround(part_, at_hole, rings - 1));
    const auto now = static_cast<std::size_t>(
        std::count(opening.is_open.begin(), opening.is_open.end(), true));
    if (now == opened)
      break; // nothing more can be opened
    opened = now;
    outcome = closeOpening(
        opening, part_, around_, parameters_, frame_, context_, of_hole, surface_);
    if (outcome.open == OpenReason::NONE)
      break;
  }
  return outcome;
}

} // namespace

void
reopenHoles(const Failures& failed, const Course& course)
{
  ModelSurvey& survey = course.survey;
  GrowingSurface surface(survey.model, course.report.hole_of, course.context.control);
  for (const BoundaryLoop& loop : survey.loops) {
    const bool has_failed =
        std::any_of(loop.vertices.begin(), loop.vertices.end(), [&](pcl::index_t v) {
          return isObstructed(failed, v);
        });
    if (!has_failed)
      continue;
    const HoleOutcome outcome =
        HoleReopening(loop, course, surface).run(course.report.holes.size());
    if (course.context.cancelled())
      return;
    if (outcome.open != OpenReason::NONE)
      continue;
    OpenHole hole;
    hole.polygon = polygonOf(loop);
    HoleOutcome told = outcome;
    told.bridges.clear(); // of another numbering
    course.log.add(hole, told);
  }
  if (surface.hasChanged())
    takeOver(std::move(surface), course);
}

} // namespace pcl::repair
