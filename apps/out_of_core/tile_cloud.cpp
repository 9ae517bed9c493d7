// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of a tile and of what lies around it.
#include "out_of_core/tile_cloud.h"

#include "mesh/sort_unique.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/** A tile's cell and its halo. */
Eigen::AlignedBox3d
boxAround(const pcl::ccaa::Tile& tile)
{
  if (tile.cell.isWhole())
    return {Eigen::Vector3d::Constant(-pcl::ccaa::WORLD_EDGE),
            Eigen::Vector3d::Constant(pcl::ccaa::WORLD_EDGE)};
  Eigen::AlignedBox3d box;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::int64_t at = tile.cell.at[static_cast<std::size_t>(axis)];
    box.min()[axis] = std::ldexp(double(at), tile.cell.level) - tile.halo;
    box.max()[axis] = std::ldexp(double(at + 1), tile.cell.level) + tile.halo;
  }
  return box;
}

} // namespace

TileCloud::TileCloud(const TilePlan& plan,
                     std::size_t tile,
                     const std::vector<pcl::ccaa::WideIndex>& also)
{
  cloud_ = plan.layout;
  std::vector<std::size_t> parts = plan.tiling.neighborsOf(tile);
  parts.push_back(tile);
  for (const pcl::ccaa::WideIndex index : also)
    parts.push_back(plan.tiling.ownerOf(index));
  pcl::ccaa::sortUnique(parts);
  const Eigen::AlignedBox3d around = boxAround(plan.tiling.tiles[tile]);
  auto next = also.begin();
  for (const std::size_t part : parts) {
    const TilePoints points(plan, part);
    const pcl::ccaa::Tile& own = plan.tiling.tiles[part];
    std::vector<std::size_t> chosen;
    if (part == tile) {
      first_own_ = wide_.size();
      cloud_.data.reserve(cloud_.data.size() + points.size() * cloud_.point_step);
      for (std::size_t i = 0; i < points.size(); ++i)
        add(plan, part, points, i);
    }
    else
      points.forEachIn(around, [&](std::size_t i) { chosen.push_back(i); });
    for (; next != also.end() && *next < own.first + own.count; ++next)
      if (part != tile)
        chosen.push_back(static_cast<std::size_t>(*next - own.first));
    pcl::ccaa::sortUnique(chosen);
    for (const std::size_t i : chosen)
      add(plan, part, points, i);
  }
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
  if (plan.step <= 0.0)
    return;
  const pcl::ccaa::Position rounded = points.position(i);
  for (const pcl::PCLPointField& field : cloud_.fields)
    if (field.name == "x" || field.name == "y" || field.name == "z")
      std::memcpy(&cloud_.data[at + field.offset],
                  &rounded[field.name[0] - 'x'],
                  sizeof(double));
}

pcl::index_t
TileCloud::placeOf(pcl::ccaa::WideIndex index) const
{
  const auto place = std::lower_bound(wide_.begin(), wide_.end(), index);
  if (place == wide_.end() || *place != index)
    throw Failure("a triangle near a cut has a corner that its tile does not know");
  return static_cast<pcl::index_t>(place - wide_.begin());
}

} // namespace app
