// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the sources in flat arrays, and which are near a place.
#include "field/source_blocks.h"

#include <algorithm>
#include <atomic>

namespace pcl::repair {
namespace {

using field_kernel::LANES;

/** \brief Blocks to a group: few enough that a search finds little in vain, and enough
 * that it finds it soon. */
constexpr std::uint32_t GROUP_BLOCKS = 4;

/** \brief Up to so many groups looking at all of them is faster than a search. */
constexpr std::size_t FEW_GROUPS = 256;

void
setLane(SourceBlocks::Rows& rows, std::size_t lane, const FieldSource& source)
{
  using namespace field_kernel;
  const double inverse = source.charge != 0.0 ? 1.0 / source.charge : 0.0;
  for (int k = 0; k < 3; ++k) {
    rows.values[TANGENT_X + k][lane] = source.tangent[k] * source.charge;
    rows.values[NORMAL_X + k][lane] = source.normal[k] * inverse;
  }
  rows.values[INVERSE_CHARGE][lane] = inverse;
  rows.values[ARC][lane] = source.arc;
}

std::uint64_t
nextNumber()
{
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

} // namespace

SourceBlocks::SourceBlocks(const SourceSet& sources) : number_(nextNumber())
{
  placeFrame(sources);
  for (const SourceCurve& curve : sources.curves)
    append(curve);
  buildTree();
}

void
SourceBlocks::placeFrame(const SourceSet& sources)
{
  Eigen::AlignedBox3d box;
  for (const SourceCurve& curve : sources.curves)
    for (const FieldSource& source : curve.sources)
      box.extend(source.position);
  if (box.isEmpty())
    return;
  origin_ = box.center();
  const double extent = box.sizes().maxCoeff();
  scale_ = extent > 0.0 ? 1.0 / extent : 1.0;
}

void
SourceBlocks::append(const SourceCurve& curve)
{
  Range range;
  range.begin = static_cast<std::uint32_t>(rows_.size());
  for (std::size_t first = 0; first < curve.sources.size(); first += LANES) {
    const std::size_t last = std::min(first + LANES, curve.sources.size());
    Rows rows = {};
    Eigen::AlignedBox3d box;
    for (std::size_t lane = 0; lane < LANES; ++lane) {
      // Lanes past the end repeat the last place, without charge.
      const FieldSource& source = curve.sources[std::min(first + lane, last - 1)];
      const Position place = toFrame(source.position);
      positions_.push_back(source.position);
      for (int k = 0; k < 3; ++k)
        rows.values[field_kernel::X + k][lane] = place[k];
      if (first + lane < last)
        setLane(rows, lane, source);
      box.extend(place);
    }
    rows_.push_back(rows);
    balls_.push_back({box.center(), 0.5 * box.diagonal().norm()});
    curve_of_.push_back(curves_.size());
  }
  range.end = static_cast<std::uint32_t>(rows_.size());
  curves_.push_back(range);
  islands_.push_back(curve.island);
  groupBlocks(range);
}

void
SourceBlocks::groupBlocks(Range curve)
{
  for (std::uint32_t first = curve.begin; first < curve.end; first += GROUP_BLOCKS) {
    Group group;
    group.blocks = {first, std::min(first + GROUP_BLOCKS, curve.end)};
    Eigen::AlignedBox3d box;
    for (std::uint32_t b = first; b < group.blocks.end; ++b) {
      const Eigen::Vector3d half = Eigen::Vector3d::Constant(balls_[b].radius);
      box.extend(Eigen::AlignedBox3d(balls_[b].center - half, balls_[b].center + half));
    }
    group.ball.center = box.center();
    for (std::uint32_t b = first; b < group.blocks.end; ++b)
      group.ball.radius =
          std::max(group.ball.radius,
                   (balls_[b].center - box.center()).norm() + balls_[b].radius);
    largest_group_ = std::max(largest_group_, group.ball.radius);
    groups_.push_back(group);
  }
}

void
SourceBlocks::buildTree()
{
  if (groups_.size() <= FEW_GROUPS)
    return;
  Positions centers;
  for (const Group& group : groups_)
    centers.push_back(group.ball.center);
  tree_ = FloatTree(centers);
}

void
SourceBlocks::near(const Ball& place, std::vector<std::uint32_t>& blocks) const
{
  blocks.clear();
  const auto look = [&](const Group& group) {
    const double reach = place.radius + group.ball.radius;
    if ((group.ball.center - place.center).squaredNorm() <= reach * reach)
      for (std::uint32_t b = group.blocks.begin; b < group.blocks.end; ++b)
        blocks.push_back(b);
  };
  if (groups_.size() <= FEW_GROUPS) {
    std::for_each(groups_.begin(), groups_.end(), look);
    return;
  }
  pcl::Indices found;
  tree_.near(place.center, place.radius + largest_group_, found);
  for (const pcl::index_t i : found)
    look(groups_[static_cast<std::size_t>(i)]);
}

} // namespace pcl::repair
