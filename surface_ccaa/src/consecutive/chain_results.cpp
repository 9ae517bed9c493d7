// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is made of a chain's mesh and times at the end.
#include "consecutive/chain_results.h"

#include "mesh/cloud_access.h"
#include "mesh/vertex_normals.h"

namespace pcl::ccaa {

void
fillNormals(const Triangles& triangles,
            const PCLPointCloud2& cloud,
            const LoopContext& context,
            PointCloud<Normal>& normals)
{
  const auto vectors = vertexNormals(triangles, positionView(cloud), context);
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    normals[i].getNormalVector3fMap() = vectors[i];
    normals.is_dense = normals.is_dense && vectors[i].allFinite();
  }
}

SpeedupReport
compareSpeed(double base_seconds, const ConsecutiveReport& report)
{
  SpeedupReport measured;
  measured.cancelled = report.cancelled;
  if (report.total_seconds <= 0 || report.points == 0)
    return measured;
  measured.points = report.points;
  measured.base_seconds = base_seconds;
  measured.chain_seconds = report.total_seconds;
  measured.speedup = base_seconds / report.total_seconds;
  measured.base_cost = base_seconds / static_cast<double>(report.points);
  measured.start_cost = report.startCost();
  measured.filter_cost = report.filterCost();
  measured.connected_share = report.connectedShare();
  measured.is_advantageous = measured.connected_share * measured.base_cost >
                             measured.start_cost + measured.filter_cost;
  return measured;
}

} // namespace pcl::ccaa
