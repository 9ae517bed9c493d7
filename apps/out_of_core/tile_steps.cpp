// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the steps of a reconstruction tile by tile.
#include "out_of_core/tile_steps.h"

#include "cli/cli.h"
#include "cli/repair_run.h"
#include "mesh/side_hints.h"
#include "mesh/sort_unique.h"
#include "out_of_core/seam_gathering.h"
#include "out_of_core/step_file.h"
#include "out_of_core/tile_cloud.h"
#include "run/threads.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace app {
namespace {

using pcl::ccaa::cornersInOrder;
using pcl::ccaa::Position;
using pcl::ccaa::Tile;
using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

/** What may be closed around a dispute, as a share of the halo: two spacings. */
constexpr double REACH = 0.1;

bool
isOwn(const Tile& tile, WideIndex index)
{
  return index >= tile.first && index < tile.first + tile.count;
}

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

/** Sorts the triangles that a tile may keep into those at its border and the others. */
class MeshSorter {
public:
  MeshSorter(const TilePlan& plan,
             std::size_t tile,
             const std::vector<WideIndex>& wide,
             const pcl::ccaa::PointView& positions)
  : own_(plan.tiling.tiles[tile]), wide_(wide)
  {
    const std::vector<std::size_t> neighbors = plan.tiling.neighborsOf(tile);
    for (std::size_t i = 0; i < wide.size(); ++i) {
      const Position position = positions[i];
      is_border_.push_back(plan.tiling.isNearOthers(position, neighbors));
      is_seen_.push_back(own_.sees(position));
      if (is_border_.back())
        mesh.border.points.push_back({wide[i], position});
    }
  }

  void
  add(const pcl::Indices& corners)
  {
    WideTriangle triangle{};
    bool is_inner = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto corner = static_cast<std::size_t>(corners[i]);
      if (!is_seen_[corner])
        return;
      triangle[i] = wide_[corner];
      is_inner = is_inner && !is_border_[corner] && isOwn(own_, triangle[i]);
    }
    if (!is_inner)
      mesh.border.triangles.push_back(triangle);
    else
      mesh.inner.push_back({static_cast<std::uint32_t>(triangle[0] - own_.first),
                            static_cast<std::uint32_t>(triangle[1] - own_.first),
                            static_cast<std::uint32_t>(triangle[2] - own_.first)});
  }

  TileMesh mesh;

private:
  const Tile& own_;
  const std::vector<WideIndex>& wide_;
  std::vector<bool> is_border_, is_seen_;
};

/** Tiles that close groups which touch the border of a tile. */
std::set<std::size_t>
closersAround(const TilePlan& plan, std::size_t tile, const AllDisputes& disputes)
{
  std::set<std::size_t> parts{tile};
  for (const std::size_t part : plan.tiling.neighborsOf(tile))
    parts.insert(part);
  std::set<std::size_t> closers;
  for (const DisputeGroup& group : disputes.groups)
    for (std::uint64_t i = group.begin; i < group.end; ++i)
      if (parts.count(plan.tiling.ownerOf(disputes.disputes[i].index)) > 0)
        closers.insert(static_cast<std::size_t>(group.tile));
  return closers;
}

/** Triangles of the border of a tile after all seams were closed. */
std::vector<WideTriangle>
finalBorder(const TilePlan& plan, std::size_t tile)
{
  const std::set<std::size_t> closers = closersAround(plan, tile, readDisputes(plan));
  std::set<WideTriangle> removed; // some of them are added again
  std::vector<WideTriangle> added;
  for (const std::size_t closer : closers) {
    const ClosedTile closed = readClosed(plan, closer);
    removed.insert(closed.removed.begin(), closed.removed.end());
    for (const WideTriangle& triangle : closed.added)
      if (plan.tiling.ownerOf(cornersInOrder(triangle).front()) == tile)
        added.push_back(triangle);
  }
  std::vector<WideTriangle> triangles = readJoined(plan, tile).triangles;
  const auto is_removed = [&](const WideTriangle& triangle) {
    return removed.count(cornersInOrder(triangle)) > 0;
  };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), is_removed),
                  triangles.end());
  triangles.insert(triangles.end(), added.begin(), added.end());
  return triangles;
}

/** The corners that other tiles have. */
std::vector<WideIndex>
foreignCorners(const Tile& own, const std::vector<WideTriangle>& triangles)
{
  std::vector<WideIndex> foreign;
  for (const WideTriangle& triangle : triangles)
    for (const WideIndex corner : triangle)
      if (!isOwn(own, corner))
        foreign.push_back(corner);
  pcl::ccaa::sortUnique(foreign);
  return foreign;
}

/** All triangles of a tile, in places of its cloud. */
pcl::ccaa::Triangles
finalTriangles(const TilePlan& plan,
               std::size_t tile,
               const TileCloud& cloud,
               const std::vector<WideTriangle>& border)
{
  pcl::ccaa::Triangles triangles;
  const auto first = static_cast<std::uint32_t>(cloud.firstOwn());
  for (const CoreTriangle& inner : readMesh(plan, tile, true).inner)
    triangles.push_back({static_cast<pcl::index_t>(first + inner[0]),
                         static_cast<pcl::index_t>(first + inner[1]),
                         static_cast<pcl::index_t>(first + inner[2])});
  for (const WideTriangle& triangle : border)
    triangles.push_back({cloud.placeOf(triangle[0]),
                         cloud.placeOf(triangle[1]),
                         cloud.placeOf(triangle[2])});
  return triangles;
}

/** The triangles in numbers of the tile, piece by piece. */
TileSurface
surfaceOf(const Tile& own,
          const std::vector<WideIndex>& wide,
          const pcl::ccaa::Triangles& triangles,
          const std::vector<std::uint32_t>& piece_of)
{
  TileSurface surface;
  for (const pcl::ccaa::Triangle& triangle : triangles)
    for (const pcl::index_t corner : triangle)
      if (!isOwn(own, wide[static_cast<std::size_t>(corner)]))
        surface.foreign.push_back(wide[static_cast<std::size_t>(corner)]);
  pcl::ccaa::sortUnique(surface.foreign);
  const auto numberOf = [&](WideIndex index) {
    if (isOwn(own, index))
      return static_cast<std::uint32_t>(index - own.first);
    const auto place =
        std::lower_bound(surface.foreign.begin(), surface.foreign.end(), index);
    return static_cast<std::uint32_t>(own.count) +
           static_cast<std::uint32_t>(place - surface.foreign.begin());
  };
  std::vector<std::uint64_t>& ends = surface.piece_ends;
  for (const std::uint32_t piece : piece_of) {
    ends.resize(std::max<std::size_t>(ends.size(), piece + 1), 0);
    ++ends[piece];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::uint64_t> next(ends.size() + 1, 0);
  std::copy(ends.begin(), ends.end(), next.begin() + 1);
  surface.triangles.resize(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    CoreTriangle& place = surface.triangles[next[piece_of[t]]++];
    for (std::size_t i = 0; i < 3; ++i)
      place[i] = numberOf(wide[static_cast<std::size_t>(triangles[t][i])]);
  }
  return surface;
}

/** Hints about the outer side for the cloud of a tile, relative to its corner. */
pcl::ccaa::OrientationHints
hintsFor(const TilePlan& plan,
         std::size_t tile,
         const pcl::PCLPointCloud2& cloud,
         unsigned int threads)
{
  pcl::ccaa::OrientationHints hints;
  const Position corner = plan.corners[tile];
  static_cast<pcl::ccaa::SideHints&>(hints) =
      relativeTo(corner, sidesOf(settingsOf(plan).sides, plan.viewpoint));
  hints.threads = pcl::ccaa::resolveThreads(threads);
  hints.normals = pcl::ccaa::normalView(cloud);
  hints.viewpoints = pcl::ccaa::viewpointView(cloud);
  if (!hints.viewpoints.empty())
    hints.viewpoints = hints.viewpoints.relativeTo(corner);
  return hints;
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
      plan, tile, cloud.wide(), pcl::ccaa::positionView(result.model.mesh.cloud));
  for (const pcl::Vertices& polygon : result.model.mesh.polygons)
    sorter.add(polygon.vertices);
  writeMesh(plan, tile, sorter.mesh);
}

void
joinTile(const TilePlan& plan, std::size_t tile)
{
  if (isDone(plan.file(tile, JOIN_STEP), plan.key))
    return;
  const TileMesh own = readMesh(plan, tile, false);
  std::vector<std::vector<WideTriangle>> others;
  pcl::ccaa::BorderPoints points = own.border.points;
  for (const std::size_t neighbor : plan.tiling.neighborsOf(tile)) {
    others.emplace_back();
    const TileMesh other = readMesh(plan, neighbor, false);
    for (const WideTriangle& triangle : other.border.triangles)
      if (plan.tiling.ownerOf(cornersInOrder(triangle).front()) == tile)
        others.back().push_back(triangle);
    points.insert(points.end(), other.border.points.begin(), other.border.points.end());
  }
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.index < b.index;
  });
  pcl::ccaa::Agreed agreed = agree(plan.tiling, tile, own.border, others);
  JoinedTile joined;
  joined.triangles = std::move(agreed.triangles);
  for (const WideIndex index : agreed.disputes)
    if (const auto place = findPoint(points, index); place != points.end()) {
      PlacedDispute dispute;
      dispute.index = index;
      Eigen::Map<Eigen::Vector3d>(dispute.position.data()) = place->position;
      dispute.reach = REACH * plan.tiling.tiles[plan.tiling.ownerOf(index)].halo;
      joined.disputes.push_back(dispute);
    }
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
  const auto isLower = [](const auto& a, const auto& b) { return a.index < b.index; };
  const auto isSame = [](const auto& a, const auto& b) { return a.index == b.index; };
  std::sort(all.begin(), all.end(), isLower);
  all.erase(std::unique(all.begin(), all.end(), isSame), all.end());
  std::vector<pcl::ccaa::Dispute> disputes;
  for (const PlacedDispute& dispute : all)
    disputes.push_back(
        {dispute.index,
         (Eigen::Vector3d(dispute.position.data()) - plan.origin).cast<float>(),
         static_cast<float>(dispute.reach)});
  const std::vector<std::size_t> group_of = groupDisputes(disputes);
  AllDisputes grouped;
  std::vector<std::vector<PlacedDispute>> by_group;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (group_of[i] == by_group.size())
      by_group.emplace_back();
    by_group[group_of[i]].push_back(all[i]);
  }
  for (const std::vector<PlacedDispute>& group : by_group) {
    const std::uint64_t begin = grouped.disputes.size();
    grouped.disputes.insert(grouped.disputes.end(), group.begin(), group.end());
    grouped.groups.push_back({plan.tiling.ownerOf(group.front().index),
                              begin,
                              std::uint64_t{grouped.disputes.size()}});
  }
  writeDisputes(plan, grouped);
}

void
closeTile(const TilePlan& plan, std::size_t tile, const StepRun& run)
{
  if (isDone(plan.file(tile, CLOSE_STEP), plan.key))
    return;
  ClosedTile closed;
  SeamGathering gathering(plan, tile);
  if (!gathering.empty()) {
    const pcl::ccaa::Seam seam = gathering.gather();
    const pcl::ccaa::SeamFilling filling =
        closeSeam(seam,
                  pcl::ccaa::CompletionParameters(),
                  pcl::ccaa::resolveThreads(run.threads),
                  run.progress);
    for (const pcl::index_t t : filling.removed)
      closed.removed.push_back(
          cornersInOrder(gathering.toWide(seam.given[static_cast<std::size_t>(t)])));
    for (const pcl::ccaa::Triangle& triangle : filling.added)
      closed.added.push_back(gathering.toWide(triangle));
    closed.failed = filling.error.empty() ? 0 : 1;
  }
  writeClosed(plan, tile, closed);
}

void
windTile(const TilePlan& plan, std::size_t tile, const StepRun& run)
{
  if (isDone(plan.file(tile, PIECES_STEP), plan.key))
    return;
  const std::vector<WideTriangle> border = finalBorder(plan, tile);
  const TileCloud cloud(plan, tile, foreignCorners(plan.tiling.tiles[tile], border));
  const Position corner = plan.corners[tile];
  pcl::ccaa::Triangles triangles = finalTriangles(plan, tile, cloud, border);
  pcl::ccaa::RunControl control(run.progress);
  std::vector<std::uint32_t> piece_of;
  const pcl::ccaa::TilePieces pieces =
      sumUpSides(triangles,
                 cloud.wide(),
                 pcl::ccaa::positionView(cloud.cloud()).relativeTo(corner),
                 plan.origin - corner,
                 hintsFor(plan, tile, cloud.cloud(), run.threads),
                 control,
                 piece_of);
  if (control.cancelled())
    throw Failure(stopped_by_signal);
  writePieces(plan,
              tile,
              surfaceOf(plan.tiling.tiles[tile], cloud.wide(), triangles, piece_of),
              pieces);
}

void
decideAllSides(const TilePlan& plan)
{
  if (isDone(plan.file(SIDES_FILE), plan.key))
    return;
  std::vector<pcl::ccaa::TilePieces> tiles;
  for (std::size_t tile = 0; tile < plan.tiling.tiles.size(); ++tile)
    tiles.push_back(readPiecesSums(plan, tile));
  writeSides(plan, decideSides(tiles, true));
}

SeamLinks
seamLinks(const TilePlan& plan, std::size_t tile)
{
  const std::set<std::size_t> parts = SeamGathering(plan, tile).parts();
  const std::set<std::size_t> closers = closersAround(plan, tile, readDisputes(plan));
  return {{parts.begin(), parts.end()}, {closers.begin(), closers.end()}};
}

TileSurface
readSurface(const TilePlan& plan, std::size_t tile)
{
  TileSurface surface = readPiecesSurface(plan, tile);
  const pcl::ccaa::Sides sides = readSides(plan);
  const Tile& own = plan.tiling.tiles[tile];
  const auto wideOf = [&](std::uint32_t corner) {
    return corner < own.count ? own.first + corner
                              : surface.foreign[corner - own.count];
  };
  const std::set<std::array<WideIndex, 2>> torn(sides.torn.begin(), sides.torn.end());
  const auto isTorn = [&](const CoreTriangle& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<WideIndex, 2> edge{wideOf(triangle[i]), wideOf(triangle[(i + 1) % 3])};
      std::sort(edge.begin(), edge.end());
      if (torn.count(edge) > 0)
        return true;
    }
    return false;
  };
  std::vector<CoreTriangle> left;
  std::size_t piece = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    while (t >= surface.piece_ends[piece])
      ++piece;
    CoreTriangle triangle = surface.triangles[t];
    if (sides.turn[tile][piece] != 0)
      std::swap(triangle[1], triangle[2]);
    if (torn.empty() || !isTorn(triangle))
      left.push_back(triangle);
  }
  surface.triangles = std::move(left);
  return surface;
}

} // namespace app
