// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the part of a cloud and its partial mesh still to be done.
#include "advancing_front/open_surface.h"

#include "mesh/sort_unique.h"

#include <algorithm>
#include <utility>

namespace pcl::ccaa {

IndexSet
numberRim(Triangles& rim, std::vector<index_t>& vertices)
{
  IndexSet numbers(vertices);
  std::vector<index_t> others;
  for (const Triangle& triangle : rim)
    for (const index_t corner : triangle)
      if (!numbers.contains(corner))
        others.push_back(corner);
  sortUnique(others);
  for (const index_t vertex : others)
    numbers.insert(vertex);
  for (Triangle& triangle : rim)
    for (index_t& corner : triangle)
      corner = numbers.placeOf(corner);
  vertices = numbers.items();
  return numbers;
}

Triangles
inTheWhole(Triangles triangles, const std::vector<index_t>& vertices)
{
  for (Triangle& triangle : triangles)
    for (index_t& corner : triangle)
      corner = vertices[static_cast<std::size_t>(corner)];
  return triangles;
}

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

} // namespace pcl::ccaa
