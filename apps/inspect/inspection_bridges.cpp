// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the bridges of a repair as coloured lines.
#include "layer_builder.h"

#include <algorithm>

namespace app {
namespace {

double
bestQuality(const std::vector<pcl::RepairBridge>& bridges)
{
  double best = 1e-300;
  for (const pcl::RepairBridge& bridge : bridges)
    best = std::max(best, bridge.quality);
  return best;
}

void
addLegend(const std::vector<pcl::RepairBridge>& bridges, LayerBuilder& builder)
{
  if (bridges.empty())
    return;
  const auto within_holes = std::count_if(
      bridges.begin(), bridges.end(), [](const auto& b) { return b.within_hole; });
  const auto between_islands =
      static_cast<std::ptrdiff_t>(bridges.size()) - within_holes;
  builder.addLegend(colorOfBridge(1.0), "strong bridge");
  builder.addLegend(colorOfBridge(0.0),
                    "weak bridge; in all " + std::to_string(between_islands) +
                        " between boundaries, " + std::to_string(within_holes) +
                        " within holes");
}

} // namespace

InspectionLayer
showBridges(const std::vector<pcl::RepairBridge>& bridges,
            const pcl::GlobalShift& shift)
{
  LayerBuilder builder(
      "bridges.vtk",
      "Bridges by quality",
      {"normal", "quality", "bridge", "begin_island", "end_island", "within_hole"});
  const double best = bestQuality(bridges);
  for (std::size_t i = 0; i < bridges.size(); ++i) {
    const pcl::RepairBridge& bridge = bridges[i];
    builder.addCurve(bridge.points.size(), false, [&](std::size_t k) {
      builder.addPoint(bridge.points[k] - shift.offset(),
                       colorOfBridge(bridge.quality / best),
                       Eigen::Vector3d(bridge.normals[k]),
                       bridge.quality,
                       i,
                       bridge.begin_island,
                       bridge.end_island,
                       bridge.within_hole);
    });
  }
  addLegend(bridges, builder);
  return builder.finish(
      "normal: external; quality: mean force; bridge: number; begin_island, "
      "end_island: that it joins; within_hole: 1 if it divides a hole");
}

} // namespace app
