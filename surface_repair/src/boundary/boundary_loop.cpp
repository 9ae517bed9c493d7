// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a closed boundary of the reconstructed region A.
#include "boundary/boundary_loop.h"

namespace pcl::repair {

double
lengthOf(const BoundaryCurve& curve)
{
  double length = 0.0;
  for (std::size_t k = 0; k < curve.size(); ++k)
    length += curve.edge(k).norm();
  return length;
}

pcl::index_t
lowestPoint(const IncompleteModel& model, const std::vector<pcl::index_t>& vertices)
{
  pcl::index_t lowest = pcl::UNAVAILABLE;
  for (const pcl::index_t vertex : vertices) {
    const pcl::index_t point = model.point_of_vertex[static_cast<std::size_t>(vertex)];
    if (point != pcl::UNAVAILABLE && (lowest == pcl::UNAVAILABLE || point < lowest))
      lowest = point;
  }
  return lowest;
}

} // namespace pcl::repair
