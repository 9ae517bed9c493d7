// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the boundary loops of a surface that runs through many
// tiles.
#pragma once

#include "mesh/box_tree.h"
#include "tiles/side_graph.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl::ccaa {

/** \brief An edge of the whole surface that has one triangle. */
struct OpenEdge {
  std::array<WideIndex, 2> ends{}; /**< ascending */
  std::uint64_t component = 0;     /**< see Sides::components_of */
};

/** \brief What becomes of a loop. */
enum class LoopUse : std::uint8_t {
  REPAIR, /**< it is looked at with its cluster */
  BORDER, /**< it is too large for that, and the outer border of a sheet */
  BEYOND  /**< it is too large, and nothing tells what it is */
};

/** \brief Open edges that are connected: a boundary loop, or several at one point. */
struct OpenLoop {
  Box box;                  /**< of its points */
  double edge = 0.0;        /**< spacing of the points around it: the mean length of its
                                 edges, at most that of its tile */
  std::uint64_t begin = 0;  /**< its edges: from here */
  std::uint64_t end = 0;    /**< to before here */
  std::uint64_t points = 0; /**< in its region */
  std::uint64_t cluster = 0; /**< of LoopUse::REPAIR: by its lowest point */
  LoopUse use = LoopUse::REPAIR;

  /** \brief What a repair has to know around it: also that to which it may be joined.
   */
  Box
  region() const;
};

/** \brief The edges that one tile alone has, ascending. Edges at which the surface is
 * torn are none. */
std::vector<OpenEdge>
openEdges(const std::vector<TilePieces>& tiles, const Sides& sides);

/** \brief The loops of some edges by their lowest points, and, of loops that are to be
 * repaired together, clusters.
 *
 * Loops whose regions meet belong together, the near ones first, as far as the cluster
 * holds no more points than a tile may. A loop that is larger than that by itself is
 * none to be repaired. Cost: n log n, and linear in the pairs of loops whose regions
 * meet.
 * \param[in,out] edges sorted by loop
 * \param[in] positions of the points in \a points
 * \param[in] points of the edges, ascending, each once
 * \param[in] components box and sums of each, relative to the same origin
 * \param[in] points_in how many points a box holds
 * \param[in] most_points of a tile */
std::vector<OpenLoop>
clusterLoops(std::vector<OpenEdge>& edges,
             const std::vector<WideIndex>& points,
             const std::vector<Position>& positions,
             const std::vector<SideSums>& components,
             const Tiling& tiling,
             const std::function<std::uint64_t(const Box&)>& points_in,
             std::uint64_t most_points);

} // namespace pcl::ccaa
