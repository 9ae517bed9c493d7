// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what surrounds the places that a tile has to close.
#include "out_of_core/seam_gathering.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

/** What a seam has to know around a dispute, in reaches; twice that for the corners of
 * the triangles there. */
constexpr double AROUND = 4.0;
/** Up to where given triangles may be made anew. */
constexpr double NEAR = 1.5;

} // namespace

SeamGathering::SeamGathering(const TilePlan& plan, std::size_t tile)
: plan_(plan), tile_(tile)
{
  const AllDisputes all = readDisputes(plan);
  for (const DisputeGroup& group : all.groups)
    if (group.tile == tile)
      disputes_.insert(disputes_.end(),
                       all.disputes.begin() + static_cast<std::ptrdiff_t>(group.begin),
                       all.disputes.begin() + static_cast<std::ptrdiff_t>(group.end));
  std::sort(disputes_.begin(), disputes_.end(), [](const auto& a, const auto& b) {
    return a.index < b.index;
  });
  for (const PlacedDispute& dispute : disputes_) {
    edge_ = std::max(edge_, 2.0 * AROUND * dispute.reach);
    parts_.insert(plan.tiling.ownerOf(dispute.index));
  }
  for (const std::size_t owner : std::set<std::size_t>(parts_))
    for (const std::size_t part : plan.tiling.neighborsOf(owner))
      parts_.insert(part);
  for (std::size_t i = 0; i < disputes_.size(); ++i)
    grid_[gridPlace(Eigen::Vector3d(disputes_[i].position.data()), 13)].push_back(i);
}

/** \param[in] neighbor 0 to 26; 13 is the cell itself */
SeamGathering::GridPlace
SeamGathering::gridPlace(const Eigen::Vector3d& position, std::size_t neighbor) const
{
  const std::array<std::size_t, 3> step{
      neighbor % 3, neighbor / 3 % 3, neighbor / 9 % 3};
  GridPlace place{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    place[axis] = static_cast<std::int64_t>(
                      std::floor(position[static_cast<Eigen::Index>(axis)] / edge_)) +
                  static_cast<std::int64_t>(step[axis]) - 1;
  return place;
}

/** Distance from the nearest dispute in reaches of it, as far as it is below twice
 * AROUND. */
double
SeamGathering::nearness(const Eigen::Vector3d& position) const
{
  double least = 2.0 * AROUND;
  for (std::size_t neighbor = 0; neighbor < 27; ++neighbor) {
    const auto cell = grid_.find(gridPlace(position, neighbor));
    if (cell == grid_.end())
      continue;
    for (const std::size_t i : cell->second)
      least =
          std::min(least,
                   (Eigen::Vector3d(disputes_[i].position.data()) - position).norm() /
                       disputes_[i].reach);
  }
  return least;
}

void
SeamGathering::readParts()
{
  std::vector<WideTriangle> candidates;
  for (const std::size_t part : parts_) {
    const pcl::ccaa::Tile& tile = plan_.tiling.tiles[part];
    for (const pcl::ccaa::BorderPoint& point :
         readMesh(plan_, part, false).border.points) {
      if (point.index < tile.first || point.index >= tile.first + tile.count)
        continue;
      const double distance = nearness(point.position);
      if (distance < 2.0 * AROUND)
        known_.emplace(point.index, point.position);
      if (distance <= AROUND)
        near_.emplace(point.index, distance);
    }
    const JoinedTile joined = readJoined(plan_, part);
    candidates.insert(
        candidates.end(), joined.triangles.begin(), joined.triangles.end());
  }
  for (const WideTriangle& triangle : candidates)
    if (std::any_of(triangle.begin(),
                    triangle.end(),
                    [&](WideIndex corner) { return near_.count(corner) > 0; }) &&
        std::all_of(triangle.begin(), triangle.end(), [&](WideIndex corner) {
          return known_.count(corner) > 0;
        }))
      triangles_.push_back(triangle);
}

pcl::ccaa::Seam
SeamGathering::gather()
{
  readParts();
  std::set<WideIndex> used, with_triangle;
  for (const auto& [index, distance] : near_)
    used.insert(index);
  for (const WideTriangle& triangle : triangles_)
    with_triangle.insert(triangle.begin(), triangle.end());
  used.insert(with_triangle.begin(), with_triangle.end());
  wide_.assign(used.begin(), used.end());
  pcl::ccaa::Seam seam;
  for (const WideIndex index : wide_) {
    seam.points.push_back((known_.at(index) - plan_.corners[tile_]).cast<float>());
    const auto near = near_.find(index);
    const bool is_disputed = near != near_.end() && near->second == 0.0;
    const bool is_free =
        near != near_.end() && near->second <= 1.0 && with_triangle.count(index) == 0;
    seam.is_open.push_back(is_disputed || is_free ? 1 : 0);
    seam.is_near.push_back(near != near_.end() && near->second <= NEAR ? 1 : 0);
  }
  for (const WideTriangle& triangle : triangles_) {
    seam.given.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      seam.given.back()[i] = static_cast<pcl::index_t>(
          std::lower_bound(wide_.begin(), wide_.end(), triangle[i]) - wide_.begin());
  }
  return seam;
}

} // namespace app
