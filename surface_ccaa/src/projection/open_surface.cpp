// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the part of a cloud and its partial mesh still to be done.
#include <pcl/surface_ccaa/projection/open_surface.h>

#include <algorithm>
#include <utility>

namespace pcl {
namespace ccaa {

void
findNeighborsDirectly(OpenSurface& open, unsigned int k)
{
  open.neighbor_table.assign(open.open_points * k, NeighborRows::NONE);
  std::vector<std::pair<double, index_t>> near;
  for (std::size_t i = 0; i < open.open_points; ++i) {
    near.clear();
    for (std::size_t j = 0; j < open.open_points; ++j)
      if (j != i)
        near.emplace_back((open.positions[i] - open.positions[j]).squaredNorm(),
                          static_cast<index_t>(j));
    const std::size_t count = std::min<std::size_t>(k, near.size());
    std::partial_sort(
        near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    for (std::size_t j = 0; j < count; ++j)
      open.neighbor_table[i * k + j] = near[j].second;
  }
  open.neighbors = {open.neighbor_table.data(), k};
}

} // namespace ccaa
} // namespace pcl
