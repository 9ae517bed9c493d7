// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the steps of a repair tile by tile write.
#pragma once

#include <pcl/surface_repair/repair_report.h>

#include "out_of_core/tile_plan.h"
#include "tiles/open_loops.h"
#include "tiles/side_graph.h"

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
  pcl::ccaa::Box region;    /**< what a repair has to know around it */
  std::uint64_t points = 0; /**< in its region */
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
  /** By reason: loops that should be closed, and those that stay as they are. */
  std::array<std::uint64_t, std::size_t(pcl::OpenReason::NOT_WANTED) + 1> shortfalls{},
      kept{};
  std::array<pcl::ccaa::PlacedCount, std::size_t(pcl::DoubtReason::UNSUPPORTED) + 1>
      doubts{};
  std::uint64_t against = 0; /**< patches between islands that are wound against each
                                  other */
  std::uint64_t astray = 0;  /**< patches that left what is known around their loops */
  std::uint64_t dropped = 0; /**< patches that met those of other clusters */

  void
  add(const TileRepairFacts& other);
  void
  addDoubts(const std::vector<pcl::RepairDoubt>& more,
            const pcl::ccaa::PointView& points);
};

/** \brief New triangles that are connected over edges. */
struct RepairedPatch {
  std::uint64_t cluster = 0;
  std::uint64_t triangles = 0;
  std::uint64_t vertices = 0;  /**< new ones */
  std::int64_t open_edges = 0; /**< more than without it */
  double area = 0.0;

  void
  add(const RepairedPatch& other);
};

/** \brief A triangle that those of another cluster may meet. */
struct ExposedTriangle {
  std::uint64_t patch = 0; /**< of the tile */
  pcl::ccaa::WideTriangle corners;
  std::array<double, 9> positions{};
};

/** \brief What a tile adds. New vertices are numbered behind all points of the plan;
 * in its own file from the end of these, else over all tiles. */
struct RepairedTile {
  std::vector<char> records; /**< of the new vertices, patch by patch */
  std::vector<pcl::ccaa::WideTriangle> triangles; /**< likewise */
  std::vector<RepairedPatch> patches;
  std::vector<std::array<std::uint64_t, 3>> joined; /**< patch, and two components that
                                                         it makes one */
  std::vector<ExposedTriangle> exposed;
  TileRepairFacts facts;

  std::uint64_t
  vertices(const TilePlan& plan) const
  {
    return records.size() / plan.layout.point_step;
  }
};

void
writeRepaired(const TilePlan& plan, std::size_t tile, const RepairedTile& repaired);
/** \param[in] with_surface else without records and triangles */
RepairedTile
readRepaired(const TilePlan& plan, std::size_t tile, bool with_surface);

/** \brief The repairs of all tiles in numbers. */
struct RepairNumbers {
  std::vector<std::uint64_t> first; /**< new vertex of each tile, and behind the last */
  std::vector<std::array<std::uint64_t, 2>> dropped; /**< tile and patch, ascending */
  std::uint64_t components = 0;                      /**< of the surface after it */
  RepairedPatch sum;                                 /**< of the patches that stay */
  TileRepairFacts facts;
};

void
writeNumbers(const TilePlan& plan, const RepairNumbers& numbers);
RepairNumbers
readNumbers(const TilePlan& plan);

} // namespace app
