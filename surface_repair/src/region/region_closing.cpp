// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: holes that bridges connect are closed together.

#include "region/region_closing.h"

#include "filling/completion_filling.h"
#include "icadm/model_assembly.h"
#include "junction/depth_jump.h"
#include "region/hopeless_holes.h"
#include "region/patch_fairing.h"
#include "region/patch_growth.h"
#include "region/patch_mending.h"
#include "region/region_parts.h"

#include <algorithm>
#include <set>
#include <utility>

namespace pcl::repair {

namespace {

class RegionClosing {
public:
  RegionClosing(const ClosingPlace& place,
                const Region& region,
                const SurfaceObstacle& obstacle,
                const ccaa::LoopContext& context)
  : place_(place)
  , region_(region)
  , obstacle_(obstacle)
  , control_(context.control, workFor(region) / (region.samples.empty() ? 1 : SAMPLED))
  , context_{context.threads, &control_}
  , strategy_(region.holes.size(), 0)
  , completed_(region.holes.size(), false)
  , parts_(place, region, obstacle, context_)
  {
    result_.holes.resize(region.holes.size());
  }

  ClosedRegion
  run();
  /** Whether what was taken for samples describes no surface, or none that could be
   * made with reasonable work. \param[in] whole that this is a part of */
  bool
  areStrays(const ccaa::LoopContext& whole) const
  {
    return are_strays_ ||
           (!region_.samples.empty() && !whole.cancelled() && context_.cancelled());
  }

private:
  void
  leavePierced();
  void
  fill();
  void
  leaveDepthJumps();
  bool
  assemble();
  bool
  leaveHopeless();
  void
  fair();
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
  void
  giveUp(std::size_t hole, OpenReason reason)
  {
    strategy_[hole] = GIVEN_UP;
    result_.holes[hole].open = reason;
  }

  const ClosingPlace& place_;
  const Region& region_;
  const SurfaceObstacle& obstacle_;
  ccaa::RunControl control_;
  const ccaa::LoopContext context_;
  std::vector<std::size_t> strategy_;    /**< of each hole: place in FILL_STRATEGIES */
  std::vector<bool> completed_;          /**< of each hole: free points are vertices */
  bool is_looked_at_ = false;            /**< what the plain fills run into */
  Patch grown_;                          /**< over samples */
  std::vector<std::size_t> grown_fills_; /**< it is made of: of each part */
  bool are_strays_ = false;
  RegionParts parts_;
  ClosedRegion result_;
  std::vector<Patch> obstructed_patches_; /**< of a single hole, as far as tried */
  FairedPatch faired_;                    /**< the patch as it is */
};

void
RegionClosing::leavePierced()
{
  for (std::size_t h = 0; h < region_.holes.size(); ++h) {
    const OpenReason reason =
        crossedEdges(region_.holes[h], place_.model, obstacle_, context_.control);
    if (reason != OpenReason::NONE && !context_.cancelled()) // then all is crossed
      giveUp(h, reason);
  }
}

void
RegionClosing::fill()
{
  for (std::size_t p = 0; p < parts_.parts.size(); ++p) {
    FilledPart& part = parts_.parts[p];
    const std::size_t strategy = strategy_[part.hole];
    if (strategy == GIVEN_UP)
      continue;
    HoleOutcome& outcome = result_.holes[part.hole];
    const bool avoiding = FILL_STRATEGIES[strategy].avoids;
    const ChosenFilling& chosen = parts_.fills(FILL_STRATEGIES[strategy], strategy_)[p];
    part.filling = chosen.filling;
    outcome.filling = chosen.method;
    if (chosen.method == CompletionFilling().name())
      completed_[part.hole] = true;
    if (chosen.filling.closed())
      continue;
    ++outcome.tries;
    giveUp(part.hole, avoiding ? OpenReason::INTERSECTION : OpenReason::NO_FILLING);
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
    for (const FilledPart& part : parts_.parts)
      if (part.hole == hole)
        addFill(part, fill);
    const HolePolygon& polygon = region_.holes[hole];
    if (!isDepthJump(fill, polygon.curve, polygon.vertices, place_.model))
      continue;
    giveUp(hole, OpenReason::DEPTH_JUMP);
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
 * as long as it is made of the same fills. \return whether it has grown */
bool
RegionClosing::assemble()
{
  const bool grows =
      !parts_.isFlat() && !region_.samples.empty() &&
      !any(&FillStrategy::without_free) &&
      std::none_of(completed_.begin(), completed_.end(), [](bool c) { return c; });
  std::vector<std::size_t> fills;
  for (const FilledPart& part : parts_.parts) {
    const std::size_t strategy = strategy_[part.hole];
    fills.push_back(strategy == GIVEN_UP ? NONE : fillsIn(FILL_STRATEGIES[strategy]));
  }
  if (grows && fills == grown_fills_) {
    result_.patch = grown_;
    return true;
  }
  std::vector<FilledPart> closed;
  for (std::size_t p = 0; p < parts_.parts.size(); ++p)
    if (fills[p] != NONE)
      closed.push_back(parts_.parts[p]);
  result_.patch = assemblePatch(closed, place_.model.positions.size(), region_.creases);
  if (!std::exchange(is_looked_at_, true) && leaveHopeless())
    return assemble();
  if (!grows || result_.patch.triangles.empty())
    return false;
  are_strays_ = !growPatch(place_, region_.samples, obstacle_, context_, result_.patch);
  grown_ = result_.patch;
  grown_fills_ = std::move(fills);
  return true;
}

/** \return whether there are any */
bool
RegionClosing::leaveHopeless()
{
  const auto hopeless = hopelessHoles(result_.patch, obstacle_, context_.control);
  for (const std::size_t hole : hopeless) {
    ++result_.holes[hole].tries;
    giveUp(hole, OpenReason::INTERSECTION);
  }
  return !hopeless.empty();
}

void
RegionClosing::fair()
{
  const bool has_grown = assemble();
  if (are_strays_)
    return;
  PatchFairing how;
  how.is_flat = parts_.isFlat();
  how.keeps_shape = any(&FillStrategy::keeps_shape);
  faired_ =
      has_grown
          ? fairGrown(place_, region_.samples, obstacle_, how, context_, result_.patch)
          : fairPatch(place_, obstacle_, how, context_, result_.patch);
}

void
RegionClosing::tryNext(std::size_t hole, OpenReason reason)
{
  if (strategy_[hole] == GIVEN_UP)
    return;
  ++result_.holes[hole].tries;
  const std::size_t next = ++strategy_[hole];
  const bool has_others = region_.holes.size() > 1;
  const std::size_t most =
      STRATEGIES_AMONG_OTHERS + (region_.samples.empty() ? 0U : 1U);
  if (next == GIVEN_UP || (has_others && next >= most) ||
      (FILL_STRATEGIES[next].without_free && !completed_[hole] && grown_fills_.empty()))
    giveUp(hole, reason);
}

/** \return false when a hole had to be closed in another way */
bool
RegionClosing::verify()
{
  const Patch& patch = result_.patch;
  std::set<std::size_t> obstructed;
  for (const std::size_t triangle : faired_.obstructed)
    obstructed.insert(patch.hole[triangle]);
  if (!obstructed.empty() && place_.mends)
    keepForMending();
  for (const std::size_t hole : obstructed)
    tryNext(hole, OpenReason::INTERSECTION);
  if (!faired_.is_faired || // nor is the rest
      std::any_of(obstructed.begin(), obstructed.end(), [&](std::size_t hole) {
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
  parts_.divide(strategy_, result_.holes);
  bool is_settled = false;
  while (!is_settled && !context_.cancelled()) {
    fill();
    leaveDepthJumps();
    fair();
    if (are_strays_)
      return {};
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

ClosedRegion
closeRegion(const ClosingPlace& place,
            const Region& region,
            const SurfaceObstacle& obstacle,
            const ccaa::LoopContext& context,
            const std::vector<HoleOutcome>* without_samples)
{
  RegionClosing closing(place, region, obstacle, context);
  ClosedRegion closed = closing.run();
  if (!closing.areStrays(context))
    return closed;
  const Region plain = withoutSamples(region);
  closed = without_samples != nullptr
               ? ClosedRegion{{}, *without_samples}
               : RegionClosing(place, plain, obstacle, context).run();
  closed.without_samples = true;
  return closed;
}

} // namespace pcl::repair
