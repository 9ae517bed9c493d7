// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the tiles of a cloud and what each of them sees.
#pragma once

#include <Eigen/Geometry>

#include "tiles/world_grid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief A point of the whole cloud: tile by tile, within a tile in its fixed order.
 */
using WideIndex = std::uint64_t;

/** \brief A triangle of these, wound as it came. */
using WideTriangle = std::array<WideIndex, 3>;

/** \brief The corners of a triangle in ascending order: the same for any winding. */
WideTriangle
cornersInOrder(const WideTriangle& triangle);

/** \brief Of a triangle with three corners. */
double
longestEdge(const std::vector<Position>& corners);

/** \brief One tile: the points of a cell, and how far around it what is computed of a
 * part of the cloud counts. */
struct Tile {
  GridCell cell;
  WideIndex first = 0;     /**< its first point */
  std::uint64_t count = 0; /**< of its points */
  double halo = 0.0;       /**< units around the cell in which it knows all points */

  /** \brief Spacings of its points that make the halo. With 6, one triangle in 500 near
   * a cut was made differently by two tiles, with 16 one in 1000, noise of 0.3 spacings
   * ten times as many; at 32 it was no better: what is left depends on things farther
   * away. */
  static constexpr double SPACINGS = 20.0;
  /** \brief Share of the halo in which the tile's triangles count: farther out they
   * may follow from the end of what it knows. */
  static constexpr double TRUSTED = 0.4;
  /** \brief Share of the halo that is known around what a seam may touch: border points
   * and triangles are kept that far beyond what another tile sees. */
  static constexpr double AROUND = 0.4;
  /** \brief Longest edge of a triangle near a cut, as a share of the halo. */
  static constexpr double LONGEST = 0.2;

  double
  spacing() const
  {
    return halo / SPACINGS;
  }

  bool
  owns(WideIndex point) const
  {
    return point >= first && point < first + count;
  }

  bool
  sees(const Position& position) const
  {
    return cell.distance(position) <= TRUSTED * halo;
  }
};

/** \brief All tiles of a cloud, by ascending cell and first point. */
struct Tiling {
  std::vector<Tile> tiles;

  /** \brief The tile whose point it is. */
  std::size_t
  ownerOf(WideIndex point) const;

  /** \brief The tiles other than this one of which points or triangles may matter to
   * it, ascending. */
  std::vector<std::size_t>
  neighborsOf(std::size_t tile) const;
};

/** \brief The cells around a tile, and which of them a position is near. Cost: for a
 * position deep within the tile's own cell O(1), else O(cells). */
class CellsAround {
public:
  /** \brief Those near which a position belongs to the border of a tile: of the wider
   * halo, where they differ, as a dispute reaches as far as the halo of its own tile
   * tells. */
  static CellsAround
  border(const Tiling& tiling, std::size_t tile);

  /** \brief Those of the neighbors of a tile, in their order, which see a position
   * (Tile::sees()). */
  static CellsAround
  sight(const Tiling& tiling, std::size_t tile);

  /** \brief Calls \a use(cell) for all near a position, ascending. */
  template <typename Use>
  void
  forEachNear(const Position& position, const Use& use) const
  {
    if ((position - clear_.min()).minCoeff() > 0.0 &&
        (clear_.max() - position).minCoeff() > 0.0)
      return;
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if ((boxes_[i].min() - position).maxCoeff() <= limits_[i] &&
          (position - boxes_[i].max()).maxCoeff() <= limits_[i])
        use(i);
  }

  /** \brief Whether it is near any. */
  bool
  isNear(const Position& position) const
  {
    bool is_near = false;
    forEachNear(position, [&](std::size_t) { is_near = true; });
    return is_near;
  }

private:
  template <typename Limit>
  CellsAround(const Tiling& tiling, std::size_t tile, const Limit& limit);

  Eigen::AlignedBox3d clear_; /**< of the tile's cell: far from all others */
  std::vector<Eigen::AlignedBox3d> boxes_;
  std::vector<double> limits_;
};

/** \brief A point at which tiles meet. */
struct BorderPoint {
  WideIndex index = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/** \brief The border points of a tile, ascending. */
using BorderPoints = std::vector<BorderPoint>;

/** \brief Where a point is among them; the end where it is not. */
BorderPoints::const_iterator
findPoint(const BorderPoints& points, WideIndex index);

} // namespace pcl::ccaa
