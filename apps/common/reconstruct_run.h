// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the stages of pcl_ccaa_reconstruct.
#pragma once

#include <pcl/surface_ccaa/greedy/greedy_parameters.h>
#include <pcl/surface_ccaa/umbrella_filter.h>

#include "model.h"
#include "progress.h"
#include "report.h"

#include <string>

namespace app {

/** \brief What the user asked pcl_ccaa_reconstruct for. */
struct ReconstructSettings {
  std::string input;
  std::string output;
  std::string report;
  std::string until = "filter";
  std::string search = "fast";
  unsigned int threads = 0;
  unsigned int neighbors = 0;
  unsigned int minimum_internal_points = 0;
  double minimum_angle = 0;           // degrees
  double certified_minimum_angle = 0; // degrees
  double length_factor = 0;           // local spacings
  bool plain = false;                 // the thesis' rules alone
  bool quiet = false;
};

/** \brief What a run made, and what is to be told about it. */
struct ReconstructResult {
  Model model; // cloud with all fields, polygons of the last stage
  std::size_t usable_points = 0;
  std::size_t used_points = 0;
  StageTimes stages;
  std::size_t memory_before = 0; // bytes, cloud loaded
  pcl::ccaa::GreedyReport start;
  pcl::UmbrellaReport filter;
  bool filtered = false;
};

/** \brief Mesh the cloud of \a result with the greedy start. */
void
runStart(const ReconstructSettings& settings,
         ProgressBar& bar,
         ReconstructResult& result);

/** \brief Take the wrong triangles out again; the cloud stays byte for byte. */
void
runFilter(const ReconstructSettings& settings,
          ProgressBar& bar,
          ReconstructResult& result);

/** \brief Number of points that have a triangle. */
std::size_t
countUsedPoints(const pcl::PolygonMesh& mesh);

} // namespace app
