// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: patches that are in the way of another one.

#include "pass/hole_reopening.h"

#include "pass/surface_takeover.h"
#include "pass/surface_tries.h"
#include "patch/opening.h"
#include "region/opening_closing.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl::repair {

namespace {

/** Rings of new triangles around a hole that are opened, one try after the other. */
constexpr std::array<int, 4> WIDER_RINGS = {1, 2, 4, 8};
/** Edges of a hole that is opened wider, at most. Of 3300 openings in scans and damaged
 * models 229 could be filled, of up to 93 edges; 62 had more than 256. */
constexpr std::size_t LONGEST_REOPENED = 256;
/** What is looked at around a hole, in its extents. */
constexpr double AROUND_EXTENTS = 3.0;
/** Operations for a triangle around a hole each time that some are opened. */
constexpr std::uint64_t WIDENING_WORK = 5;
/** At least, in mean edges of the hole. */
constexpr double AROUND_EDGES = 20.0;

/** How a hole may be closed that was opened wider. */
struct ReopenedHole {
  ClosedOpening closed;
  ccaa::Box seen; /**< all that it depends on */
};

/** Closes one hole. */
class HoleReopening {
public:
  HoleReopening(const BoundaryLoop& loop,
                const Course& course,
                const ccaa::LoopContext& context,
                const GrowingSurface& surface)
  : loop_(loop)
  , parameters_(course.parameters)
  , frame_(course.frame)
  , context_(context)
  , surface_(surface)
  {}

  ReopenedHole
  run()
  {
    ReopenedHole result;
    result.closed = close();
    result.seen = around_;
    return result;
  }

private:
  ClosedOpening
  close();

  const BoundaryLoop& loop_;
  const RepairParameters& parameters_;
  const CloudFrame& frame_;
  const ccaa::LoopContext& context_;
  const GrowingSurface& surface_;
  ccaa::Box around_;
  ModelPart part_;
};

/** \return still open where no way was found */
ClosedOpening
HoleReopening::close()
{
  ccaa::Box box;
  for (const Position& point : loop_.curve.points)
    box.extend(point);
  const double edge = loop_.length / static_cast<double>(loop_.vertices.size());
  around_ = ccaa::widened(
      box, std::max(AROUND_EXTENTS * box.diagonal().norm(), AROUND_EDGES * edge));
  part_ = surface_.part(surface_.near(around_, context_.control), context_.control);
  ClosedOpening closed;
  closed.outcome.open = OpenReason::INTERSECTION;
  if (context_.cancelled())
    return closed;
  std::vector<pcl::index_t> hole;
  std::vector<bool> at_hole(part_.triangles.size(), false);
  for (const pcl::index_t vertex : loop_.vertices) {
    const auto found = part_.number_of.find(vertex);
    if (found == part_.number_of.end())
      return closed;
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
    closed =
        closeOpening(opening, part_, around_, parameters_, frame_, context_, surface_);
    if (closed.outcome.open == OpenReason::NONE)
      break;
  }
  return closed;
}

} // namespace

void
reopenHoles(const Failures& failed, const Course& course)
{
  ModelSurvey& survey = course.survey;
  GrowingSurface surface(survey.model, course.report.hole_of, course.context.control);
  std::vector<const BoundaryLoop*> loops;
  for (const BoundaryLoop& loop : survey.loops)
    if (loop.vertices.size() <= LONGEST_REOPENED &&
        std::any_of(loop.vertices.begin(), loop.vertices.end(), [&](pcl::index_t v) {
          return isObstructed(failed, v);
        }))
      loops.push_back(&loop);
  const auto tryOut = [&](std::size_t i, const ccaa::LoopContext& context) {
    return HoleReopening(*loops[i], course, context, surface).run();
  };
  const auto make = [&](std::size_t i, const ReopenedHole& reopened) -> ccaa::Box {
    HoleOutcome outcome = reopened.closed.outcome;
    if (outcome.open != OpenReason::NONE)
      return {};
    OpenHole hole;
    hole.polygon = polygonOf(*loops[i]);
    outcome.bridges.clear(); // of another numbering
    const std::size_t number = course.log.add(hole, outcome);
    return surface.replace(reopened.closed.replacement, number);
  };
  makeInTurn(loops.size(), course.context, tryOut, make);
  if (course.context.cancelled())
    return;
  if (surface.hasChanged())
    takeOver(std::move(surface), course);
}

} // namespace pcl::repair
