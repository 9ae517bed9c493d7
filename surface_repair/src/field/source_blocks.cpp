// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the sources in flat arrays, and which are near a place.
#include "field/source_blocks.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace pcl::repair {
namespace {

using field_kernel::LANES;

/** \brief Blocks to a group: their coarse sources are one block. */
constexpr std::uint32_t GROUP_BLOCKS = LANES;

/** \brief Up to so many groups looking at all of them is faster than a search. */
constexpr std::size_t FEW_GROUPS = 256;

void
setLane(SourceBlocks::Rows& rows,
        std::size_t lane,
        const Position& place,
        const FieldSource& source)
{
  using namespace field_kernel;
  const double inverse = source.charge != 0.0 ? 1.0 / source.charge : 0.0;
  for (int k = 0; k < 3; ++k) {
    rows.values[X + k][lane] = place[k];
    rows.values[TANGENT_X + k][lane] = source.tangent[k] * source.charge;
    rows.values[NORMAL_X + k][lane] = source.normal[k] * inverse;
  }
  rows.values[INVERSE_CHARGE][lane] = inverse;
  rows.values[ARC][lane] = source.arc;
}

/** Consecutive sources as one: h tau is their sum. */
FieldSource
coarseSource(const FieldSource* first, const FieldSource* last)
{
  FieldSource sum{
      Position::Zero(), Direction::Zero(), Direction::Zero(), 0.0, first->arc};
  for (const FieldSource* source = first; source != last; ++source) {
    sum.position += source->position;
    sum.tangent += source->charge * source->tangent;
    sum.normal += source->normal;
  }
  sum.position /= static_cast<double>(last - first);
  sum.charge = sum.tangent.norm();
  sum.tangent.normalize();
  sum.normal.normalize();
  return sum;
}

std::uint64_t
nextNumber()
{
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

} // namespace

SourceBlocks::SourceBlocks(const SourceSet& sources, double coarse_distance)
: number_(nextNumber())
{
  placeFrame(sources);
  for (const SourceCurve& curve : sources.curves)
    append(curve);
  for (Group& group : groups_)
    addCoarse(sources.curves[curve_of_[group.blocks.begin]], coarse_distance, group);
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
      FieldSource source = curve.sources[std::min(first + lane, last - 1)];
      if (first + lane >= last)
        source.charge = 0.0;
      const Position place = toFrame(source.position);
      positions_.push_back(source.position);
      setLane(rows, lane, place, source);
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

/** A single block is as soon added up itself. */
void
SourceBlocks::addCoarse(const SourceCurve& curve, double distance, Group& group)
{
  const Range blocks = group.blocks;
  group.coarse_from = std::numeric_limits<double>::infinity();
  if (!(distance > 0.0) || blocks.end - blocks.begin < 2)
    return;
  double radius = 0.0;
  Rows rows = {};
  for (std::uint32_t b = blocks.begin; b < blocks.end; ++b) {
    const std::size_t first = (b - curves_[curve_of_[b]].begin) * LANES;
    const FieldSource source = coarseSource(
        &curve.sources[first],
        curve.sources.data() + std::min(first + LANES, curve.sources.size()));
    setLane(rows, b - blocks.begin, toFrame(source.position), source);
    radius = std::max(radius, balls_[b].radius);
  }
  group.coarse_from = group.ball.radius + distance * radius;
  group.coarse = static_cast<std::uint32_t>(rows_.size());
  rows_.push_back(rows);
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
SourceBlocks::near(const Ball& place, std::vector<std::uint32_t>& groups) const
{
  groups.clear();
  const auto look = [&](std::uint32_t number) {
    const Ball& ball = groups_[number].ball;
    const double reach = place.radius + ball.radius;
    if ((ball.center - place.center).squaredNorm() <= reach * reach)
      groups.push_back(number);
  };
  if (groups_.size() <= FEW_GROUPS) {
    for (std::uint32_t g = 0; g < groups_.size(); ++g)
      look(g);
    return;
  }
  pcl::Indices found;
  tree_.near(place.center, place.radius + largest_group_, found);
  for (const pcl::index_t i : found)
    look(static_cast<std::uint32_t>(i));
}

} // namespace pcl::repair
