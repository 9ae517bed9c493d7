// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the part of a cloud and its partial mesh still to be done.
#include "advancing_front/open_surface.h"

#include "mesh/sort_unique.h"

#include <algorithm>
#include <utility>

namespace pcl::ccaa {

VertexNumbers::VertexNumbers(const Triangles& rim, std::vector<index_t>& vertices)
{
  note(vertices, 0);
  std::vector<index_t> others;
  for (const Triangle& triangle : rim)
    for (const index_t corner : triangle)
      if ((*this)[corner] < 0)
        others.push_back(corner);
  sortUnique(others);
  note(others, vertices.size());
  vertices.insert(vertices.end(), others.begin(), others.end());
}

index_t
VertexNumbers::operator[](index_t vertex) const
{
  const auto place = std::lower_bound(
      numbers_.begin(), numbers_.end(), std::pair<index_t, index_t>(vertex, 0));
  return place != numbers_.end() && place->first == vertex ? place->second : -1;
}

void
VertexNumbers::note(const std::vector<index_t>& vertices, std::size_t first)
{
  for (std::size_t i = 0; i < vertices.size(); ++i)
    numbers_.emplace_back(vertices[i], static_cast<index_t>(first + i));
  std::sort(numbers_.begin(), numbers_.end());
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
