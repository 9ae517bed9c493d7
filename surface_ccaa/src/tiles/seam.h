// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closes what is open where tiles disagreed.
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/run_settings.h>

#include "mesh/triangle.h"
#include "tiles/tiling.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::ccaa {

/** \brief What surrounds some disputes. */
struct Seam {
  std::vector<Eigen::Vector3f> points; /**< one per place */
  Triangles given;                     /**< of these, no edge with more than two */
  std::vector<std::size_t> tile_of;    /**< by given triangle: those that one tile has
                                            are wound as it made them; empty: any way */
  std::vector<std::uint8_t> is_open;   /**< flags of the points that may get triangles:
                                            the disputes and free points near them */
  std::vector<std::uint8_t> is_near;   /**< flags of those within one and a half reaches
                                            of a dispute: others keep their triangles */
  std::vector<std::uint8_t> is_whole;  /**< flags of those all triangles of which are
                                            given: at others some are missing */
  std::vector<float> room; /**< how far from each of them a new triangle may reach */
};

/** \brief Whether a corner of a triangle is flagged. */
inline bool
anyCorner(const Triangle& triangle, const std::vector<std::uint8_t>& flags)
{
  return std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
    return flags[static_cast<std::size_t>(corner)] != 0;
  });
}

/** \brief Whether all corners of a triangle are. */
inline bool
allCorners(const Triangle& triangle, const std::vector<std::uint8_t>& flags)
{
  return std::all_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
    return flags[static_cast<std::size_t>(corner)] != 0;
  });
}

/** \brief What closes it. */
struct SeamFilling {
  Triangles added;                   /**< wound in any way */
  std::vector<pcl::index_t> removed; /**< given triangles that have to go, ascending */
  std::string error;                 /**< why nothing was added */
};

/** \brief Complete the surface around disputes by the base algorithm: triangles that
 * cut fans leave in several pieces at a dispute go (all but the largest piece), the
 * other given ones stay frozen, and all points that are not open count as cut points.
 * Pieces of the given triangles are wound as their tiles have made them.
 * Where that leaves open points free or on a boundary, the triangles around these are
 * made anew, too, twice at most, and that stays if fewer such points are left. If still
 * some are left, all is tried again with pieces turned that lie against each other
 * across a gap (turnToFace()). New triangles that leave the room of all their corners
 * are left out.
 * \param[in] threads at least 1 */
SeamFilling
closeSeam(const Seam& seam,
          const CompletionParameters& parameters,
          int threads,
          const ProgressCallback& progress);

} // namespace pcl::ccaa
