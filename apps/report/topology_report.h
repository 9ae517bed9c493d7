// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pieces, openings and handles of a mesh, for reports.
#pragma once

#include "mesh/surface_topology.h"
#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>

namespace app {

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
