// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the work of pcl_ccaa_reconstruct.
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/reconstruction_report.h>
#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "clean/clean_cloud.h"
#include "file_names.h"
#include "io/model.h"
#include "mesh/surface_topology.h"
#include "progress.h"
#include "run_facts.h"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace app {

/** \brief Points of a tile, unless the user says otherwise, and at least. */
constexpr std::uint64_t DEFAULT_TILE_POINTS = 4000000;
constexpr std::uint64_t LEAST_TILE_POINTS = 1000;

/** \brief What the user asked pcl_ccaa_reconstruct for. */
struct ReconstructSettings {
  FileNames files;
  bool merge = false; // all inputs are one cloud
  bool clean = false; // before anything else
  CleanParameters cleaning;
  bool dry_run = false;
  std::string until = "base";
  std::string start = "auto"; // greedy, grid
  std::string search = "fast";
  unsigned int threads = 0;
  unsigned int neighbors = pcl::ccaa::GreedyParameters().neighbors;
  std::size_t minimum_internal_points =
      pcl::UmbrellaFilter().getMinimumInternalPoints();
  double minimum_angle = degrees(pcl::ccaa::GreedyParameters().minimum_angle);
  double certified_minimum_angle =
      degrees(pcl::ccaa::GreedyParameters().certified_minimum_angle);
  double length_factor = pcl::ccaa::GreedyParameters().length_factor; // local spacings
  bool plain = false;   // the thesis' rules alone
  bool labels = false;  // as a face property
  bool normals = false; // as fields of the cloud
  bool measure_speedup = false;
  bool repair = false;                  // what the base stage left open
  pcl::repair::RepairParameters method; // of the repair
  bool quiet = false;
  std::uint64_t tiles = 0; // most points of a tile; 0: all at once
  std::uint64_t memory = std::uint64_t{4} << 30; // bytes
  std::string tile_folder;                       // empty: none that stays
  pcl::ccaa::SideHints sides; // what the user tells about the outer side

  /** \brief As people write them: hundredths will do. */
  static double
  degrees(double angle)
  {
    return std::round(angle * 18000 / M_PI) / 100;
  }

  /** \brief The input or inputs, as messages have them. */
  std::string
  inputName() const
  {
    return files.inputs.size() > 1 ? std::to_string(files.inputs.size()) + " clouds"
                                   : nameForPeople(files.input());
  }

  bool
  hasFilter() const
  {
    return until != "start";
  }
};

/** \brief What a run made, and what is to be told about it. */
struct ReconstructResult {
  Model model; // cloud with all fields, polygons of the last stage
  std::optional<CleanReport> cleaning; // what became of the cloud that was read
  StageTimes stages;
  std::size_t memory_before = 0; // bytes, cloud loaded
  pcl::ccaa::GreedyReport start;
  bool has_grid_start = false; // instead of the greedy one
  pcl::UmbrellaReport filter;  // of the last stage that is there
  pcl::ConsecutiveReport chain;
  pcl::ccaa::SideTally sides; // what told the outer side
  std::optional<pcl::SpeedupReport> speedup;
  std::optional<pcl::ccaa::SurfaceTopology> topology; // none known of raw triangles
  std::optional<pcl::RepairReport> repair;            // what became of the holes
  std::vector<std::uint8_t> labels;                   // of the polygons: their stage
  pcl::PointCloud<pcl::Normal>::Ptr normals;          // null unless asked for

  /** \brief Of start.points, those with a triangle in the end. */
  std::size_t
  usedPlaces() const
  {
    return chain.points - chain.free_points;
  }
};

/** \brief Seconds of each stage that was run, as they add up to the whole. */
StageTimes
stageTimes(const ReconstructSettings& settings, const ReconstructResult& result);

/** \brief Make one even layer of the cloud of \a result. Warns of what was left undone.
 */
void
cleanInput(const ReconstructSettings& settings,
           ProgressBar& bar,
           ReconstructResult& result);

/** \brief Mesh the cloud of \a result; its fields stay byte for byte. Fails when the
 * run could not be finished; after a signal the result is of no use. */
void
runReconstruction(const ReconstructSettings& settings,
                  const pcl::ccaa::ProgressCallback& progress,
                  ReconstructResult& result);

/** \brief Count what the mesh that was made consists of, unless it is raw. */
void
countTopology(const ReconstructSettings& settings, ReconstructResult& result);

/** \brief Add the normals that were made as fields to the cloud. One that has normals
 * keeps them, and a warning says so. */
void
addNormals(ReconstructResult& result);

/** \brief What is told about the outer side with what a reconstruction has guessed, by
 * which its repair goes. */
pcl::ccaa::SideHints
sidesForRepair(pcl::ccaa::SideHints told, const pcl::ccaa::SideTally& found);

/** \brief Join the islands of \a result and close its holes. Fails as repairMesh()
 * does; after a signal the result is of no use. */
void
repairResult(const ReconstructSettings& settings,
             ProgressBar& bar,
             ReconstructResult& result);

} // namespace app
