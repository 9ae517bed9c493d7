// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the regions of a pass, side by side.

#include "pass/regions_closing.h"

#include "mesh/block_loop.h"
#include "mesh/box_tree.h"
#include "patch/surface_obstacle.h"
#include "region/region_closing.h"
#include "region/region_parts.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <utility>

namespace pcl::repair {

namespace {

/** Where a region is built: its boundary and samples with room around them. */
ccaa::Box
placeOf(const Region& region, const IncompleteModel& model)
{
  ccaa::Box box;
  for (const HolePolygon& hole : region.holes)
    for (const Position& point : hole.curve.points)
      box.extend(point);
  for (const std::size_t sample : region.samples)
    box.extend(model.free_points[sample]);
  return ccaa::widened(box, box.diagonal().norm());
}

std::vector<ccaa::Box>
placesOf(const std::vector<Region>& regions, const IncompleteModel& model)
{
  std::vector<ccaa::Box> places;
  for (const Region& region : regions)
    places.push_back(placeOf(region, model));
  return places;
}

/** An order in which those that follow each other have places that do not meet, for
 * the most part: of these neither has to wait for the other. */
std::vector<std::size_t>
inTurn(const std::vector<ccaa::Box>& places)
{
  const ccaa::BoxTree tree(places);
  std::vector<std::size_t> list_of(places.size(), NONE);
  std::vector<std::vector<std::size_t>> lists; // of such whose places do not meet
  for (std::size_t r = 0; r < places.size(); ++r) {
    std::vector<bool> is_taken(lists.size() + 1, false);
    tree.forEachMeeting(places[r], [&](pcl::index_t other) {
      const std::size_t list = list_of[static_cast<std::size_t>(other)];
      if (list != NONE)
        is_taken[list] = true;
    });
    list_of[r] = static_cast<std::size_t>(
        std::find(is_taken.begin(), is_taken.end(), false) - is_taken.begin());
    lists.resize(std::max(lists.size(), list_of[r] + 1));
    lists[list_of[r]].push_back(r);
  }
  return ccaa::joinBlocks(lists);
}

/** After so long a thread that waits looks again whether the run goes on. */
constexpr std::chrono::milliseconds PATIENCE(5);
/** Regions that a thread may be ahead of the one whose turn it is: enough that few wait
 * for a large one (with 8 the passes over a table scene took 1.2 times as long), and so
 * few that little comes in between (with 1000 a fifth was tried twice). */
constexpr std::size_t AHEAD_OF_A_THREAD = 64;

/** How the regions of a pass are closed: as one after the other, each with the patches
 * before it in the way. Those further on are tried meanwhile, and once more where a
 * patch has come that they have not seen. */
class RegionsClosing {
public:
  RegionsClosing(const ClosingPlace& place,
                 const std::vector<Region>& regions,
                 const ccaa::LoopContext& context,
                 RegionMemory& memory)
  : place_(place)
  , regions_(regions)
  , context_(context)
  , memory_(memory)
  , places_(placesOf(regions, place.model))
  , order_(inTurn(places_))
  , obstacle_(place.model, places_, context.threads, context.control)
  , tries_(regions.size())
  {
    for (const Region& region : regions)
      all_ += workFor(region);
  }

  /** \param[in] tell the share that is done */
  std::vector<ClosedRegion>
  run(const std::function<void(double)>& tell)
  {
    if (order_.empty())
      return {};
    const bool together = context_.threads > 1 && order_.size() > 1;
    if (together)
      within_.threads = 1;
    ahead_ =
        together ? AHEAD_OF_A_THREAD * static_cast<std::size_t>(context_.threads) : 1;
#pragma omp parallel num_threads(context_.threads) if (together)
    work(tell);
    if (thrown_)
      std::rethrow_exception(thrown_);
    Lock lock(mutex_);
    tellShare(tell, lock);
    std::vector<ClosedRegion> closed;
    for (Try& one : tries_)
      closed.push_back(std::move(one.closed));
    return closed;
  }

private:
  /** A region that was tried. */
  struct Try {
    ClosedRegion closed;
    ccaa::Box seen;        /**< where it has looked for what is in the way */
    std::size_t known = 0; /**< patches that were in the way then, in their turn */
    bool is_done = false;
  };
  using Lock = std::unique_lock<std::mutex>;

  /** Of one thread. */
  void
  work(const std::function<void(double)>& tell)
  {
    Lock lock(mutex_);
    while (turn_ < order_.size() && !thrown_ && !context_.cancelled()) {
      if (tries_[order_[turn_]].is_done && !std::exchange(is_taking_, true)) {
        take(lock);
        is_taking_ = false;
        changed_.notify_all();
      }
      else if (next_ < std::min(order_.size(), turn_ + ahead_))
        tryOut(order_[next_++], lock);
      else
        wait(lock);
      if (ccaa::threadIndex() == 0)
        tellShare(tell, lock);
    }
    changed_.notify_all();
  }

  /** \param[in,out] lock open while it is closed; none may throw out of a thread */
  void
  tryOut(std::size_t r, Lock& lock)
  {
    Try one;
    one.known = turn_;
    const SurfaceObstacle obstacle = obstacle_.watched(one.seen);
    const Region& region = regions_[r];
    if (const auto* failed = failureOf(region))
      one.closed.holes = failed->holes;
    else {
      const auto* plain =
          region.samples.empty() ? nullptr : failureOf(withoutSamples(region));
      lock.unlock();
      std::exception_ptr thrown;
      try {
        one.closed = closeRegion(
            place_, region, obstacle, within_, plain ? &plain->holes : nullptr);
        if (plain && one.closed.without_samples)
          one.seen.extend(plain->seen);
      }
      catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      if (thrown)
        thrown_ = thrown;
    }
    one.is_done = true;
    tries_[r] = std::move(one);
    changed_.notify_all();
  }

  /** All that were tried and whose turn it is. */
  void
  take(Lock& lock)
  {
    for (; turn_ < order_.size() && tries_[order_[turn_]].is_done && !thrown_;
         ++turn_) {
      const std::size_t r = order_[turn_];
      if (hasMissed(tries_[r]))
        tryOut(r, lock);
      if (context_.cancelled() || thrown_)
        return;
      const ClosedRegion& closed = tries_[r].closed;
      obstacle_.add(closed.patch.positions, closed.patch.triangles, context_.control);
      if (!allFailed(closed.holes))
        continue;
      const RegionMemory::Failure failure{tries_[r].seen, closed.holes};
      memory_.remember(keyOf(regions_[r]), failure);
      if (closed.without_samples)
        memory_.remember(keyOf(withoutSamples(regions_[r])), failure);
    }
  }

  /** Whether a patch lies where it has looked, that was not there yet. */
  bool
  hasMissed(const Try& one) const
  {
    const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(one.known);
    const auto end = order_.begin() + static_cast<std::ptrdiff_t>(turn_);
    return std::any_of(begin, end, [&](std::size_t r) {
      const Patch& patch = tries_[r].closed.patch;
      return std::any_of(patch.triangles.begin(),
                         patch.triangles.end(),
                         [&](const Triangle& triangle) {
                           return ccaa::boxOf(
                                      ccaa::cornersOf(triangle, patch.positions))
                               .intersects(one.seen);
                         });
    });
  }

  void
  wait(Lock& lock)
  {
    changed_.wait_for(lock, PATIENCE);
    if (context_.control == nullptr || ccaa::threadIndex() != 0)
      return;
    lock.unlock();
    context_.control->askAgain();
    lock.lock();
  }

  void
  tellShare(const std::function<void(double)>& tell, Lock& lock)
  {
    if (told_ == turn_)
      return;
    for (; told_ < turn_; ++told_)
      done_ += workFor(regions_[order_[told_]]);
    lock.unlock();
    tell(static_cast<double>(done_) / static_cast<double>(all_));
    lock.lock();
  }

  RegionMemory::Key
  keyOf(const Region& region) const
  {
    return RegionMemory::keyOf(region, place_.model);
  }

  /** How it failed before; else null. */
  const RegionMemory::Failure*
  failureOf(const Region& region) const
  {
    return memory_.empty() ? nullptr : memory_.find(keyOf(region));
  }

  const ClosingPlace& place_;
  const std::vector<Region>& regions_;
  const ccaa::LoopContext& context_;
  ccaa::LoopContext within_ = context_; /**< of one region */
  RegionMemory& memory_;
  const std::vector<ccaa::Box> places_;
  const std::vector<std::size_t> order_; /**< in which regions have their turn */
  std::size_t ahead_ = 1;

  std::mutex mutex_; /**< for what follows, and the memory */
  std::condition_variable changed_;
  SurfaceObstacle obstacle_;
  std::vector<Try> tries_;
  std::size_t turn_ = 0; /**< regions that had it */
  std::size_t next_ = 0; /**< regions that were or are tried */
  bool is_taking_ = false;
  std::exception_ptr thrown_;
  std::size_t told_ = 0;
  std::uint64_t done_ = 0, all_ = 0; /**< work, as far as it was told */
};

} // namespace

std::vector<ClosedRegion>
closeRegions(const ClosingPlace& place,
             const std::vector<Region>& regions,
             const ccaa::LoopContext& context,
             RegionMemory& memory,
             const std::function<void(double)>& tell)
{
  return RegionsClosing(place, regions, context, memory).run(tell);
}

} // namespace pcl::repair
