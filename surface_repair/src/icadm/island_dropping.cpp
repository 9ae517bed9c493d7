// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: leaves out islands that are too small to be wanted.

#include "icadm/island_dropping.h"

#include "icadm/model_assembly.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::repair {

namespace {

/** For each island whether it is small. */
std::vector<bool>
smallOnes(const std::vector<Island>& islands, const SmallIslands& small)
{
  double all = 0.0;
  for (const Island& island : islands)
    all += island.area;
  const double least = std::max(small.area, small.share_of_all_area * all);
  std::vector<bool> is_small;
  for (const Island& island : islands)
    is_small.push_back(island.triangles < small.triangles || island.area < least);
  return is_small;
}

template <typename T>
std::vector<T>
chosen(const std::vector<T>& values, const std::vector<std::size_t>& kept)
{
  std::vector<T> list;
  if (!values.empty())
    for (const std::size_t i : kept)
      list.push_back(values[i]);
  return list;
}

/** The triangles of the islands that stay. */
Triangles
keptTriangles(const IncompleteModel& model, const std::vector<bool>& dropped)
{
  Triangles triangles;
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    if (!dropped[model.island_of[t]])
      triangles.push_back(model.triangles[t]);
  return triangles;
}

/** Number the vertices of some triangles anew, in their old order. \\return the old
 * numbers */
std::vector<std::size_t>
numberAnew(std::size_t vertices, Triangles& triangles)
{
  std::vector<pcl::index_t> number(vertices, pcl::UNAVAILABLE);
  for (const Triangle& triangle : triangles)
    for (const pcl::index_t corner : triangle)
      number[static_cast<std::size_t>(corner)] = 0;
  std::vector<std::size_t> kept;
  for (std::size_t v = 0; v < vertices; ++v)
    if (number[v] == 0) {
      number[v] = static_cast<pcl::index_t>(kept.size());
      kept.push_back(v);
    }
  for (Triangle& triangle : triangles)
    for (pcl::index_t& corner : triangle)
      corner = number[static_cast<std::size_t>(corner)];
  return kept;
}

} // namespace

void
dropIslands(const SmallIslands& small,
            const ccaa::LoopContext& context,
            ReadModel& read)
{
  IncompleteModel& model = read.model;
  const std::vector<bool> dropped = smallOnes(model.islands, small);
  const auto count =
      static_cast<std::size_t>(std::count(dropped.begin(), dropped.end(), true));
  if (count == 0)
    return;
  Triangles triangles = keptTriangles(model, dropped);
  read.report.dropped_islands = count;
  read.report.dropped_triangles = model.triangles.size() - triangles.size();
  if (triangles.empty()) {
    read.report.problem = "all islands are smaller than those that are to be kept";
    return;
  }
  const std::vector<std::size_t> kept = numberAnew(model.positions.size(), triangles);
  IncompleteModel left =
      assembleModel(std::move(triangles), chosen(model.positions, kept), context);
  left.point_of_vertex = chosen(model.point_of_vertex, kept);
  left.given_normals = chosen(model.given_normals, kept);
  left.viewpoints = chosen(model.viewpoints, kept);
  left.viewpoints_by = model.viewpoints_by;
  left.free_points = std::move(model.free_points);
  left.point_of_free_point = std::move(model.point_of_free_point);
  model = std::move(left);
}

} // namespace pcl::repair
