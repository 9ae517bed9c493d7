// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of a tile on disk.
#include "out_of_core/tile_points.h"

#include "mesh/sort_unique.h"

#include <algorithm>
#include <utility>

namespace app {

pcl::ccaa::PointView
recordView(const TilePlan& plan)
{
  pcl::PCLPointCloud2 one = plan.layout; // a cloud without points has no view
  one.width = one.height = 1;
  one.row_step = one.point_step;
  one.data.resize(one.point_step);
  return pcl::ccaa::positionView(one);
}

TilePoints::TilePoints(const TilePlan& plan, std::size_t tile)
: reader_(plan.file(tile, POINTS_STEP), plan.key)
, layout_(recordView(plan))
, record_bytes_(plan.layout.point_step)
, step_(plan.step)
{
  std::size_t bytes = 0;
  boxes_ = reader_.getAll<std::array<double, 6>>();
  sparse_ = reader_.getAll<SparsePoint>();
  sources_ = reader_.skipAll<PointSource>(count_);
  records_ = reinterpret_cast<const std::uint8_t*>(reader_.skipAll<char>(bytes));
  if (bytes != count_ * record_bytes_)
    throw Failure("'" + plan.file(tile, POINTS_STEP) + "' is damaged");
}

void
TilePoints::write(const TilePlan& plan,
                  const std::string& path,
                  const std::vector<char>& records,
                  const std::vector<PointSource>& sources,
                  const std::vector<SparsePoint>& sparse)
{
  const pcl::ccaa::PointView layout = recordView(plan);
  std::vector<std::array<double, 6>> boxes;
  for (std::size_t begin = 0; begin < sources.size(); begin += BLOCK) {
    Eigen::AlignedBox3d box;
    for (std::size_t i = begin; i < std::min(begin + BLOCK, sources.size()); ++i)
      box.extend(layout.tripleAt(
          reinterpret_cast<const std::uint8_t*>(&records[i * plan.layout.point_step])));
    boxes.push_back({box.min().x(),
                     box.min().y(),
                     box.min().z(),
                     box.max().x(),
                     box.max().y(),
                     box.max().z()});
  }
  StepWriter file(path, plan.key);
  file.putAll(boxes);
  file.putAll(sparse);
  file.putAll(sources);
  file.putAll(records);
  file.commit();
}

void
TilePoints::forEachIn(const Eigen::AlignedBox3d& box,
                      const std::function<void(std::size_t)>& use) const
{
  for (std::size_t block = 0; block < boxes_.size(); ++block) {
    const auto& b = boxes_[block];
    Eigen::AlignedBox3d own(Eigen::Vector3d(b[0], b[1], b[2]),
                            Eigen::Vector3d(b[3], b[4], b[5]));
    own.min().array() -= step_; // rounding may lead out of it
    own.max().array() += step_;
    if (!own.intersects(box))
      continue;
    const std::size_t end = std::min((block + 1) * BLOCK, count_);
    for (std::size_t i = block * BLOCK; i < end; ++i)
      if (box.contains(position(i)))
        use(i);
  }
}

double
TilePoints::halo(std::size_t point) const
{
  const auto place = std::lower_bound(
      sparse_.begin(), sparse_.end(), point, [](const SparsePoint& one, std::size_t p) {
        return one.point < p;
      });
  return place == sparse_.end() || place->point != point ? 0.0 : double(place->halo);
}

std::vector<std::size_t>
TilePoints::knownTo(const pcl::ccaa::Tile& tile) const
{
  std::vector<std::size_t> known;
  forEachIn(pcl::ccaa::widened(tile.box, tile.halo),
            [&](std::size_t i) { known.push_back(i); });
  for (const SparsePoint& one : sparse_)
    if (tile.knows(position(one.point), double(one.halo)))
      known.push_back(one.point);
  pcl::ccaa::sortUnique(known);
  return known;
}

} // namespace app
