// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of a tile and of what lies around it.
#include "out_of_core/tile_cloud.h"

#include "io/point_columns.h"

#include <algorithm>

namespace app {

using pcl::ccaa::WideIndex;

TileCloud::TileCloud(const TilePlan& plan) : cloud_(plan.layout)
{
  const char* const axes[] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    position_offsets_[axis] = findField(cloud_, axes[axis])->offset;
}

TileCloud::TileCloud(const TilePlan& plan, std::size_t tile) : TileCloud(plan)
{
  std::vector<std::size_t> parts = plan.tiling.neighborsOf(tile);
  parts.insert(std::upper_bound(parts.begin(), parts.end(), tile), tile);
  const pcl::ccaa::Tile& own = plan.tiling.tiles[tile];
  for (const std::size_t part : parts) {
    if (part == tile) {
      addOwn(plan, tile);
      continue;
    }
    const TilePoints points(plan, part);
    for (const std::size_t i : points.knownTo(own))
      add(plan, part, points, i);
  }
  finish();
}

TileCloud::TileCloud(const TilePlan& plan,
                     std::size_t tile,
                     const std::vector<WideIndex>& foreign)
: TileCloud(plan)
{
  const pcl::ccaa::Tile& own = plan.tiling.tiles[tile];
  const auto behind = std::lower_bound(foreign.begin(), foreign.end(), own.first);
  addThese(plan, foreign.begin(), behind);
  addOwn(plan, tile);
  addThese(plan, behind, foreign.end());
  finish();
}

TileCloud::TileCloud(const TilePlan& plan, const std::vector<WideIndex>& points)
: TileCloud(plan)
{
  addThese(plan, points.begin(), points.end());
  finish();
}

void
TileCloud::addThese(const TilePlan& plan,
                    std::vector<WideIndex>::const_iterator next,
                    std::vector<WideIndex>::const_iterator end)
{
  forPoints(
      plan, next, end, [&](std::size_t part, const TilePoints& points, std::size_t i) {
        add(plan, part, points, i);
      });
}

void
TileCloud::addOwn(const TilePlan& plan, std::size_t tile)
{
  const TilePoints points(plan, tile);
  first_own_ = wide_.size();
  cloud_.data.reserve(cloud_.data.size() + points.size() * cloud_.point_step);
  for (std::size_t i = 0; i < points.size(); ++i)
    add(plan, tile, points, i);
}

void
TileCloud::finish()
{
  cloud_.width = static_cast<pcl::uindex_t>(wide_.size());
  cloud_.row_step = cloud_.width * cloud_.point_step;
  cloud_.is_dense = 1;
}

void
TileCloud::add(const TilePlan& plan,
               std::size_t part,
               const TilePoints& points,
               std::size_t i)
{
  const std::size_t at = cloud_.data.size();
  const std::uint8_t* const record = points.record(i);
  cloud_.data.insert(cloud_.data.end(), record, record + cloud_.point_step);
  wide_.push_back(plan.tiling.tiles[part].first + i);
  halos_.push_back(points.halo(i));
  if (plan.step <= 0.0)
    return;
  const pcl::ccaa::Position rounded = points.position(i);
  for (std::size_t axis = 0; axis < 3; ++axis)
    std::memcpy(&cloud_.data[at + position_offsets_[axis]],
                &rounded[static_cast<Eigen::Index>(axis)],
                sizeof(double));
}

pcl::index_t
TileCloud::placeOf(WideIndex index) const
{
  const auto place = std::lower_bound(wide_.begin(), wide_.end(), index);
  if (place == wide_.end() || *place != index)
    throw Failure("a triangle near a cut has a corner that its tile does not know");
  return static_cast<pcl::index_t>(place - wide_.begin());
}

} // namespace app
