// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the triangles around open points, for crossing tests.
#include "advancing_front/nearby_triangles.h"

#include "advancing_front/tuning.h"
#include "mesh/curve_order.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>

namespace pcl::ccaa {
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

/** Triangles that may reach into a cell far from their first corner. There are few. */
bool
isLong(const Corners& c, double cell)
{
  return (c[1] - c[0]).cwiseAbs().maxCoeff() > cell ||
         (c[2] - c[0]).cwiseAbs().maxCoeff() > cell;
}

} // namespace

NearbyTriangles::NearbyTriangles(const Triangles& triangles,
                                 const AliveFlags& alive,
                                 const PointView& points,
                                 const std::vector<pcl::index_t>& open,
                                 double cell,
                                 int threads)
: triangles_(triangles), alive_(alive), points_(points)
{
  if (open.empty() || triangles.empty() || !(cell > 0.0))
    return;
  const LoopContext context{threads};
  choose(open, cell, context);
  if (!isInOrder())
    sortAlongCurve(threads);
  tree_ = BoxTree(chosen_.size(), context, [this](std::size_t place) {
    return boxOf(cornersAt(place));
  });
}

void
NearbyTriangles::choose(const std::vector<pcl::index_t>& open,
                        double cell,
                        const LoopContext& context)
{
  const auto cells = cellsAround(points_, open, cell);
  std::vector<std::vector<pcl::index_t>> chosen(context.blockCount(triangles_.size()));
  const auto look = [&](std::size_t block, std::size_t begin, std::size_t end) {
    std::uint64_t last = 0;
    bool last_is_near = false;
    for (std::size_t t = begin; t < end; ++t) {
      const std::uint64_t number = numberOf(cellOf(points_[triangles_[t][0]], cell));
      if (t == begin || number != last) { // neighbors in the list mostly share a cell
        last = number;
        last_is_near = cells.count(number) != 0;
      }
      if (last_is_near || isLong(cornersOf(triangles_[t], points_), cell))
        chosen[block].push_back(static_cast<pcl::index_t>(t));
    }
  };
  forEachBlock(triangles_.size(), context, look);
  chosen_ = joinBlocks(chosen);
}

/** Whether neighbors in the list are close in space, as a greedy start makes them: on
 * the average as far apart as a few edges. Looked at are samples. */
bool
NearbyTriangles::isInOrder() const
{
  double between = 0.0, along = 0.0;
  for (std::size_t place = 1; place < chosen_.size(); place += tuning::SPACING_STRIDE) {
    const Corners corners = cornersAt(place);
    between += (corners[0] - cornersAt(place - 1)[0]).norm();
    along += (corners[1] - corners[0]).norm();
  }
  return between <= tuning::MOST_BETWEEN * along;
}

/** Neighbors in the tree must be close in space, in whatever order they were given. */
void
NearbyTriangles::sortAlongCurve(int threads)
{
  std::vector<pcl::index_t> order = curveOrder(
      chosen_.size(), [&](std::size_t place) { return cornersAt(place)[0]; }, threads);
  for (pcl::index_t& place : order)
    place = chosen_[static_cast<std::size_t>(place)];
  chosen_ = std::move(order);
}

std::vector<pcl::index_t>
NearbyTriangles::crossingAt(const std::vector<pcl::index_t>& watched,
                            std::size_t vertices,
                            const LoopContext& context) const
{
  std::vector<std::uint8_t> is_watched(vertices, 0);
  for (const pcl::index_t vertex : watched)
    is_watched[static_cast<std::size_t>(vertex)] = 1;
  const auto isAsked = [&](pcl::index_t triangle) {
    const Triangle& corners = triangles_[static_cast<std::size_t>(triangle)];
    return isAlive(triangle) &&
           std::any_of(corners.begin(), corners.end(), [&](pcl::index_t corner) {
             return is_watched[static_cast<std::size_t>(corner)] != 0;
           });
  };
  std::vector<std::vector<pcl::index_t>> found(context.blockCount(chosen_.size()));
  forEachBlock(chosen_.size(), context, [&](auto block, auto begin, auto end) {
    for (std::size_t place = begin; place < end; ++place) {
      if (!isAsked(chosen_[place]))
        continue;
      const Corners corners = cornersAt(place);
      tree_.forEachMeeting(corners, [&](pcl::index_t met) {
        const auto other = static_cast<std::size_t>(met);
        const pcl::index_t triangle = chosen_[other];
        const bool is_asked = isAsked(triangle); // then the first of both asks
        if ((is_asked ? other <= place : !isAlive(triangle)) ||
            !trianglesMeet(corners, cornersAt(other)))
          return;
        found[block].push_back(chosen_[place]);
        if (is_asked)
          found[block].push_back(triangle);
      });
    }
  });
  std::vector<pcl::index_t> crossing = joinBlocks(found);
  sortUnique(crossing);
  return crossing;
}

bool
NearbyTriangles::meets(const Corners& corners,
                       const std::vector<pcl::index_t>& ignored) const
{
  return tree_.anyMeeting(corners, [&](pcl::index_t found) {
    const auto place = static_cast<std::size_t>(found);
    const pcl::index_t triangle = chosen_[place];
    return isAlive(triangle) &&
           !std::binary_search(ignored.begin(), ignored.end(), triangle) &&
           trianglesMeet(corners, cornersAt(place));
  });
}

} // namespace pcl::ccaa
