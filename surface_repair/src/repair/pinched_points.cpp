// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points at which holes meet, as one vertex while these holes
// are closed.

#include "pinched_points.h"

#include "../icadm/point_fans.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace repair {

namespace {

/** \brief Number the vertices that triangles have anew, in their order. */
std::vector<pcl::index_t>
numbersWithoutGaps(const Triangles& triangles, std::size_t vertices)
{
  std::vector<pcl::index_t> number(vertices, pcl::UNAVAILABLE);
  for (const Triangle& triangle : triangles)
    for (const pcl::index_t corner : triangle)
      number[static_cast<std::size_t>(corner)] = 0;
  pcl::index_t next = 0;
  for (pcl::index_t& entry : number)
    if (entry != pcl::UNAVAILABLE)
      entry = next++;
  return number;
}

/** \brief Bring entries, one a vertex, to the places of new numbers. */
template <typename T>
void
renumber(const std::vector<pcl::index_t>& number, std::vector<T>& entries)
{
  std::size_t left = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != pcl::UNAVAILABLE)
      entries[left++] = entries[v];
  entries.resize(left);
}

} // namespace

void
weldPinches(const VertexMap& replaced,
            const ccaa::LoopContext& context,
            IncompleteModel& model)
{
  for (const auto& [vertex, kept] : replaced)
    for (const pcl::index_t* triangle = model.adjacency.begin(vertex);
         triangle != model.adjacency.end(vertex);
         ++triangle) {
      Triangle& corners = model.triangles[static_cast<std::size_t>(*triangle)];
      std::replace(corners.begin(), corners.end(), vertex, kept);
    }
  model.adjacency.build(
      model.triangles, model.positions.size(), context.threads, context.control);
}

std::vector<pcl::index_t>
separatePinches(const ccaa::LoopContext& context, IncompleteModel& model)
{
  std::vector<pcl::index_t> number =
      numbersWithoutGaps(model.triangles, model.positions.size());
  renumber(number, model.positions);
  renumber(number, model.point_of_vertex);
  for (Triangle& triangle : model.triangles)
    for (pcl::index_t& corner : triangle)
      corner = number[static_cast<std::size_t>(corner)];
  model.adjacency.build(
      model.triangles, model.positions.size(), context.threads, context.control);
  if (context.cancelled())
    return number;
  PointFans split = separateFans(model.triangles, model.adjacency);
  model.triangles = std::move(split.triangles);
  for (const pcl::index_t vertex : split.vertices) {
    const auto place = static_cast<std::size_t>(vertex);
    model.positions.push_back(Position(model.positions[place]));
    model.point_of_vertex.push_back(pcl::index_t(model.point_of_vertex[place]));
  }
  return number;
}

} // namespace repair
} // namespace pcl
