// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the regions of a pass, side by side.

#include "pass/regions_closing.h"

#include "mesh/block_loop.h"
#include "mesh/box_tree.h"
#include "patch/surface_obstacle.h"
#include "region/region_closing.h"
#include "region/region_parts.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
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

/** Regions that may be closed side by side, one list after the other: those of a list
 * have places that do not meet. */
std::vector<std::vector<std::size_t>>
closableTogether(const std::vector<ccaa::Box>& places)
{
  const ccaa::BoxTree tree(places);
  std::vector<std::size_t> list_of(places.size(), NONE);
  std::vector<std::vector<std::size_t>> lists;
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
  return lists;
}

/** How the regions of a pass are closed. */
class RegionsClosing {
public:
  RegionsClosing(const ClosingPlace& place,
                 const std::vector<Region>& regions,
                 const ccaa::LoopContext& context,
                 RegionMemory& memory)
  : place_(place), regions_(regions), context_(context), memory_(memory)
  {
    for (const Region& region : regions)
      places_.push_back(placeOf(region, place.model));
    closed_.resize(regions.size());
  }

  /** \param[in] tell the share that is done */
  std::vector<ClosedRegion>
  run(const std::function<void(double)>& tell)
  {
    SurfaceObstacle obstacle(place_.model, places_, context_.threads, context_.control);
    std::uint64_t all = 0;
    for (const Region& region : regions_)
      all += workFor(region);
    std::uint64_t done = 0;
    const auto tell_work = [&](std::uint64_t more) {
      done += more;
      tell(static_cast<double>(done) / static_cast<double>(all));
    };
    for (const std::vector<std::size_t>& together : closableTogether(places_)) {
      closeTogether(together, obstacle, tell_work);
      for (const std::size_t r : together)
        commit(r, obstacle);
    }
    return std::move(closed_);
  }

private:
  void
  closeTogether(const std::vector<std::size_t>& together,
                const SurfaceObstacle& obstacle,
                const std::function<void(std::uint64_t)>& tell)
  {
    ccaa::LoopContext within = context_;
    if (together.size() > 1)
      within.threads = 1;
    std::atomic<std::uint64_t> untold{0};
    std::vector<std::exception_ptr> thrown(together.size()); // none may leave a thread
    const auto close_one = [&](std::size_t, std::size_t i, std::size_t) {
      try {
        closed_[together[i]] = close(together[i], obstacle, within);
      }
      catch (...) {
        thrown[i] = std::current_exception();
      }
      untold += workFor(regions_[together[i]]);
      if (ccaa::threadIndex() == 0)
        tell(untold.exchange(0));
    };
    ccaa::RunControl part(context_.control);
    ccaa::forEachBlock(
        together.size(), ccaa::LoopContext{context_.threads, &part, "", 1}, close_one);
    if (untold > 0)
      tell(untold);
    for (const std::exception_ptr& exception : thrown)
      if (exception)
        std::rethrow_exception(exception);
  }

  ClosedRegion
  close(std::size_t r,
        const SurfaceObstacle& obstacle,
        const ccaa::LoopContext& context) const
  {
    if (!memory_.empty())
      if (const auto* failed = memory_.find(keyOf(r)))
        return {{}, *failed};
    return closeRegion(place_, regions_[r], obstacle, context);
  }

  /** A patch that leaves its place has not seen what came beside it. */
  void
  commit(std::size_t r, SurfaceObstacle& obstacle)
  {
    const auto& positions = closed_[r].patch.positions;
    if (!std::all_of(
            positions.begin(),
            positions.end(),
            [&](const Position& position) { return places_[r].contains(position); }) &&
        !obstructedTriangles(closed_[r].patch, obstacle, context_.control).empty())
      closed_[r] = close(r, obstacle, context_);
    obstacle.add(
        closed_[r].patch.positions, closed_[r].patch.triangles, context_.control);
    remember(r);
  }

  void
  remember(std::size_t r)
  {
    const std::vector<HoleOutcome>& holes = closed_[r].holes;
    if (!context_.cancelled() && allFailed(holes))
      memory_.remember(keyOf(r), places_[r], holes);
  }

  RegionMemory::Key
  keyOf(std::size_t r) const
  {
    return RegionMemory::keyOf(regions_[r], place_.model);
  }

  const ClosingPlace& place_;
  const std::vector<Region>& regions_;
  const ccaa::LoopContext& context_;
  RegionMemory& memory_;
  std::vector<ccaa::Box> places_;
  std::vector<ClosedRegion> closed_;
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
