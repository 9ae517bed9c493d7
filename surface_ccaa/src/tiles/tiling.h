// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the tiles of a cloud and what each of them sees.
#pragma once

#include <Eigen/Geometry>

#include "mesh/box_tree.h"
#include "mesh/corners.h"
#include "mesh/triangle.h"

#include <algorithm>
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

double
longestEdge(const Corners& corners);

/** \brief One tile: some points, and how far around them what is computed of a part of
 * the cloud counts. */
struct Tile {
  Box box;                 /**< of its points; those of tiles do not overlap */
  WideIndex first = 0;     /**< its first point */
  std::uint64_t count = 0; /**< of its points */
  double halo = 0.0;       /**< units around the box in which it knows all points */
  Box sparse; /**< around its sparse points, each with its own halo; empty if none is */

  /** \brief Spacings of its points that make the halo. With 6, one triangle in 500 near
   * a cut was made differently by two tiles, with 16 one in 1000, noise of 0.3 spacings
   * ten times as many; at 32 it was no better: what is left depends on things farther
   * away. */
  static constexpr double SPACINGS = 20.0;
  /** \brief A point is sparse if its own spacing is at least so many times its tile's.
   * Where a halo is too narrow for its triangles it has one of its own: all tiles that
   * near know, see and tell of it. */
  static constexpr double SPARSE = 2.0;
  /** \brief Widest halo of a sparse point, as a share of the longest side of its tile:
   * so what is read to close a seam is a small part of the tiles around. */
  static constexpr double WIDEST = 0.5;
  /** \brief Share of the halo in which the tile's triangles count: farther out they
   * may follow from the end of what it knows. */
  static constexpr double TRUSTED = 0.4;
  /** \brief Share of the halo that is known around what a seam may touch: border points
   * and triangles are kept that far beyond what another tile sees. */
  static constexpr double AROUND = 0.4;
  /** \brief Longest edge of a triangle near a cut, as a share of the halo. */
  static constexpr double LONGEST = 0.2;
  /** \brief How far from it corners of such a triangle may be that reaches into what is
   * known: AROUND and the radius around an equilateral one. */
  static constexpr double TOLD = AROUND + 0.58 * LONGEST;

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

  /** \param[in] own_halo of the point, 0 unless it is sparse */
  bool
  knows(const Position& position, double own_halo) const
  {
    return distance(position) <= std::max(halo, own_halo);
  }

  bool
  sees(const Position& position, double own_halo) const
  {
    return distance(position) <= TRUSTED * std::max(halo, own_halo);
  }

  /** \brief Where points and triangles of it may be that others know. */
  Box
  surroundings() const
  {
    return widened(box, halo).extend(sparse);
  }

  /** \brief Distance of a position from the box along the farthest axis; 0 within. */
  double
  distance(const Position& position) const
  {
    return std::max(
        {0.0, (box.min() - position).maxCoeff(), (position - box.max()).maxCoeff()});
  }

  /** \brief The same between boxes; 0 where they touch. */
  double
  distance(const Tile& other) const
  {
    return std::max({0.0,
                     (box.min() - other.box.max()).maxCoeff(),
                     (other.box.min() - box.max()).maxCoeff()});
  }
};

/** \brief All tiles of a cloud, by ascending first point. */
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

/** \brief The tiles around a tile, and which of them a position is near. Cost: for a
 * position deep within the tile's own box O(1), else O(tiles around). */
class TilesAround {
public:
  /** \brief Those near which a position belongs to the border of a tile: of the wider
   * halo, where they differ, as a dispute reaches as far as the halo of its own tile
   * tells. */
  static TilesAround
  border(const Tiling& tiling, std::size_t tile);

  /** \brief Those of the neighbors of a tile, in their order, which see a position
   * (Tile::sees()). */
  static TilesAround
  sight(const Tiling& tiling, std::size_t tile);

  /** \brief Calls \a use(i) for all near a position, ascending. \param[in] own_halo
   * of the point there, 0 unless it is sparse: such a one is near all that see it */
  template <typename Use>
  void
  forEachNear(const Position& position, double own_halo, const Use& use) const
  {
    if (own_halo == 0.0 && (position - clear_.min()).minCoeff() > 0.0 &&
        (clear_.max() - position).minCoeff() > 0.0)
      return;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const double limit = std::max(limits_[i], Tile::TRUSTED * own_halo);
      if ((boxes_[i].min() - position).maxCoeff() <= limit &&
          (position - boxes_[i].max()).maxCoeff() <= limit)
        use(i);
    }
  }

  /** \brief Whether it is near any. */
  bool
  isNear(const Position& position, double own_halo) const
  {
    bool is_near = false;
    forEachNear(position, own_halo, [&](std::size_t) { is_near = true; });
    return is_near;
  }

private:
  template <typename Limit>
  TilesAround(const Tiling& tiling, std::size_t tile, const Limit& limit);

  void
  clearOf(const Box& other, double depth, const Box& own);

  Box clear_; /**< far from all others */
  std::vector<Box> boxes_;
  std::vector<double> limits_;
};

/** \brief A point at which tiles meet. */
struct BorderPoint {
  WideIndex index = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double halo = 0.0; /**< its own, 0 unless it is sparse */
};

/** \brief The border points of a tile, ascending. */
using BorderPoints = std::vector<BorderPoint>;

/** \brief Where a point is among them; the end where it is not. */
BorderPoints::const_iterator
findPoint(const BorderPoints& points, WideIndex index);

} // namespace pcl::ccaa
