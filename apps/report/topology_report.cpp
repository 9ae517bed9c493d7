// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pieces, openings and handles of a mesh, for reports.
#include "topology_report.h"

#include <nlohmann/json.hpp>

namespace app {

nlohmann::json
describeTopology(const pcl::ccaa::SurfaceTopology& topology)
{
  return {{"pieces", topology.pieces},
          {"boundary_loops", topology.boundary_loops},
          {"euler_characteristic", topology.euler_characteristic},
          {"genus", topology.genus ? nlohmann::json(*topology.genus) : nullptr},
          {"watertight", topology.isWatertight()}};
}

std::string
summarizeTopology(bool is_watertight, std::optional<long> genus, long characteristic)
{
  std::string text = is_watertight ? "watertight: yes" : "watertight: no";
  if (genus)
    text += ", genus " + std::to_string(*genus);
  return text + ", Euler characteristic " + std::to_string(characteristic);
}

} // namespace app
