// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: holes that bridges connect are closed together.

#include "repair/region_closing.h"

#include "fairing/flat_cap.h"
#include "fairing/refinement.h"
#include "fairing/relaxation.h"
#include "fairing/sample_growth.h"
#include "filling/completion_filling.h"
#include "junction/depth_jump.h"
#include "repair/fill_strategy.h"
#include "repair/filling_choice.h"
#include "repair/patch_assembly.h"
#include "repair/patch_mending.h"
#include "repair/relaxation_rollback.h"
#include "repair/taken_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

namespace pcl {
namespace repair {

namespace {

/** Rings around what runs into something that go back, one try after the other. */
constexpr std::array<std::size_t, 4> CALMED_RINGS = {0, 2, 4, 8};
/** Triangles of a fill that run into something before it is refined: with more, none
 * has come out free. */
constexpr std::size_t MOST_IN_THE_WAY = 64;
/** Operations of a region: at least, and for each of its edges and samples by their
 * logarithm. The dearest of the scans' holes take a fifth of that. */
constexpr std::uint64_t LEAST_WORK = 100000000;
constexpr double WORK = 100000.0;

class RegionClosing {
public:
  RegionClosing(const ClosingPlace& place,
                const Region& region,
                const SurfaceObstacle& obstacle,
                const ccaa::LoopContext& context)
  : place_(place)
  , region_(region)
  , obstacle_(obstacle)
  , control_(context.control, workFor(region))
  , context_{context.threads, &control_}
  , strategy_(region.holes.size(), 0)
  , completed_(region.holes.size(), false)
  , flat_(isToBeFlat())
  {
    result_.holes.resize(region.holes.size());
  }

  ClosedRegion
  run();

private:
  bool
  isToBeFlat() const;
  void
  leavePierced();
  bool
  hasSamples(const HolePolygon& hole) const;
  void
  subdivide();
  const std::vector<ChosenFilling>&
  fillsOf(const FillStrategy& strategy);
  void
  fill();
  void
  leaveDepthJumps();
  void
  assemble();
  void
  fair();
  void
  relax();
  void
  findCollisions();
  bool
  verify();
  void
  keepForMending();
  void
  mend();
  void
  leaveCostly(bool is_settled);
  bool
  any(bool FillStrategy::*wanted) const;
  void
  tryNext(std::size_t hole, OpenReason reason);

  const ClosingPlace& place_;
  const Region& region_;
  const SurfaceObstacle& obstacle_;
  ccaa::RunControl control_;
  const ccaa::LoopContext context_;
  std::vector<std::size_t> strategy_; /**< of each hole: place in FILL_STRATEGIES */
  std::vector<FilledPart> parts_; /**< of all holes, whether they are filled or not */
  std::vector<bool> completed_;   /**< of each hole: free points are vertices */
  Patch grown_;                   /**< over samples */
  std::vector<std::size_t> grown_fills_; /**< it is made of: of each part */
  bool flat_;                            /**< all lies in the plane of its rim */
  std::array<std::vector<ChosenFilling>, 3>
      fillings_; /**< of the parts: plain, avoiding, and basic ones avoiding */
  ClosedRegion result_;
  std::vector<Patch> obstructed_patches_; /**< of a single hole, as far as tried */
  std::vector<std::size_t> obstructed_;   /**< triangles of the patch as it is */
};

/** What the user wants, or else what the rim is and whether free points speak against
 * it. */
bool
RegionClosing::isToBeFlat() const
{
  if (region_.cap != Cap::AUTO)
    return region_.cap == Cap::FLAT;
  const HolePolygon& hole = region_.holes.front();
  return isBase(hole.curve,
                place_.model,
                *place_.model.adjacency.begin(hole.vertices.front())) &&
         region_.samples.empty() && !hasSamples(hole);
}

/** Whether free points tell the surface within a large rim: such as were given for
 * that, or enough of them to be its vertices. */
bool
RegionClosing::hasSamples(const HolePolygon& hole) const
{
  const FreePointField* free_points = place_.guides.free_points.get();
  if (free_points == nullptr)
    return false;
  const RimPlane plane = planeOf(hole.curve);
  const std::vector<pcl::index_t> near =
      free_points->within(plane.center, 0.5 * plane.size);
  const bool has_given = std::any_of(near.begin(), near.end(), [&](pcl::index_t i) {
    return place_.model.point_of_free_point[static_cast<std::size_t>(i)] ==
           pcl::UNAVAILABLE;
  });
  if (has_given || near.empty())
    return has_given;
  const TakenEdges taken(place_.model);
  return fillHole(fillingTask(hole, taken, nullptr, context_.control),
                  place_.parameters.filling.choice,
                  free_points)
             .method == CompletionFilling().name();
}

/** Each triangle at an edge that the surface crosses would meet it: nothing is tried.
 */
void
RegionClosing::leavePierced()
{
  const auto given = static_cast<pcl::index_t>(place_.model.positions.size());
  for (std::size_t h = 0; h < region_.holes.size(); ++h) {
    const HolePolygon& hole = region_.holes[h];
    const auto is_given = [&](std::size_t from, std::size_t to) {
      const pcl::index_t a = hole.vertices[from], b = hole.vertices[to];
      return a < given && b < given && areJoined(place_.model, a, b);
    };
    const OpenReason reason = crossedEdges(hole.curve, is_given, obstacle_);
    if (reason == OpenReason::NONE)
      continue;
    strategy_[h] = GIVEN_UP;
    result_.holes[h].open = reason;
  }
}

/** ICM2 -> ICM1 (4.5). */
void
RegionClosing::subdivide()
{
  const SubdivisionGuides guides{place_.guides.free_points.get(),
                                 place_.guides.surface.get()};
  std::size_t next = place_.model.positions.size() + region_.bridge_vertices;
  for (std::size_t h = 0; h < region_.holes.size(); ++h) {
    // Bridges would follow the surface around: out of the plane, or past the samples.
    if (flat_ || !region_.samples.empty() || strategy_[h] == GIVEN_UP ||
        region_.holes[h].second_loop > 0) {
      parts_.push_back({region_.holes[h], {}, h});
      continue;
    }
    DividedHole divided = divideHole(region_.holes[h],
                                     static_cast<pcl::index_t>(next),
                                     place_.parameters.survey,
                                     guides,
                                     context_);
    next += divided.new_vertices.size();
    for (HolePolygon& polygon : divided.holes)
      parts_.push_back({std::move(polygon), {}, h});
    result_.holes[h].bridges = std::move(divided.bridges);
  }
}

/** Which of the fills serves a strategy. */
std::size_t
fillsIn(const FillStrategy& strategy)
{
  return strategy.without_free ? 2 : strategy.avoids ? 1 : 0;
}

/** The fills of all parts in one way or the other: made once, they serve every
 * strategy (4.7). */
const std::vector<ChosenFilling>&
RegionClosing::fillsOf(const FillStrategy& strategy)
{
  std::vector<ChosenFilling>& fillings = fillings_[fillsIn(strategy)];
  if (!fillings.empty())
    return fillings;
  TakenEdges taken(place_.model);
  for (const FilledPart& part : parts_)
    taken.addPolygon(part.polygon);
  for (const FilledPart& part : parts_) {
    fillings.emplace_back();
    if (strategy_[part.hole] == GIVEN_UP)
      continue;
    fillings.back() =
        fillHole(fillingTask(part.polygon,
                             taken,
                             strategy.avoids ? &obstacle_ : nullptr,
                             context_.control),
                 strategy.without_free || flat_ ? FillingChoice::MINIMUM_WEIGHT
                                                : place_.parameters.filling.choice,
                 place_.guides.free_points.get());
    if (fillings.back().filling.closed())
      taken.addFilling(part.polygon, fillings.back().filling);
  }
  return fillings;
}

void
RegionClosing::fill()
{
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    FilledPart& part = parts_[p];
    std::size_t& strategy = strategy_[part.hole];
    if (strategy == GIVEN_UP)
      continue;
    HoleOutcome& outcome = result_.holes[part.hole];
    const bool avoiding = FILL_STRATEGIES[strategy].avoids;
    const ChosenFilling& chosen = fillsOf(FILL_STRATEGIES[strategy])[p];
    part.filling = chosen.filling;
    outcome.filling = chosen.method;
    if (chosen.method == CompletionFilling().name())
      completed_[part.hole] = true;
    if (chosen.filling.closed())
      continue;
    ++outcome.tries;
    strategy = GIVEN_UP;
    outcome.open = avoiding ? OpenReason::INTERSECTION : OpenReason::NO_FILLING;
  }
}

/** A surface that the sensor would see edge-on was never measured (free points are). */
void
RegionClosing::leaveDepthJumps()
{
  for (std::size_t hole = 0; hole < strategy_.size(); ++hole) {
    const bool is_certain = !region_.is_certain.empty() && region_.is_certain[hole];
    if (strategy_[hole] == GIVEN_UP || is_certain || completed_[hole])
      continue;
    FillArea fill;
    for (const FilledPart& part : parts_)
      if (part.hole == hole)
        addFill(part, fill);
    const HolePolygon& polygon = region_.holes[hole];
    if (!isDepthJump(fill, polygon.curve, polygon.vertices, place_.model))
      continue;
    strategy_[hole] = GIVEN_UP;
    result_.holes[hole].open = OpenReason::DEPTH_JUMP;
  }
}

/** Whether a hole that is still to be closed wants something. */
bool
RegionClosing::any(bool FillStrategy::*wanted) const
{
  return std::any_of(strategy_.begin(), strategy_.end(), [&](std::size_t strategy) {
    return strategy != GIVEN_UP && FILL_STRATEGIES[strategy].*wanted;
  });
}

/** The fills of all that is not given up, grown over the samples; the last one serves
 * as long as it is made of the same fills. */
void
RegionClosing::assemble()
{
  const bool grows =
      !flat_ && !region_.samples.empty() && !any(&FillStrategy::without_free) &&
      std::none_of(completed_.begin(), completed_.end(), [](bool c) { return c; });
  std::vector<std::size_t> fills;
  for (const FilledPart& part : parts_) {
    const std::size_t strategy = strategy_[part.hole];
    fills.push_back(strategy == GIVEN_UP ? NONE : fillsIn(FILL_STRATEGIES[strategy]));
  }
  if (grows && fills == grown_fills_) {
    result_.patch = grown_;
    return;
  }
  std::vector<FilledPart> closed;
  for (std::size_t p = 0; p < parts_.size(); ++p)
    if (fills[p] != NONE)
      closed.push_back(parts_[p]);
  result_.patch = assemblePatch(closed, place_.model.positions.size());
  if (!grows)
    return;
  const auto is_obstructed = [&](const ccaa::Corners& corners) {
    return obstacle_.meets(corners, context_.control);
  };
  growOver(
      place_.model, region_.samples, is_obstructed, result_.patch, context_.control);
  grown_ = result_.patch;
  grown_fills_ = std::move(fills);
}

void
RegionClosing::fair()
{
  assemble();
  const RepairParameters& parameters = place_.parameters;
  const bool keeps_shape = any(&FillStrategy::keeps_shape);
  const bool is_opening = region_.holes.size() == 1 && !place_.mends;
  const bool is_looked_at = keeps_shape || is_opening || !parameters.refine;
  if (is_looked_at)
    findCollisions();
  const std::size_t most_in_the_way = keeps_shape ? 0 : MOST_IN_THE_WAY;
  if (!parameters.refine || (is_looked_at && obstructed_.size() > most_in_the_way))
    return;
  refinePatch(place_.model,
              parameters.refinement,
              result_.patch,
              keeps_shape,
              context_.control);
  if (parameters.relax)
    relax();
  else
    findCollisions();
}

/** Where the relaxed patch runs into something, it goes back to what it was before, in
 * wider and wider surroundings. */
void
RegionClosing::relax()
{
  Patch& patch = result_.patch;
  const Positions before = patch.positions;
  RelaxationParameters relaxation = place_.parameters.relaxation;
  relaxation.trust = place_.parameters.survey.field.trust;
  if (flat_)
    flattenPatch(place_.model, patch);
  else
    relaxPatch(
        place_.model, place_.model.free_points, relaxation, patch, context_.control);
  findCollisions();
  for (const std::size_t rings : CALMED_RINGS) {
    if (obstructed_.empty() || context_.cancelled())
      return;
    rollBackRelaxation(before, obstructed_, rings, patch);
    findCollisions();
  }
  if (!obstructed_.empty() && any(&FillStrategy::keeps_shape)) {
    patch.positions = before;
    findCollisions();
  }
}

/** What the patch, as it would be written, runs into. */
void
RegionClosing::findCollisions()
{
  if (place_.frame.float_positions)
    roundToFloats(place_.frame.origin, result_.patch);
  obstructed_ = obstructedTriangles(result_.patch, obstacle_, context_.control);
}

void
RegionClosing::tryNext(std::size_t hole, OpenReason reason)
{
  if (strategy_[hole] == GIVEN_UP)
    return;
  ++result_.holes[hole].tries;
  ++strategy_[hole];
  const bool has_others = region_.holes.size() > 1;
  const std::size_t most =
      STRATEGIES_AMONG_OTHERS + (region_.samples.empty() ? 0U : 1U);
  if ((has_others && strategy_[hole] >= most) ||
      (strategy_[hole] != GIVEN_UP && FILL_STRATEGIES[strategy_[hole]].without_free &&
       !completed_[hole] && grown_fills_.empty()))
    strategy_[hole] = GIVEN_UP;
  if (strategy_[hole] == GIVEN_UP)
    result_.holes[hole].open = reason;
}

/** \return false when a hole had to be closed in another way */
bool
RegionClosing::verify()
{
  const Patch& patch = result_.patch;
  std::set<std::size_t> obstructed;
  for (const std::size_t triangle : obstructed_)
    obstructed.insert(patch.hole[triangle]);
  if (!obstructed.empty() && place_.mends)
    keepForMending();
  for (const std::size_t hole : obstructed)
    tryNext(hole, OpenReason::INTERSECTION);
  if (std::any_of(obstructed.begin(), obstructed.end(), [&](std::size_t hole) {
        return region_.holes.size() == 1 || strategy_[hole] != GIVEN_UP;
      }))
    return false;
  // What is left of the patch without the holes in question has no other fault.
  if (!obstructed.empty())
    result_.patch = withoutHoles(patch, obstructed);
  if (fitsModel(place_.model, patch))
    return true;
  if (!obstructed.empty())
    return false;
  for (std::size_t hole = 0; hole < strategy_.size(); ++hole)
    tryNext(hole, OpenReason::NOT_MANIFOLD);
  return false;
}

/** A patch of a single hole that has no free points as vertices. Of holes that bridges
 * connect one is wrong, rather than all: they are tried one by one. */
void
RegionClosing::keepForMending()
{
  const std::vector<std::size_t>& held = result_.patch.free_point;
  if (region_.holes.size() == 1 &&
      std::all_of(held.begin(), held.end(), [](std::size_t p) { return p == NONE; }))
    obstructed_patches_.push_back(result_.patch);
}

/** What was tried, filled anew where it runs into something. */
void
RegionClosing::mend()
{
  for (Patch& patch : obstructed_patches_)
    if (mendPatch(place_, obstacle_, context_, patch) &&
        fitsModel(place_.model, patch)) {
      result_.patch = std::move(patch);
      result_.holes.front().open = OpenReason::NONE;
      return;
    }
}

/** What has taken more work than it may stays open; nothing that is not verified is
 * kept. */
void
RegionClosing::leaveCostly(bool is_settled)
{
  if (!is_settled)
    result_.patch = {};
  for (HoleOutcome& hole : result_.holes)
    if (hole.open == OpenReason::INTERSECTION ||
        (!is_settled &&
         (hole.open == OpenReason::NONE || hole.open == OpenReason::NO_FILLING)))
      hole.open = OpenReason::TOO_COSTLY;
}

ClosedRegion
RegionClosing::run()
{
  leavePierced();
  subdivide();
  bool is_settled = false;
  while (!is_settled && !context_.cancelled()) {
    fill();
    leaveDepthJumps();
    fair();
    is_settled = !context_.cancelled() && verify();
  }
  if (is_settled && result_.holes.front().open == OpenReason::INTERSECTION)
    mend();
  if (context_.cancelled())
    leaveCostly(is_settled);
  for (HoleOutcome& hole : result_.holes)
    if (hole.open != OpenReason::NONE)
      hole.filling.clear();
  return std::move(result_);
}

} // namespace

ClosingPlace
withinPart(const IncompleteModel& model,
           const RepairParameters& parameters,
           const CloudFrame& frame)
{
  static const SurveyGuides none{};
  return {model, none, parameters, frame, false};
}

std::uint64_t
workFor(const Region& region)
{
  std::size_t size = region.samples.size();
  for (const HolePolygon& hole : region.holes)
    size += hole.size();
  const auto n = static_cast<double>(size);
  return LEAST_WORK + static_cast<std::uint64_t>(WORK * n * std::log2(n + 2.0));
}

ClosedRegion
closeRegion(const ClosingPlace& place,
            const Region& region,
            const SurfaceObstacle& obstacle,
            const ccaa::LoopContext& context)
{
  return RegionClosing(place, region, obstacle, context).run();
}

} // namespace repair
} // namespace pcl
