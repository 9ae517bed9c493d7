// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the outer side of surfaces that run through many tiles.
#pragma once

#include <pcl/surface_ccaa/reconstruction_report.h>
#include <pcl/surface_ccaa/side_settings.h>

#include <Eigen/Core>

#include "mesh/box_tree.h"
#include "mesh/given_votes.h"
#include "tiles/tiling.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief What one piece of a surface, all of whose triangles are wound alike, says
 * about its outer side: sums, so that those of connected pieces add up. Signs are those
 * of the windings. Positions are relative to an origin that all tiles have in common.
 */
struct SideSums {
  GivenSides given;
  double volume = 0.0; /**< sum of 6 times the tetrahedra from the origin */
  double area = 0.0;   /**< twice the area */
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();    /**< centroids times area */
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();   /**< area vectors */
  Eigen::Vector3d projected = Eigen::Vector3d::Zero(); /**< of both signs */
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();    /**< n n^T area */
  Box box;                                             /**< of the centroids */
  std::uint64_t triangles = 0;
  std::int64_t open_edges = 0;

  /** \brief Add those of another piece. \param[in] sign -1: wound the other way */
  void
  add(const SideSums& other, double sign);

  void
  add(const SideSums& other)
  {
    add(other, 1.0);
  }
};

/** \brief An edge of a piece that has one triangle in its tile. */
struct CutEdge {
  std::array<WideIndex, 2> ends{}; /**< ascending */
  std::uint32_t piece = 0;
  std::uint32_t falls = 0; /**< 1: the triangle runs from the higher end to the lower */
};

/** \brief How often something was found, and where it was first. */
struct PlacedCount {
  std::uint64_t count = 0;
  bool has_place = false;
  std::array<double, 3> place{};

  /** \param[in] point of these, or UNAVAILABLE */
  static PlacedCount
  at(std::uint64_t count, const PointView& points, pcl::index_t point)
  {
    PlacedCount placed{count, point >= 0};
    if (placed.has_place)
      Position::Map(placed.place.data()) = points[static_cast<std::size_t>(point)];
    return placed;
  }

  void
  add(const PlacedCount& other)
  {
    count += other.count;
    if (has_place)
      return;
    has_place = other.has_place;
    place = other.place;
  }
};

/** \brief What leaves the results of some tiles in doubt, each with its halo: two tiles
 * may know the same place. */
struct TileDoubts {
  PlacedCount handles, touching_pieces, thin_necks; /**< TopologyDoubts */
  std::uint64_t places = 0;                         /**< of points */
  std::uint64_t used = 0;                           /**< of these with a triangle */

  void
  add(const TileDoubts& other)
  {
    handles.add(other.handles);
    touching_pieces.add(other.touching_pieces);
    thin_necks.add(other.thin_necks);
    places += other.places;
    used += other.used;
  }
};

/** \brief The pieces of a tile. */
struct TilePieces {
  std::vector<SideSums> sums;
  std::vector<CutEdge> edges; /**< that other tiles may have, too; twice those at which
                                   the piece itself is one-sided */
  TileDoubts doubts;
};

/** \brief Wind the triangles of each piece of a tile like its first one, and sum up
 * what they say. Pieces are numbered by their first triangles.
 * \param[in,out] triangles of the tile, of its own numbers
 * \param[in] wide what these numbers are in the whole, ascending
 * \param[in] positions by the tile's numbers \param[in] origin of the sums
 * \param[in] hints about the outer side, in the frame of the positions
 * \param[out] piece_of number of the piece of each triangle */
TilePieces
sumUpSides(Triangles& triangles,
           const std::vector<WideIndex>& wide,
           const PointView& positions,
           const Position& origin,
           const OrientationHints& hints,
           RunControl& control,
           std::vector<std::uint32_t>& piece_of);

/** \brief What was decided for all tiles. */
struct Sides {
  std::vector<std::vector<std::uint8_t>> turn; /**< by tile and piece: 1 to turn it */
  std::vector<std::vector<std::uint64_t>>
      components_of;                          /**< by tile and piece: the
                                                 surface, by its first piece */
  std::vector<std::array<WideIndex, 2>> torn; /**< edges over which windings cannot
                                                   agree */
  std::vector<WideTriangle> gone;             /**< that have to go for it (Tearing) */
  SideTally tally;                            /**< triangles by rule */
  std::uint64_t components = 0;
  std::uint64_t open_edges = 0;
  TileDoubts doubts;
};

/** \brief Join the pieces over the edges that two of them have, and ask for each
 * surface the rules of orientTriangles() that can be summed over tiles, in its order:
 * given votes, volume where it is closed, the plane most of all follows, and whether it
 * bulges. \param[in] guess_plane see SideHints */
Sides
decideSides(const std::vector<TilePieces>& tiles, bool guess_plane);

/** \brief What each surface says, in numbers of Sides::components_of. */
std::vector<SideSums>
sumUpComponents(const std::vector<TilePieces>& tiles, const Sides& sides);

} // namespace pcl::ccaa
