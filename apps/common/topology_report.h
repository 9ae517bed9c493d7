// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pieces, openings and handles of a mesh, for reports.
#pragma once

#include <pcl/Vertices.h>

#include "mesh/surface_topology.h"
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace app {

/** \brief Of a mesh of triangles whose corners are points. */
pcl::ccaa::SurfaceTopology
topologyOf(const std::vector<pcl::Vertices>& triangles,
           std::size_t point_count,
           int threads);

/** \brief Keys `pieces`, `boundary_loops`, `euler_characteristic`, `genus`,
 * `watertight` of a report. */
nlohmann::json
describeTopology(const pcl::ccaa::SurfaceTopology& topology);

/** \brief Such as "watertight: yes, genus 0, Euler characteristic 2". */
std::string
summarizeTopology(bool is_watertight, std::optional<long> genus, long characteristic);

inline std::string
summarizeTopology(const pcl::ccaa::SurfaceTopology& topology)
{
  return summarizeTopology(
      topology.isWatertight(), topology.genus, topology.euler_characteristic);
}

} // namespace app
