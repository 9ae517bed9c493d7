// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges that a fill must not have once more.

#include "patch/taken_edges.h"

#include "icadm/model_assembly.h"

#include <algorithm>

namespace pcl::repair {

void
TakenEdges::addPolygon(const HolePolygon& polygon)
{
  for (std::size_t k = 0; k < polygon.size(); ++k)
    edges_.insert(
        std::minmax(polygon.vertices[k], polygon.vertices[polygon.curve.next(k)]));
}

void
TakenEdges::addFilling(const HolePolygon& polygon, const Filling& filling)
{
  const auto vertex = [&](pcl::index_t corner) {
    return polygon.vertices[static_cast<std::size_t>(corner)];
  };
  const auto on_polygon = [&](pcl::index_t corner) {
    return static_cast<std::size_t>(corner) < polygon.size();
  };
  for (const Triangle& t : filling.triangles)
    for (std::size_t c = 0; c < 3; ++c)
      if (on_polygon(t[c]) && on_polygon(t[(c + 1) % 3])) {
        const pcl::index_t a = vertex(t[c]);
        const pcl::index_t b = vertex(t[(c + 1) % 3]);
        edges_.insert(std::minmax(a, b));
      }
}

bool
TakenEdges::contain(pcl::index_t a, pcl::index_t b) const
{
  const auto vertices = static_cast<pcl::index_t>(model_.positions.size());
  return edges_.count(std::minmax(a, b)) > 0 ||
         (a < vertices && b < vertices && areJoined(model_, a, b));
}

FillingTask
fillingTask(const HolePolygon& polygon,
            const TakenEdges& taken,
            const SurfaceObstacle* obstacle,
            ccaa::RunControl* control)
{
  FillingTask task;
  task.control = control;
  task.polygon = polygon.curve;
  task.second_loop = polygon.second_loop;
  if (polygon.second_loop > 0)
    task.vertices = polygon.vertices;
  task.joined = [&polygon, &taken](std::size_t a, std::size_t b) {
    return polygon.curve.points[a] == polygon.curve.points[b] ||
           taken.contain(polygon.vertices[a], polygon.vertices[b]);
  };
  if (obstacle != nullptr)
    avoid(*obstacle, task);
  return task;
}

} // namespace pcl::repair
