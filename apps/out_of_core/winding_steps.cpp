// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the last steps of a reconstruction tile by tile: seams, and
// the whole surface, outward.
#include "cli/cli.h"
#include "cli/repair_run.h"
#include "mesh/side_hints.h"
#include "mesh/sort_unique.h"
#include "out_of_core/seam_gathering.h"
#include "out_of_core/step_file.h"
#include "out_of_core/tile_cloud.h"
#include "out_of_core/tile_steps.h"
#include "run/threads.h"
#include "tiles/tearing.h"

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

/** The corners that other tiles have. */
std::vector<WideIndex>
foreignCorners(const Tile& own, const std::vector<WideTriangle>& triangles)
{
  std::vector<WideIndex> foreign;
  for (const WideTriangle& triangle : triangles)
    for (const WideIndex corner : triangle)
      if (!own.owns(corner))
        foreign.push_back(corner);
  pcl::ccaa::sortUnique(foreign);
  return foreign;
}

/** All triangles of a tile, in places of its cloud. */
pcl::ccaa::Triangles
finalTriangles(const TileMesh& mesh,
               const TileCloud& cloud,
               const std::vector<WideTriangle>& border)
{
  pcl::ccaa::Triangles triangles;
  const auto first = static_cast<std::uint32_t>(cloud.firstOwn());
  for (const CoreTriangle& inner : mesh.inner)
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
      if (!own.owns(wide[static_cast<std::size_t>(corner)]))
        surface.foreign.push_back(wide[static_cast<std::size_t>(corner)]);
  pcl::ccaa::sortUnique(surface.foreign);
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
      place[i] = numberIn(
          own, surface.foreign, wide[static_cast<std::size_t>(triangles[t][i])]);
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

/** What has to go where the surface is one-sided. */
void
tear(const TilePlan& plan, pcl::ccaa::Sides& sides)
{
  pcl::ccaa::Tearing tearing(sides.torn);
  while (!tearing.asked().empty()) {
    std::set<std::size_t> owners;
    for (const WideIndex point : tearing.asked())
      owners.insert(plan.tiling.ownerOf(point));
    std::set<std::size_t> parts = owners;
    for (const std::size_t owner : owners)
      for (const std::size_t part : plan.tiling.neighborsOf(owner))
        parts.insert(part);
    for (const std::size_t part : parts) {
      const TileSurface surface = readPiecesSurface(plan, part);
      for (const CoreTriangle& triangle : surface.triangles)
        tearing.see(surface.wideOf(plan.tiling.tiles[part], triangle));
    }
    tearing.settle();
  }
  sides.gone.assign(tearing.gone().begin(), tearing.gone().end());
  sides.open_edges += static_cast<std::uint64_t>(tearing.openEdges());
}

} // namespace

void
closeTile(const TilePlan& plan, std::size_t tile, const StepRun& run)
{
  if (isDone(plan.file(tile, CLOSE_STEP), plan.key))
    return;
  ClosedTile closed;
  SeamGathering gathering(plan, tile);
  for (const std::size_t earlier : gathering.earlier())
    if (run.wait)
      run.wait(earlier);
  if (gathering.size() > 0)
    gathering.read();
  std::vector<WideIndex> wide;
  const auto toWide = [&wide](const pcl::ccaa::Triangle& triangle) {
    return WideTriangle{wide[std::size_t(triangle[0])],
                        wide[std::size_t(triangle[1])],
                        wide[std::size_t(triangle[2])]};
  };
  for (std::size_t group = 0; group < gathering.size(); ++group) {
    const pcl::ccaa::Seam seam = gathering.gather(group, wide);
    const pcl::ccaa::SeamFilling filling =
        closeSeam(seam,
                  pcl::ccaa::CompletionParameters(),
                  pcl::ccaa::resolveThreads(run.threads),
                  run.progress);
    for (const pcl::index_t t : filling.removed)
      closed.removed.push_back(
          cornersInOrder(toWide(seam.given[static_cast<std::size_t>(t)])));
    for (const pcl::ccaa::Triangle& triangle : filling.added)
      closed.added.push_back(toWide(triangle));
    closed.failed += filling.error.empty() ? 0 : 1;
  }
  writeClosed(plan, tile, closed);
}

void
windTile(const TilePlan& plan, std::size_t tile, const StepRun& run)
{
  if (isDone(plan.file(tile, PIECES_STEP), plan.key))
    return;
  const std::vector<WideTriangle> border = trianglesAfter(
      plan, tile, readAllClosed(plan, closersAround(plan, tile, readDisputes(plan))));
  const TileCloud cloud(plan, tile, foreignCorners(plan.tiling.tiles[tile], border));
  const Position corner = plan.corners[tile];
  const TileMesh mesh = readInner(plan, tile);
  pcl::ccaa::Triangles triangles = finalTriangles(mesh, cloud, border);
  pcl::ccaa::RunControl control(run.progress);
  std::vector<std::uint32_t> piece_of;
  pcl::ccaa::TilePieces pieces =
      sumUpSides(triangles,
                 cloud.wide(),
                 pcl::ccaa::positionView(cloud.cloud()).relativeTo(corner),
                 plan.origin - corner,
                 hintsFor(plan, tile, cloud.cloud(), run.threads),
                 control,
                 piece_of);
  if (control.cancelled())
    throw Failure(stopped_by_signal);
  pieces.doubts = mesh.doubts;
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
  pcl::ccaa::Sides sides = decideSides(tiles, true);
  tiles.clear();
  tear(plan, sides);
  writeSides(plan, sides);
}

SeamLinks
seamLinks(const TilePlan& plan, std::size_t tile)
{
  const SeamGathering gathering(plan, tile);
  return {gathering.parts(),
          closersAround(plan, tile, readDisputes(plan)),
          gathering.earlier()};
}

TileSurface
readSurface(const TilePlan& plan, std::size_t tile)
{
  TileSurface surface = readPiecesSurface(plan, tile);
  const pcl::ccaa::Sides sides = readSides(plan);
  const Tile& own = plan.tiling.tiles[tile];
  const auto isGone = [&](const CoreTriangle& triangle) {
    return std::binary_search(sides.gone.begin(),
                              sides.gone.end(),
                              cornersInOrder(surface.wideOf(own, triangle)));
  };
  std::vector<CoreTriangle> left;
  std::size_t t = 0;
  for (std::size_t piece = 0; piece < surface.piece_ends.size(); ++piece) {
    for (; t < surface.piece_ends[piece]; ++t) {
      CoreTriangle triangle = surface.triangles[t];
      if (sides.turn[tile][piece] != 0)
        std::swap(triangle[1], triangle[2]);
      if (sides.gone.empty() || !isGone(triangle))
        left.push_back(triangle);
    }
    surface.piece_ends[piece] = left.size();
  }
  surface.triangles = std::move(left);
  return surface;
}

} // namespace app
