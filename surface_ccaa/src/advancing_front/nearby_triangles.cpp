// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the triangles around open points, for crossing tests.
#include "advancing_front/nearby_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_set>

namespace pcl {
namespace ccaa {
namespace {

using Cell = std::array<std::int64_t, 3>;

/** Cells farther out than any sensible coordinate are one cell. */
constexpr double LAST_CELL = 1e15;

/** Cells may share a number, which chooses a few triangles too many. */
std::uint64_t
numberOf(const Cell& cell)
{
  std::uint64_t number = 0;
  for (const std::int64_t coordinate : cell)
    number = (number ^ static_cast<std::uint64_t>(coordinate)) * 0x9e3779b97f4a7c15u;
  return number;
}

Cell
cellOf(const Position& position, double size)
{
  const auto along = [&](int axis) {
    const double cell = std::floor(position[axis] / size);
    return static_cast<std::int64_t>(std::clamp(cell, -LAST_CELL, LAST_CELL));
  };
  return {along(0), along(1), along(2)};
}

/** The cells of the open points and all around them. */
std::unordered_set<std::uint64_t>
cellsAround(const PointView& points, const std::vector<pcl::index_t>& open, double size)
{
  std::unordered_set<std::uint64_t> cells, seen;
  for (const pcl::index_t vertex : open) {
    const Cell middle = cellOf(points[vertex], size);
    if (!seen.insert(numberOf(middle)).second)
      continue;
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z)
          cells.insert(numberOf({middle[0] + x, middle[1] + y, middle[2] + z}));
  }
  return cells;
}

} // namespace

NearbyTriangles::NearbyTriangles(const Triangles& triangles,
                                 const AliveFlags& alive,
                                 const PointView& points,
                                 const std::vector<pcl::index_t>& open,
                                 double cell)
: triangles_(triangles), alive_(alive), points_(points)
{
  if (open.empty() || triangles.empty() || !(cell > 0.0))
    return;
  const auto cells = cellsAround(points, open, cell);
  std::uint64_t last = 0;
  bool last_is_near = false;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::uint64_t number = numberOf(cellOf(points[triangles[t][0]], cell));
    if (t == 0 || number != last) { // neighbors in the list mostly share a cell
      last = number;
      last_is_near = cells.count(number) != 0;
    }
    if (last_is_near || isLong(static_cast<pcl::index_t>(t), cell))
      chosen_.push_back(static_cast<pcl::index_t>(t));
  }
  std::vector<Box> boxes;
  boxes.reserve(chosen_.size());
  for (const pcl::index_t t : chosen_)
    boxes.push_back(boxOf(cornersOf(triangles[static_cast<std::size_t>(t)], points)));
  tree_ = std::make_unique<BoxTree>(boxes);
}

/** Triangles that may reach into a cell far from their first corner. There are few. */
bool
NearbyTriangles::isLong(pcl::index_t triangle, double cell) const
{
  const Corners c = cornersOf(triangles_[static_cast<std::size_t>(triangle)], points_);
  return (c[1] - c[0]).cwiseAbs().maxCoeff() > cell ||
         (c[2] - c[0]).cwiseAbs().maxCoeff() > cell;
}

bool
NearbyTriangles::meets(const Corners& corners,
                       const Box& box,
                       const std::vector<pcl::index_t>& ignored) const
{
  bool found = false;
  if (tree_)
    tree_->forEachMeeting(box, [&](pcl::index_t place) {
      const pcl::index_t chosen = chosen_[static_cast<std::size_t>(place)];
      const auto t = static_cast<std::size_t>(chosen);
      found = found || (alive_[t] != 0 &&
                        !std::binary_search(ignored.begin(), ignored.end(), chosen) &&
                        trianglesMeet(corners, cornersOf(triangles_[t], points_)));
    });
  return found;
}

} // namespace ccaa
} // namespace pcl
