// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the tension of many free points on a sparse grid.
#include "field/tension_grid.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl::repair {
namespace {

/** \brief Cells to R_2. */
constexpr double CELLS_TO_FAR = 4.0;

/** \brief Points spread over more cells than this have no grid: bricks could not be
 * numbered, and R_2 is nothing at that scale. */
constexpr double MOST_CELLS = 1e9;

/** Places of the table at first; it doubles when it is half full. */
constexpr std::size_t FIRST_TABLE = 64;

std::size_t
hashOf(const std::array<std::int32_t, 3>& place)
{
  std::uint64_t hash = 0;
  for (const std::int32_t k : place)
    hash = (hash ^ static_cast<std::uint32_t>(k)) * 0x9e3779b97f4a7c15ull;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

} // namespace

TensionGrid::TensionGrid(const Positions& points,
                         const Falloff& falloff,
                         double tension)
{
  if (points.empty() || !(falloff.far > 0.0) || !(tension > 0.0))
    return;
  cell_ = falloff.far / CELLS_TO_FAR;
  Eigen::AlignedBox3d box;
  for (const Position& point : points)
    box.extend(point);
  origin_ = box.min() - Position::Constant(falloff.far);
  size_ = box.sizes() / cell_ + Position::Constant(2.0 * CELLS_TO_FAR);
  if (!(size_.maxCoeff() < MOST_CELLS))
    return;
  table_.resize(FIRST_TABLE);
  for (const Position& point : points)
    add(point, falloff, tension);
}

std::size_t
TensionGrid::slotOf(const Place& place) const
{
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hashOf(place) & mask;
  while (table_[slot].brick != NO_BRICK && table_[slot].place != place)
    slot = (slot + 1) & mask;
  return slot;
}

void
TensionGrid::enlargeTable()
{
  std::vector<Slot> old(2 * table_.size());
  old.swap(table_);
  for (const Slot& slot : old)
    if (slot.brick != NO_BRICK)
      table_[slotOf(slot.place)] = slot;
}

std::size_t
TensionGrid::brickToWrite(const Place& place)
{
  std::size_t slot = slotOf(place);
  if (table_[slot].brick != NO_BRICK)
    return table_[slot].brick;
  if (2 * bricks_.size() >= table_.size()) {
    enlargeTable();
    slot = slotOf(place);
  }
  table_[slot] = {place, bricks_.size()};
  bricks_.emplace_back();
  bricks_.back().fill(0.0f);
  return table_[slot].brick;
}

void
TensionGrid::add(const Position& point, const Falloff& falloff, double tension)
{
  Place first, last, place;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    const double center = (point[axis] - origin_[axis]) / cell_;
    first[k] = static_cast<std::int32_t>(std::floor((center - CELLS_TO_FAR) / CELLS));
    last[k] = static_cast<std::int32_t>(std::floor((center + CELLS_TO_FAR) / CELLS));
  }
  for (place[0] = first[0]; place[0] <= last[0]; ++place[0])
    for (place[1] = first[1]; place[1] <= last[1]; ++place[1])
      for (place[2] = first[2]; place[2] <= last[2]; ++place[2])
        addToBrick(place, point, falloff, tension);
}

void
TensionGrid::addToBrick(const Place& place,
                        const Position& point,
                        const Falloff& falloff,
                        double tension)
{
  Brick& brick = bricks_[brickToWrite(place)];
  // The point as seen from the brick's first node, in cells.
  Position seen = (point - origin_) / cell_;
  std::array<int, 3> first, last;
  for (std::size_t k = 0; k < 3; ++k) {
    double& center = seen[static_cast<Eigen::Index>(k)];
    center -= static_cast<double>(place[k]) * CELLS;
    first[k] = std::max(0, static_cast<int>(std::ceil(center - CELLS_TO_FAR)));
    last[k] = std::min(NODES - 1, static_cast<int>(std::floor(center + CELLS_TO_FAR)));
  }
  for (int x = first[0]; x <= last[0]; ++x)
    for (int y = first[1]; y <= last[1]; ++y)
      for (int z = first[2]; z <= last[2]; ++z) {
        const double squared = (Position(x, y, z) - seen).squaredNorm();
        if (squared >= CELLS_TO_FAR * CELLS_TO_FAR)
          continue;
        const double distance = cell_ * std::sqrt(squared);
        brick[static_cast<std::size_t>((x * NODES + y) * NODES + z)] +=
            static_cast<float>(tension * falloff(distance)); // E4.45-2
      }
}

float
TensionGrid::at(const Position& cell, Slot& last) const
{
  if (!((cell.array() >= 0.0).all() && (cell.array() < size_.array()).all()))
    return 0.0f;
  Place place;
  std::array<int, 3> node;
  std::array<float, 3> share;
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = cell[static_cast<Eigen::Index>(k)];
    const auto index = static_cast<std::int32_t>(value);
    place[k] = index >> 3; // by CELLS
    node[k] = index & (CELLS - 1);
    share[k] = static_cast<float>(value - index);
  }
  const bool same = place[0] == last.place[0] && place[1] == last.place[1] &&
                    place[2] == last.place[2];
  if (!same) {
    last.brick = table_[slotOf(place)].brick;
    last.place = place;
  }
  if (last.brick == NO_BRICK)
    return 0.0f;
  const float* corner =
      bricks_[last.brick].data() + (node[0] * NODES + node[1]) * NODES + node[2];
  const auto alongZ = [&](int offset) {
    return corner[offset] + share[2] * (corner[offset + 1] - corner[offset]);
  };
  const auto alongY = [&](int offset) {
    const float low = alongZ(offset);
    return low + share[1] * (alongZ(offset + NODES) - low);
  };
  const float low = alongY(0);
  return low + share[0] * (alongY(NODES * NODES) - low);
}

double
TensionGrid::meanShrink(const Position& a, const Position& b, int parts) const
{
  if (bricks_.empty())
    return 1.0;
  // No place of a brick: the first look-up always asks the table.
  Slot last{{-1, -1, -1}, NO_BRICK};
  const Position start = (a - origin_) / cell_;
  const Eigen::Vector3d step = (b - a) / (cell_ * parts);
  float sum = 0.0f;
  for (int i = 0; i < parts; ++i)
    sum += 1.0f / (1.0f + at(start + (i + 0.5) * step, last)); // E4.424-2
  return static_cast<double>(sum) / parts;
}

} // namespace pcl::repair
