// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the points of many files in portions.
#pragma once

#include "out_of_core/tile_plan.h"

#include <functional>
#include <string>
#include <vector>

namespace app {

/** \brief What is known of a stream before its points are. */
struct StreamHead {
  std::vector<TileInput> inputs;     /**< without hashes and numbers of points */
  std::vector<Viewpoint> viewpoints; /**< by input */
  pcl::PCLPointCloud2 layout;        /**< fields of all portions */
  Viewpoint viewpoint;               /**< that all have in common */
  Warnings warnings;
};

/** \brief Look at the heads of files; fails where one cannot be read, or is there
 * twice. */
StreamHead
readHeads(const std::vector<std::string>& paths);

/** \brief Takes one portion of points in the layout of the head, the first of which has
 * this source. \return false to stop */
using TakePortion =
    std::function<bool(const pcl::PCLPointCloud2& portion, PointSource first)>;

/** \brief Read all points once, file by file. PLY, and PCD that is not compressed, take
 * the memory of one portion; of other formats one file is in memory at a time.
 * \param[in,out] head gets the hash and number of points of each file; what files have
 * in common or not was told by readHeads()
 * \return false when it was stopped */
bool
streamPoints(StreamHead& head, const TakePortion& take);

} // namespace app
