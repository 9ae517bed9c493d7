// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the bridges of a repair as coloured lines.
#include "bridge_layer.h"

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
  LayerBuilder builder("bridges.vtk", "Bridges by quality");
  FieldArray& normals = builder.realField("normal", 3);
  FieldArray& qualities = builder.realField("quality");
  FieldArray& numbers = builder.wholeField("bridge");
  FieldArray& begins = builder.wholeField("begin_island");
  FieldArray& ends = builder.wholeField("end_island");
  FieldArray& within_hole = builder.wholeField("within_hole");
  const double best = bestQuality(bridges);
  for (std::size_t i = 0; i < bridges.size(); ++i) {
    const pcl::RepairBridge& bridge = bridges[i];
    pcl::index_t last = -1;
    for (std::size_t k = 0; k < bridge.points.size(); ++k) {
      last = builder.addPoint(bridge.points[k] - shift.offset(),
                              colorOfBridge(bridge.quality / best));
      appendDirection(normals, bridge.normals[k]);
      qualities.append(static_cast<float>(bridge.quality));
      numbers.append(static_cast<std::int32_t>(i));
      begins.append(indexOrMinusOne(bridge.begin_island));
      ends.append(indexOrMinusOne(bridge.end_island));
      within_hole.append(static_cast<std::int32_t>(bridge.within_hole ? 1 : 0));
    }
    const std::size_t size = bridge.points.size();
    builder.addLine(last + 1 - static_cast<pcl::index_t>(size), size, false);
  }
  addLegend(bridges, builder);
  return builder.finish("normal: external; quality: mean force; bridge: number; "
                        "begin_island, end_island: that it joins; within_hole: 1 if it "
                        "divides a hole");
}

} // namespace app
