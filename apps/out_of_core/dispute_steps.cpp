// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what tiles agree about, and the groups of what they do not.
#include "out_of_core/step_file.h"
#include "out_of_core/tile_files.h"
#include "out_of_core/tile_steps.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace app {
namespace {

using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

/** What may be made anew around a dispute, as a share of the halo: two spacings. */
constexpr double REACH = 0.1;
/** Least and most room for what closes it, in reaches: up to where all is known. */
constexpr double LEAST_ROOM = 2.0, MOST_ROOM = 4.0;

/** Groups of more disputes are closed in parts: around each dispute there are 10 to 27
 * points, and of a cloud with noise of half its spacing nearly all disputes are one
 * group. 300 000 points with noise of 0.35 and 0.5 spacings in twelve tiles: 507 and
 * 5001 open edges, with whole groups 507 and 5230. */
constexpr std::size_t LARGE_GROUP = 500;

/** Those of the neighbors, too, where the tile does not know all corners of a triangle.
 * \return ascending */
pcl::ccaa::BorderPoints
pointsFor(const TilePlan& plan,
          std::size_t tile,
          const std::vector<WideTriangle>& triangles,
          pcl::ccaa::BorderPoints points)
{
  const auto isKnown = [&points](WideIndex corner) {
    return findPoint(points, corner) != points.end();
  };
  if (std::all_of(
          triangles.begin(), triangles.end(), [&](const WideTriangle& triangle) {
            return std::all_of(triangle.begin(), triangle.end(), isKnown);
          }))
    return points;
  for (const std::size_t neighbor : plan.tiling.neighborsOf(tile)) {
    const pcl::ccaa::BorderPoints more = readBorderPoints(plan, neighbor);
    points.insert(points.end(), more.begin(), more.end());
  }
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.index < b.index;
  });
  return points;
}

/** \param[in] points of the border \param[in,out] disputes get the corners of a refused
 * triangle; a closing takes room as the triangle did. */
void
addDisputes(const TilePlan& plan,
            const WideTriangle& triangle,
            const pcl::ccaa::BorderPoints& points,
            std::vector<PlacedDispute>& disputes)
{
  std::vector<pcl::ccaa::BorderPoint> corners;
  for (const WideIndex index : triangle)
    if (const auto place = findPoint(points, index); place != points.end())
      corners.push_back(*place);
  const double room =
      corners.size() < 3
          ? std::numeric_limits<double>::infinity()
          : 2.0 * pcl::ccaa::longestEdge(
                      {corners[0].position, corners[1].position, corners[2].position});
  for (const pcl::ccaa::BorderPoint& corner : corners) {
    const double halo = plan.tiling.tiles[plan.tiling.ownerOf(corner.index)].halo;
    PlacedDispute dispute;
    dispute.index = corner.index;
    Eigen::Map<Eigen::Vector3d>(dispute.position.data()) = corner.position;
    dispute.reach =
        std::clamp(room / MOST_ROOM, REACH * halo, REACH * std::max(halo, corner.halo));
    dispute.room =
        std::clamp(room, LEAST_ROOM * dispute.reach, MOST_ROOM * dispute.reach);
    disputes.push_back(dispute);
  }
}

/** Each once, ascending, with the most room. */
void
keepWidest(std::vector<PlacedDispute>& disputes)
{
  std::sort(disputes.begin(), disputes.end(), [](const auto& a, const auto& b) {
    return std::make_pair(a.index, -a.room) < std::make_pair(b.index, -b.room);
  });
  disputes.erase(
      std::unique(disputes.begin(),
                  disputes.end(),
                  [](const auto& a, const auto& b) { return a.index == b.index; }),
      disputes.end());
}

/** A large group as parts: the disputes that are of one tile. */
void
addGroup(const TilePlan& plan,
         const std::vector<PlacedDispute>& group,
         AllDisputes& grouped)
{
  const std::uint64_t whole = grouped.groups.size();
  const bool in_parts = group.size() > LARGE_GROUP;
  for (const PlacedDispute& dispute : group) {
    const std::uint64_t owner = plan.tiling.ownerOf(dispute.index);
    if (grouped.groups.size() == whole ||
        (in_parts && grouped.groups.back().tile != owner))
      grouped.groups.push_back(
          {owner, whole, grouped.disputes.size(), grouped.disputes.size()});
    grouped.disputes.push_back(dispute);
    ++grouped.groups.back().end;
  }
}

} // namespace

void
joinTile(const TilePlan& plan, std::size_t tile)
{
  if (isDone(plan.file(tile, JOIN_STEP), plan.key))
    return;
  pcl::ccaa::BorderMesh own{readBorderPoints(plan, tile),
                            readBorderTriangles(plan, tile, tile)};
  std::vector<std::vector<WideTriangle>> others;
  for (const std::size_t neighbor : plan.tiling.neighborsOf(tile))
    others.push_back(readBorderTriangles(plan, neighbor, tile));
  pcl::ccaa::Agreed agreed = agree(plan.tiling, tile, own, others);
  JoinedTile joined;
  joined.triangles = std::move(agreed.triangles);
  const pcl::ccaa::BorderPoints points =
      pointsFor(plan, tile, agreed.refused, std::move(own.points));
  for (const WideTriangle& triangle : agreed.refused)
    addDisputes(plan, triangle, points, joined.disputes);
  keepWidest(joined.disputes);
  writeJoined(plan, tile, joined);
}

void
groupAllDisputes(const TilePlan& plan)
{
  if (isDone(plan.file(DISPUTES_FILE), plan.key))
    return;
  std::vector<PlacedDispute> all;
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile) {
    const std::vector<PlacedDispute> more = readJoined(plan, tile).disputes;
    all.insert(all.end(), more.begin(), more.end());
  }
  keepWidest(all);
  std::vector<pcl::ccaa::Dispute> disputes;
  for (const PlacedDispute& dispute : all)
    disputes.push_back(
        {dispute.index,
         (Eigen::Vector3d(dispute.position.data()) - plan.origin).cast<float>(),
         static_cast<float>(dispute.room)});
  const std::vector<std::size_t> group_of = groupDisputes(disputes);
  AllDisputes grouped;
  std::vector<std::vector<PlacedDispute>> by_group;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (group_of[i] == by_group.size())
      by_group.emplace_back();
    by_group[group_of[i]].push_back(all[i]);
  }
  for (const std::vector<PlacedDispute>& group : by_group)
    addGroup(plan, group, grouped);
  writeDisputes(plan, grouped);
}

} // namespace app
