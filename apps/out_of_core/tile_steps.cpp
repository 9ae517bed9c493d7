// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the steps of a reconstruction tile by tile.
#include "out_of_core/tile_steps.h"

#include "cli/cli.h"
#include "cli/repair_run.h"
#include "out_of_core/step_file.h"
#include "out_of_core/tile_cloud.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace app {
namespace {

using pcl::ccaa::cornersInOrder;
using pcl::ccaa::Position;
using pcl::ccaa::Tile;
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

/** The chain on one tile. */
ReconstructResult
reconstructTile(const TilePlan& plan,
                std::size_t tile,
                TileCloud& cloud,
                const StepRun& run)
{
  ReconstructSettings settings = settingsOf(plan);
  settings.threads = run.threads;
  ReconstructResult result;
  result.model.mesh.cloud = cloud.take();
  result.model.shift = pcl::GlobalShift(plan.corners[tile]);
  result.model.viewpoint = plan.viewpoint;
  if (cloud.wide().size() >= 3)
    runReconstruction(settings, run.progress, result);
  if (result.chain.cancelled)
    throw Failure(stopped_by_signal);
  return result;
}

/** Sorts the triangles that a tile may keep into those of which seams have to know and
 * the others. */
class MeshSorter {
public:
  MeshSorter(const TilePlan& plan,
             std::size_t tile,
             const TileCloud& cloud,
             const pcl::ccaa::PointView& positions)
  : own_(plan.tiling.tiles[tile])
  , wide_(cloud.wide())
  , halos_(cloud.halos())
  , positions_(positions)
  {
    const auto others = pcl::ccaa::TilesAround::border(plan.tiling, tile);
    const auto sight = pcl::ccaa::TilesAround::sight(plan.tiling, tile);
    for (std::size_t i = 0; i < wide_.size(); ++i) {
      const Position position = positions[i];
      const double halo = halos_[i];
      is_border_.push_back(others.isNear(position, halo));
      is_sighted_.push_back(is_border_.back() && sight.isNear(position, halo));
      is_seen_.push_back(own_.sees(position, halo));
      if (halo > 0.0 && is_sighted_.back())
        addAround(i);
    }
  }

  void
  add(const pcl::Indices& corners)
  {
    if (hasAny(is_seen_, corners, false))
      return;
    triangles_.push_back({corners[0], corners[1], corners[2]});
    if (hasAny(is_sighted_, corners, true))
      noteFarCorners(triangles_.back());
  }

  TileMesh
  take()
  {
    addAroundFarCorners();
    TileMesh mesh;
    std::vector<bool> is_told = is_border_;
    for (const Triangle& triangle : triangles_) {
      const WideTriangle wide{wide_[std::size_t(triangle[0])],
                              wide_[std::size_t(triangle[1])],
                              wide_[std::size_t(triangle[2])]};
      const bool is_inner = std::all_of(wide.begin(),
                                        wide.end(),
                                        [&](WideIndex i) { return own_.owns(i); }) &&
                            !hasAny(is_border_, triangle, true) && !isLong(triangle);
      if (!is_inner) {
        mesh.border.triangles.push_back(wide);
        for (const pcl::index_t corner : triangle)
          is_told[static_cast<std::size_t>(corner)] = true;
      }
      else
        mesh.inner.push_back({static_cast<std::uint32_t>(wide[0] - own_.first),
                              static_cast<std::uint32_t>(wide[1] - own_.first),
                              static_cast<std::uint32_t>(wide[2] - own_.first)});
    }
    for (std::size_t i = 0; i < wide_.size(); ++i)
      if (is_told[i])
        mesh.border.points.push_back({wide_[i], positions_[i], halos_[i]});
    return mesh;
  }

private:
  using Triangle = pcl::ccaa::Triangle;

  template <typename Corners>
  static bool
  hasAny(const std::vector<bool>& flags, const Corners& corners, bool value)
  {
    return std::any_of(corners.begin(), corners.end(), [&](pcl::index_t corner) {
      return flags[static_cast<std::size_t>(corner)] == value;
    });
  }

  Position
  at(pcl::index_t i) const
  {
    return positions_[static_cast<std::size_t>(i)];
  }

  /** Such a triangle may reach from within the tile to where others meet it. */
  bool
  isLong(const Triangle& triangle) const
  {
    return pcl::ccaa::longestEdge({at(triangle[0]), at(triangle[1]), at(triangle[2])}) >
           Tile::LONGEST * own_.halo;
  }

  /** What seams have to know around a point that may be disputed. */
  void
  addAround(std::size_t i)
  {
    const pcl::ccaa::Box around = pcl::ccaa::widened(
        pcl::ccaa::Box(positions_[i]), Tile::TOLD * std::max(own_.halo, halos_[i]));
    if (around.intersects(own_.box))
      around_far_.push_back(around);
  }

  /** A triangle that is too long to be believed, or of sparse points, is disputed at
   * its other corners, too, however far they are from where tiles meet. */
  void
  noteFarCorners(const Triangle& triangle)
  {
    const bool is_long = isLong(triangle);
    for (const pcl::index_t corner : triangle) {
      const auto i = static_cast<std::size_t>(corner);
      if (!is_sighted_[i] && (is_long || halos_[i] > 0.0))
        addAround(i);
    }
  }

  /** What is around them may be made anew as around others. */
  void
  addAroundFarCorners()
  {
    const pcl::ccaa::BoxTree tree(around_far_);
    for (std::size_t i = 0; i < wide_.size() && !around_far_.empty(); ++i)
      if (!is_border_[i])
        is_border_[i] = tree.anyMeeting(pcl::ccaa::Box(positions_[i]),
                                        [](pcl::index_t) { return true; });
  }

  const Tile& own_;
  const std::vector<WideIndex>& wide_;
  const std::vector<double>& halos_;
  pcl::ccaa::PointView positions_;
  std::vector<bool> is_border_, is_sighted_, is_seen_;
  pcl::ccaa::Triangles triangles_;
  std::vector<pcl::ccaa::Box> around_far_;
};

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

pcl::ccaa::TileDoubts
doubtsOf(const ReconstructResult& result)
{
  using pcl::ccaa::PlacedCount;
  const pcl::ccaa::PointView points = pcl::ccaa::positionView(result.model.mesh.cloud);
  const auto& [handles, thin, touching, necks] = result.chain.doubts;
  const auto first = [](const pcl::Indices& places) {
    return places.empty() ? pcl::UNAVAILABLE : places.front();
  };
  return {PlacedCount::at(handles, points, first(thin)),
          PlacedCount::at(touching.size(),
                          points,
                          touching.empty() ? pcl::UNAVAILABLE : touching.front()[0]),
          PlacedCount::at(necks.size(), points, first(necks)),
          result.start.points,
          result.usedPlaces()};
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
meshTile(const TilePlan& plan, std::size_t tile, const StepRun& run)
{
  if (isDone(plan.file(tile, MESH_STEP), plan.key))
    return;
  TileCloud cloud(plan, tile);
  const ReconstructResult result = reconstructTile(plan, tile, cloud, run);
  MeshSorter sorter(
      plan, tile, cloud, pcl::ccaa::positionView(result.model.mesh.cloud));
  for (const pcl::Vertices& polygon : result.model.mesh.polygons)
    sorter.add(polygon.vertices);
  TileMesh mesh = sorter.take();
  mesh.doubts = doubtsOf(result);
  writeMesh(plan, tile, std::move(mesh));
}

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
