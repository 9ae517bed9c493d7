// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the steps of a repair tile by tile write.
#pragma once

#include <pcl/surface_repair/repair_report.h>

#include "out_of_core/tile_plan.h"
#include "tiles/open_loops.h"

#include <array>
#include <cstdint>
#include <vector>

namespace app {

/** \brief Ending of the file of a tile, and names of those for all. */
constexpr const char* REPAIR_STEP = "repaired";
constexpr const char* HOLES_FILE = "holes";
constexpr const char* NUMBERS_FILE = "numbers";

/** \brief A boundary loop that is to be repaired. */
struct HoleLoop {
  std::uint64_t cluster = 0; /**< of loops that are repaired together */
  std::uint64_t tile =
      0; /**< that repairs it: the owner of the cluster's first point */
  std::uint64_t begin = 0; /**< its edges */
  std::uint64_t end = 0;
  pcl::ccaa::Box core;   /**< where what closes it lies */
  pcl::ccaa::Box region; /**< what a repair has to know around it */
};

/** \brief The boundary loops of the whole surface. */
struct AllHoles {
  std::vector<HoleLoop> loops; /**< cluster by cluster */
  std::vector<std::array<pcl::ccaa::WideIndex, 2>> edges;
  std::uint64_t borders = 0; /**< loops that are too large, and outer borders */
  std::uint64_t beyond = 0;  /**< loops that are too large, and might be holes */
};

void
writeHoles(const TilePlan& plan, const AllHoles& holes);
AllHoles
readHoles(const TilePlan& plan);

/** \brief What became of the holes of some clusters. */
struct TileRepairFacts {
  std::uint64_t closed = 0;
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;
  std::int64_t open_edges = 0; /**< more than before */
  double area = 0.0;           /**< of the new triangles */
  std::array<std::uint64_t, std::size_t(pcl::OpenReason::NOT_WANTED) + 1> shortfalls{};
  std::array<std::uint64_t, std::size_t(pcl::DoubtReason::UNSUPPORTED) + 1> doubts{};
  std::uint64_t against = 0; /**< islands that would have to be turned to be joined */
  std::uint64_t astray =
      0; /**< islands whose new triangles came near those of others */
  std::uint64_t crowded =
      0; /**< loops with more points around them than a tile holds */

  void
  add(const TileRepairFacts& other);

  /** \brief Whether something that should be closed is open, or is in doubt. */
  bool
  isIncomplete() const;
};

/** \brief What a tile adds. New vertices are numbered behind all points of the plan;
 * in its own file from the end of these, else over all tiles. */
struct RepairedTile {
  std::vector<char> records; /**< of the new vertices */
  std::vector<pcl::ccaa::WideTriangle> triangles;
  std::vector<std::array<std::uint64_t, 2>> joined; /**< components, that are one now */
  TileRepairFacts facts;
};

void
writeRepaired(const TilePlan& plan, std::size_t tile, const RepairedTile& repaired);
RepairedTile
readRepaired(const TilePlan& plan, std::size_t tile);

/** \brief The repairs of all tiles in numbers. */
struct RepairNumbers {
  std::vector<std::uint64_t> first; /**< new vertex of each tile, and behind the last */
  std::uint64_t components = 0;     /**< of the surface after it */
  TileRepairFacts facts;
};

void
writeNumbers(const TilePlan& plan, const RepairNumbers& numbers);
RepairNumbers
readNumbers(const TilePlan& plan);

} // namespace app
