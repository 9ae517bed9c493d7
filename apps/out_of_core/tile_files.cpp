// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the steps of a run tile by tile write.
#include "out_of_core/tile_files.h"

#include "out_of_core/step_file.h"

#include <algorithm>
#include <map>
#include <utility>

namespace app {
namespace {

using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

/** A point as files have it: Eigen's types are not for copying bytes. */
struct StoredPoint {
  WideIndex index;
  std::array<double, 3> position;
  double halo;
};

/** The sums of a piece as plain numbers. */
struct StoredSums {
  std::array<double, 10> votes;
  std::array<double, 2> scalars;
  std::array<double, 9> vectors, tensor;
  std::array<double, 6> box;
  std::uint64_t triangles;
  std::int64_t open_edges;
};

/** What comes first in the file of a tile's mesh. */
struct MeshHead {
  pcl::ccaa::TileDoubts doubts;
  std::uint64_t own_begin, own_end; /**< among the border points, the tile's own */
};

/** Up to where of the triangles of a border those are that belong to a tile. */
struct OwnerEnd {
  std::uint64_t tile, end;
};

/** Brings triangles in the order of the tiles that they belong to. */
std::vector<OwnerEnd>
sortByOwner(const pcl::ccaa::Tiling& tiling, std::vector<WideTriangle>& triangles)
{
  std::map<std::uint64_t, std::vector<WideTriangle>> by_owner;
  for (const WideTriangle& triangle : triangles)
    by_owner[tiling.ownerOf(pcl::ccaa::cornersInOrder(triangle).front())].push_back(
        triangle);
  std::vector<OwnerEnd> ends;
  triangles.clear();
  for (const auto& [owner, owned] : by_owner) {
    triangles.insert(triangles.end(), owned.begin(), owned.end());
    ends.push_back({owner, std::uint64_t{triangles.size()}});
  }
  return ends;
}

pcl::ccaa::BorderPoints
restored(const std::vector<StoredPoint>& stored)
{
  pcl::ccaa::BorderPoints points;
  points.reserve(stored.size());
  for (const StoredPoint& point : stored)
    points.push_back({point.index, Eigen::Vector3d(point.position.data()), point.halo});
  return points;
}

StoredSums
stored(const pcl::ccaa::SideSums& sums)
{
  StoredSums result{};
  static_assert(std::tuple_size_v<decltype(sums.given)> == 5);
  for (std::size_t i = 0; i < sums.given.size(); ++i) {
    result.votes[2 * i] = sums.given[i].sum;
    result.votes[2 * i + 1] = sums.given[i].total;
  }
  result.scalars = {sums.volume, sums.area};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    result.vectors[i] = sums.moment[axis];
    result.vectors[3 + i] = sums.normals[axis];
    result.vectors[6 + i] = sums.projected[axis];
  }
  Eigen::Map<Eigen::Matrix3d>(result.tensor.data()) = sums.tensor;
  result.box = storedBox(sums.box);
  result.triangles = sums.triangles;
  result.open_edges = sums.open_edges;
  return result;
}

pcl::ccaa::SideSums
restored(const StoredSums& from)
{
  pcl::ccaa::SideSums sums;
  for (std::size_t i = 0; i < sums.given.size(); ++i) {
    sums.given[i].sum = from.votes[2 * i];
    sums.given[i].total = from.votes[2 * i + 1];
  }
  sums.volume = from.scalars[0];
  sums.area = from.scalars[1];
  sums.moment = Eigen::Vector3d(from.vectors.data());
  sums.normals = Eigen::Vector3d(from.vectors.data() + 3);
  sums.projected = Eigen::Vector3d(from.vectors.data() + 6);
  sums.tensor = Eigen::Map<const Eigen::Matrix3d>(from.tensor.data());
  sums.box = boxOf(from.box);
  sums.triangles = from.triangles;
  sums.open_edges = from.open_edges;
  return sums;
}

} // namespace

std::uint32_t
numberIn(const pcl::ccaa::Tile& own,
         const std::vector<WideIndex>& foreign,
         WideIndex point)
{
  if (own.owns(point))
    return static_cast<std::uint32_t>(point - own.first);
  const auto place = std::lower_bound(foreign.begin(), foreign.end(), point);
  return static_cast<std::uint32_t>(own.count) +
         static_cast<std::uint32_t>(place - foreign.begin());
}

void
writeMesh(const TilePlan& plan, std::size_t tile, TileMesh mesh)
{
  const pcl::ccaa::Tile& own = plan.tiling.tiles[tile];
  const std::vector<OwnerEnd> ends = sortByOwner(plan.tiling, mesh.border.triangles);
  std::vector<StoredPoint> points;
  for (const pcl::ccaa::BorderPoint& point : mesh.border.points)
    points.push_back({point.index,
                      {point.position.x(), point.position.y(), point.position.z()},
                      point.halo});
  const auto place_of = [&points](WideIndex first) {
    const auto found = std::lower_bound(
        points.begin(), points.end(), first, [](const StoredPoint& point, WideIndex i) {
          return point.index < i;
        });
    return static_cast<std::uint64_t>(found - points.begin());
  };
  StepWriter file(plan.file(tile, MESH_STEP), plan.key);
  file.put(MeshHead{mesh.doubts, place_of(own.first), place_of(own.first + own.count)});
  file.putAll(points);
  file.putAll(ends);
  file.putAll(mesh.border.triangles);
  file.putAll(mesh.inner);
  file.commit();
}

pcl::ccaa::BorderPoints
readBorderPoints(const TilePlan& plan, std::size_t tile)
{
  StepReader file(plan.file(tile, MESH_STEP), plan.key);
  file.get<MeshHead>();
  return restored(file.getAll<StoredPoint>());
}

pcl::ccaa::BorderPoints
readOwnBorderPoints(const TilePlan& plan, std::size_t tile)
{
  StepReader file(plan.file(tile, MESH_STEP), plan.key);
  const auto head = file.get<MeshHead>();
  return restored(file.getPart<StoredPoint>(head.own_begin, head.own_end));
}

std::vector<WideTriangle>
readBorderTriangles(const TilePlan& plan, std::size_t tile, std::size_t owner)
{
  StepReader file(plan.file(tile, MESH_STEP), plan.key);
  std::size_t count = 0;
  file.get<MeshHead>();
  file.skipAll<StoredPoint>(count);
  std::uint64_t begin = 0;
  for (const OwnerEnd& group : file.getAll<OwnerEnd>()) {
    if (group.tile == owner)
      return file.getPart<WideTriangle>(begin, group.end);
    begin = group.end;
  }
  return {};
}

TileMesh
readInner(const TilePlan& plan, std::size_t tile)
{
  StepReader file(plan.file(tile, MESH_STEP), plan.key);
  std::size_t count = 0;
  TileMesh mesh;
  mesh.doubts = file.get<MeshHead>().doubts;
  file.skipAll<StoredPoint>(count);
  file.skipAll<OwnerEnd>(count);
  file.skipAll<WideTriangle>(count);
  mesh.inner = file.getAll<CoreTriangle>();
  return mesh;
}

void
writeJoined(const TilePlan& plan, std::size_t tile, const JoinedTile& joined)
{
  StepWriter file(plan.file(tile, JOIN_STEP), plan.key);
  file.putAll(joined.triangles);
  file.putAll(joined.disputes);
  file.commit();
}

JoinedTile
readJoined(const TilePlan& plan, std::size_t tile)
{
  StepReader file(plan.file(tile, JOIN_STEP), plan.key);
  JoinedTile joined;
  joined.triangles = file.getAll<WideTriangle>();
  joined.disputes = file.getAll<PlacedDispute>();
  return joined;
}

void
writeDisputes(const TilePlan& plan, const AllDisputes& disputes)
{
  StepWriter file(plan.file(DISPUTES_FILE), plan.key);
  file.putAll(disputes.groups);
  file.putAll(disputes.disputes);
  file.commit();
}

AllDisputes
readDisputes(const TilePlan& plan)
{
  StepReader file(plan.file(DISPUTES_FILE), plan.key);
  AllDisputes disputes;
  disputes.groups = file.getAll<DisputeGroup>();
  disputes.disputes = file.getAll<PlacedDispute>();
  return disputes;
}

void
writeClosed(const TilePlan& plan, std::size_t tile, const ClosedTile& closed)
{
  StepWriter file(plan.file(tile, CLOSE_STEP), plan.key);
  file.putAll(closed.removed);
  file.putAll(closed.added);
  file.put(closed.failed);
  file.commit();
}

ClosedTile
readClosed(const TilePlan& plan, std::size_t tile)
{
  StepReader file(plan.file(tile, CLOSE_STEP), plan.key);
  ClosedTile closed;
  closed.removed = file.getAll<WideTriangle>();
  closed.added = file.getAll<WideTriangle>();
  closed.failed = file.get<std::uint64_t>();
  return closed;
}

void
writePieces(const TilePlan& plan,
            std::size_t tile,
            const TileSurface& surface,
            const pcl::ccaa::TilePieces& pieces)
{
  std::vector<StoredSums> sums;
  for (const pcl::ccaa::SideSums& piece : pieces.sums)
    sums.push_back(stored(piece));
  StepWriter file(plan.file(tile, PIECES_STEP), plan.key);
  file.put(pieces.doubts);
  file.putAll(sums);
  file.putAll(pieces.edges);
  file.putAll(surface.foreign);
  file.putAll(surface.triangles);
  file.putAll(surface.piece_ends);
  file.commit();
}

TileSurface
readPiecesSurface(const TilePlan& plan, std::size_t tile)
{
  StepReader file(plan.file(tile, PIECES_STEP), plan.key);
  std::size_t count = 0;
  file.get<pcl::ccaa::TileDoubts>();
  file.skipAll<StoredSums>(count);
  file.skipAll<pcl::ccaa::CutEdge>(count);
  TileSurface surface;
  surface.foreign = file.getAll<WideIndex>();
  surface.triangles = file.getAll<CoreTriangle>();
  surface.piece_ends = file.getAll<std::uint64_t>();
  return surface;
}

pcl::ccaa::TilePieces
readPiecesSums(const TilePlan& plan, std::size_t tile)
{
  StepReader file(plan.file(tile, PIECES_STEP), plan.key);
  pcl::ccaa::TilePieces pieces;
  pieces.doubts = file.get<pcl::ccaa::TileDoubts>();
  for (const StoredSums& sums : file.getAll<StoredSums>())
    pieces.sums.push_back(restored(sums));
  pieces.edges = file.getAll<pcl::ccaa::CutEdge>();
  return pieces;
}

void
writeSides(const TilePlan& plan, const pcl::ccaa::Sides& sides)
{
  StepWriter file(plan.file(SIDES_FILE), plan.key);
  file.put(sides.tally);
  file.put(sides.components);
  file.put(sides.open_edges);
  file.put(sides.doubts);
  file.putAll(sides.torn);
  file.putAll(sides.gone);
  for (std::size_t tile = 0; tile < sides.turn.size(); ++tile) {
    file.putAll(sides.turn[tile]);
    file.putAll(sides.components_of[tile]);
  }
  file.commit();
}

pcl::ccaa::Sides
readSides(const TilePlan& plan)
{
  StepReader file(plan.file(SIDES_FILE), plan.key);
  pcl::ccaa::Sides sides;
  sides.tally = file.get<pcl::ccaa::SideTally>();
  sides.components = file.get<std::uint64_t>();
  sides.open_edges = file.get<std::uint64_t>();
  sides.doubts = file.get<pcl::ccaa::TileDoubts>();
  sides.torn = file.getAll<std::array<WideIndex, 2>>();
  sides.gone = file.getAll<WideTriangle>();
  for (std::size_t i = 0; i < plan.tiling.tiles.size(); ++i) {
    sides.turn.push_back(file.getAll<std::uint8_t>());
    sides.components_of.push_back(file.getAll<std::uint64_t>());
  }
  return sides;
}

} // namespace app
