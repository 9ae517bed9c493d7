// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what all steps of a run tile by tile know.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "cli/reconstruct_run.h"
#include "tiles/tiling.h"

#include <cstdint>
#include <string>
#include <vector>

namespace app {

/** \brief Names of files for all tiles: the plan, and the points without a position. */
constexpr const char* PLAN_FILE = "plan.json";
constexpr const char* NOWHERE_FILE = "nowhere.points";

/** \brief One input file. */
struct TileInput {
  std::string path;
  std::uint64_t bytes = 0;
  std::uint64_t points = 0;
  std::string hash;         /**< of its points */
  std::int64_t changed = 0; /**< when it was written last, as the system counts */
  std::uint64_t first = 0;  /**< place of its first point in the order of the input */
};

/** \brief Where a point comes from: the number of its file, and its place there. */
struct PointSource {
  std::uint32_t file = 0;
  std::uint32_t point = 0;

  bool
  operator<(const PointSource& other) const
  {
    return file != other.file ? file < other.file : point < other.point;
  }
};

/** \brief The tiles of a cloud, made once, and all that the steps must agree about. */
struct TilePlan {
  std::string folder;
  std::string key;               /**< hash of inputs, parameters and version */
  std::string settings;          /**< the parameters as text */
  std::uint64_t most_points = 0; /**< in a tile */
  std::vector<TileInput> inputs;
  pcl::PCLPointCloud2 layout; /**< no points; fields as the records have them */
  Viewpoint viewpoint;        /**< of all points, where they have one in common */
  Warnings warnings;
  double step = 0.0; /**< lattice that doubles are rounded to; 0: floats */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero(); /**< that sums have in common */
  std::uint64_t nowhere = 0; /**< points without a finite position, in no tile */
  pcl::ccaa::Tiling tiling;
  std::vector<Eigen::Vector3d> corners; /**< by tile: multiples of the step */

  /** \brief All points, also those that are nowhere. */
  std::uint64_t
  points() const;

  /** \brief Those that are in tiles: new ones are numbered from here. */
  std::uint64_t
  pointsInTiles() const
  {
    return points() - nowhere;
  }

  /** \brief Whether what is open is repaired. */
  bool
  repairs() const;

  /** \brief Name of the file that a step makes for a tile. */
  std::string
  file(std::size_t tile, const char* step_name) const;

  /** \brief Name of one that a step makes for all. */
  std::string
  file(const char* name) const;
};

/** \brief Put the points of the inputs one behind the other, in the order that some
 * have, which are the same. */
void
placeInputs(TilePlan& plan, const std::vector<TileInput>& order);

/** \brief Write the plan into its folder, which gives the run its key. */
void
writePlan(const TilePlan& plan);

/** \brief Read the plan of a folder. Throws a Failure where there is none, or one of
 * another version of the program. */
TilePlan
readPlan(const std::string& folder);

/** \brief Parameters of the reconstruction that change its result, as text, and back.
 */
std::string
settingsText(const ReconstructSettings& settings);
ReconstructSettings
settingsOf(const TilePlan& plan);

/** \brief A hash of bytes: the next of a chain that begins with an empty text. */
std::string
hashOf(const std::string& before, const void* bytes, std::size_t count);

} // namespace app
