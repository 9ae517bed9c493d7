// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closed surfaces that lose a share of their triangles.
#pragma once

#include "support/repair_shapes.h"

#include <cstdint>
#include <string>

namespace bench {

enum class LossKind : std::uint8_t {
  PATCHES, /**< around four vertices, with torn rims */
  BALLS,   /**< five to eight, of several sizes */
  SLABS3,  /**< around three planes */
  SLABS6
};

const char*
nameOf(LossKind kind);

/** \brief A surface without some of its vertices. */
struct LostPart {
  pcl::ccaa::test::Shape left;        /**< without free vertices */
  pcl::ccaa::test::Shape lost;        /**< the triangles that went */
  pcl::ccaa::Positions lost_vertices; /**< that no triangle has any more */
  double edge = 0;                    /**< median, of the whole */
};

/** \brief What is left of a surface without some vertices and all triangles at them. */
LostPart
without(const pcl::ccaa::test::Shape& whole, const std::vector<bool>& is_lost);

/** \brief The same for damage that takes a share of the triangles, 0 to 1. */
LostPart
lose(const pcl::ccaa::test::Shape& whole,
     LossKind kind,
     double share,
     std::uint64_t seed);

/** \brief Whether what was lost hangs together around a whole handle: then nothing can
 * tell that it was there. */
bool
hasLostHandle(const LostPart& part);

/** \brief A twentieth of the lost vertices. \param[in] noise of a coordinate, units of
 * the shape */
pcl::ccaa::Positions
freePoints(const LostPart& part, double noise, std::uint64_t seed);

} // namespace bench
