// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which regions could not be closed where nothing has gone
// since.

#include "pass/region_memory.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace pcl::repair {

bool
RegionMemory::Key::operator<(const Key& other) const
{
  return std::tie(numbers, points) < std::tie(other.numbers, other.points);
}

RegionMemory::Key
RegionMemory::keyOf(const Region& region, const IncompleteModel& model)
{
  Key key;
  const auto add = [&](const Position& point) {
    key.points.push_back({point.x(), point.y(), point.z()});
  };
  key.numbers = {static_cast<std::size_t>(region.cap)};
  for (std::size_t h = 0; h < region.holes.size(); ++h) {
    const HolePolygon& hole = region.holes[h];
    key.numbers.push_back(hole.size());
    key.numbers.push_back(hole.second_loop);
    key.numbers.push_back(!region.is_certain.empty() && region.is_certain[h] ? 1 : 0);
    for (const Position& point : hole.curve.points)
      add(point);
  }
  for (const std::size_t sample : region.samples)
    add(model.free_points[sample]);
  return key;
}

const RegionMemory::Failure*
RegionMemory::find(const Key& key) const
{
  const auto found = failed_.find(key);
  return found == failed_.end() ? nullptr : &found->second;
}

void
RegionMemory::forgetNear(const std::vector<ccaa::Box>& gone)
{
  const ccaa::BoxTree tree(gone);
  for (auto failure = failed_.begin(); failure != failed_.end();) {
    const bool has_lost =
        tree.anyMeeting(failure->second.seen, [](pcl::index_t) { return true; });
    failure = has_lost ? failed_.erase(failure) : std::next(failure);
  }
}

bool
allFailed(const std::vector<HoleOutcome>& holes)
{
  return std::all_of(holes.begin(), holes.end(), [](const HoleOutcome& hole) {
    return hole.open != OpenReason::NONE;
  });
}

} // namespace pcl::repair
