// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which points of a cloud belong to which tile.
#include "out_of_core/point_sharing.h"

#include <algorithm>

namespace app {
namespace {

/** Tiles of a cloud that must be cut are filled to such a part of what one may hold: so
 * there are enough of them for several workers, and one of a larger cloud needs no more
 * memory than one of a smaller. */
constexpr std::uint64_t FILLED = 4;
/** Most points of a bucket, as a part of what a tile may hold: those in each octant of
 * it are shared out as if they lay evenly. */
constexpr std::uint64_t PARTS_OF_MOST = 32;

bool
mayShare(const pcl::ccaa::Box& tile, const TileBuckets::Part& part)
{
  return (part.box.max().array() >= tile.min().array()).all() &&
         (part.box.min().array() < tile.max().array()).all();
}

} // namespace

std::uint64_t
PointSharing::mostInBucket(std::uint64_t most_points)
{
  return std::max<std::uint64_t>(1, most_points / PARTS_OF_MOST);
}

PointSharing::PointSharing(TileBuckets& buckets, std::uint64_t most_points)
: buckets_(buckets), parts_(buckets.parts())
{
  std::vector<pcl::ccaa::CountedBox> counted;
  double points = 0.0;
  for (const TileBuckets::Part& part : parts_)
    for (const pcl::ccaa::CountedBox& octant : part.octants)
      if (octant.count > 0.0) {
        counted.push_back(octant);
        points += octant.count;
      }
  tiles_ = pcl::ccaa::bisect(
      counted, points > double(most_points) ? most_points / FILLED : most_points);
  for (const TileBuckets::Part& part : parts_)
    uses_.push_back(static_cast<std::size_t>(
        std::count_if(tiles_.begin(), tiles_.end(), [&](const auto& tile) {
          return mayShare(tile, part);
        })));
}

std::vector<char>
PointSharing::take(std::size_t tile, const pcl::ccaa::PointView& view)
{
  const auto bytes = static_cast<std::ptrdiff_t>(buckets_.entryBytes());
  std::vector<char> taken;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (!mayShare(tiles_[tile], parts_[i]))
      continue;
    const std::vector<char> entries = buckets_.read(parts_[i].cell);
    for (auto entry = entries.begin(); entry != entries.end(); entry += bytes)
      if (pcl::ccaa::holds(
              tiles_[tile],
              view.tripleAt(reinterpret_cast<const std::uint8_t*>(&*entry))))
        taken.insert(taken.end(), entry, entry + bytes);
    if (--uses_[i] == 0)
      buckets_.drop(parts_[i].cell);
  }
  return taken;
}

} // namespace app
