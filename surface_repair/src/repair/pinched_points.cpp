// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points at which holes meet, as one vertex while these holes
// are closed.

#include "repair/pinched_points.h"

#include "icadm/point_fans.h"
#include "icadm/vertex_numbers.h"

#include <algorithm>
#include <utility>

namespace pcl {
namespace repair {

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
      numberWithoutGaps(model.positions.size(), model.triangles);
  renumber(number, model.positions);
  renumber(number, model.point_of_vertex);
  if (!model.viewpoints.empty())
    renumber(number, model.viewpoints);
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
    if (!model.viewpoints.empty())
      model.viewpoints.push_back(Position(model.viewpoints[place]));
  }
  return number;
}

} // namespace repair
} // namespace pcl
