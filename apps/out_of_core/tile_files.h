// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the steps of a run tile by tile write.
#pragma once

#include "out_of_core/tile_plan.h"
#include "tiles/agreement.h"
#include "tiles/seam.h"
#include "tiles/side_graph.h"

#include <array>
#include <cstdint>
#include <vector>

namespace app {

/** \brief Endings of the files of a tile, by step. */
constexpr const char* MESH_STEP = "mesh";
constexpr const char* JOIN_STEP = "joined";
constexpr const char* CLOSE_STEP = "closed";
constexpr const char* PIECES_STEP = "pieces";
/** \brief Names of the files for all tiles. */
constexpr const char* DISPUTES_FILE = "disputes";
constexpr const char* SIDES_FILE = "sides";

/** \brief A triangle of numbers of a tile. */
using CoreTriangle = std::array<std::uint32_t, 3>;

/** \brief What the chain made of a tile. */
struct TileMesh {
  pcl::ccaa::BorderMesh border;
  std::vector<CoreTriangle> inner; /**< of numbers of the tile's points */
  pcl::ccaa::TileDoubts doubts;
};

void
writeMesh(const TilePlan& plan, std::size_t tile, TileMesh mesh);
pcl::ccaa::BorderPoints
readBorderPoints(const TilePlan& plan, std::size_t tile);
/** \brief Those that belong to the tile itself. */
pcl::ccaa::BorderPoints
readOwnBorderPoints(const TilePlan& plan, std::size_t tile);
/** \brief Triangles of the border that belong to some tile: it has the lowest corner.
 */
std::vector<pcl::ccaa::WideTriangle>
readBorderTriangles(const TilePlan& plan, std::size_t tile, std::size_t owner);
/** \brief The mesh without its border. */
TileMesh
readInner(const TilePlan& plan, std::size_t tile);

/** \brief A point at which tiles did not agree, and where it is. */
struct PlacedDispute {
  pcl::ccaa::WideIndex index = 0;
  std::array<double, 3> position{};
  double reach = 0.0; /**< what of the mesh around it may be made anew */
  double room = 0.0;  /**< within which what closes it has to lie */
};

/** \brief What tiles agree about, of the triangles that are the tile's. */
struct JoinedTile {
  std::vector<pcl::ccaa::WideTriangle> triangles;
  std::vector<PlacedDispute> disputes;
};

void
writeJoined(const TilePlan& plan, std::size_t tile, const JoinedTile& joined);
JoinedTile
readJoined(const TilePlan& plan, std::size_t tile);

/** \brief Disputes that are closed together. */
struct DisputeGroup {
  std::uint64_t tile = 0; /**< that closes it */
  std::uint64_t whole =
      0; /**< number of the first part of its group: the parts come one
              behind the other, and are closed one after the other */
  std::uint64_t begin = 0;
  std::uint64_t end = 0;
};

/** \brief The disputes of all tiles, each once, group by group. */
struct AllDisputes {
  std::vector<DisputeGroup> groups;
  std::vector<PlacedDispute> disputes;
};

void
writeDisputes(const TilePlan& plan, const AllDisputes& disputes);
AllDisputes
readDisputes(const TilePlan& plan);

/** \brief What closes the groups of a tile. */
struct ClosedTile {
  std::vector<pcl::ccaa::WideTriangle> removed; /**< corners in order */
  std::vector<pcl::ccaa::WideTriangle> added;
  std::uint64_t failed = 0; /**< groups to which nothing could be added */
};

void
writeClosed(const TilePlan& plan, std::size_t tile, const ClosedTile& closed);
ClosedTile
readClosed(const TilePlan& plan, std::size_t tile);

/** \brief What a point of the whole is called in a tile: one of its own by its place,
 * else one behind all of these by its place in a list, ascending, in which it is. */
std::uint32_t
numberIn(const pcl::ccaa::Tile& own,
         const std::vector<pcl::ccaa::WideIndex>& foreign,
         pcl::ccaa::WideIndex point);

/** \brief The final triangles of a tile. Corners below the number of its points are
 * these, the others come from a list, in its order. */
struct TileSurface {
  std::vector<pcl::ccaa::WideIndex> foreign; /**< ascending */
  std::vector<CoreTriangle> triangles;
  std::vector<std::uint64_t> piece_ends; /**< triangles up to the end of each piece */

  /** \brief The point of the whole that a corner is. \param[in] own the tile */
  pcl::ccaa::WideIndex
  wideOf(const pcl::ccaa::Tile& own, std::uint32_t corner) const
  {
    return corner < own.count ? own.first + corner : foreign[corner - own.count];
  }
  pcl::ccaa::WideTriangle
  wideOf(const pcl::ccaa::Tile& own, const CoreTriangle& triangle) const
  {
    return {
        wideOf(own, triangle[0]), wideOf(own, triangle[1]), wideOf(own, triangle[2])};
  }
};

void
writePieces(const TilePlan& plan,
            std::size_t tile,
            const TileSurface& surface,
            const pcl::ccaa::TilePieces& pieces);
TileSurface
readPiecesSurface(const TilePlan& plan, std::size_t tile);
pcl::ccaa::TilePieces
readPiecesSums(const TilePlan& plan, std::size_t tile);

void
writeSides(const TilePlan& plan, const pcl::ccaa::Sides& sides);
pcl::ccaa::Sides
readSides(const TilePlan& plan);

} // namespace app
