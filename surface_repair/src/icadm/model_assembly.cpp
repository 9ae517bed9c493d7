// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what follows from the triangles of an incomplete model.
#include "icadm/model_assembly.h"

#include "mesh/sort_unique.h"
#include "mesh/vertex_normals.h"
#include "mesh/winding.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace pcl::repair {
namespace {

/** Operations for a triangle, to measure its island. */
constexpr std::uint64_t MEASURING_WORK = 5;

double
areaOf(const Triangle& triangle, const Positions& positions)
{
  const Position& a = positions[static_cast<std::size_t>(triangle[0])];
  const Position& b = positions[static_cast<std::size_t>(triangle[1])];
  const Position& c = positions[static_cast<std::size_t>(triangle[2])];
  return 0.5 * (b - a).cross(c - a).norm();
}

std::vector<Island>
measureIslands(const IncompleteModel& model)
{
  std::vector<Island> islands(model.island_of.count);
  for (Island& island : islands)
    island.closed = true;
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    Island& island = islands[model.island_of[t]];
    const auto triangle = static_cast<pcl::index_t>(t);
    if (island.triangles++ == 0)
      island.first_triangle = triangle;
    island.area += areaOf(model.triangles[t], model.positions);
    for (int corner = 0; corner < 3; ++corner) {
      const pcl::index_t vertex = model.triangles[t][static_cast<std::size_t>(corner)];
      island.box.extend(model.positions[static_cast<std::size_t>(vertex)]);
      if (model.adjacency.across(triangle, corner) < 0)
        island.closed = false;
      if (ccaa::disagreesAcross(model.triangles, model.adjacency, triangle, corner))
        island.one_sided = true;
    }
  }
  return islands;
}

} // namespace

void
rebuildAdjacency(const ccaa::LoopContext& context, IncompleteModel& model)
{
  model.adjacency.build(
      model.triangles, model.positions.size(), context.threads, context.control);
}

bool
isManifold(const ccaa::TriangleAdjacency& adjacency)
{
  const auto& fans = adjacency.fans();
  return std::none_of(fans.begin(), fans.end(), [](ccaa::Fan fan) {
    return fan == ccaa::Fan::SEVERAL || fan == ccaa::Fan::OVERFULL;
  });
}

bool
areJoined(const IncompleteModel& model, pcl::index_t a, pcl::index_t b)
{
  const auto holds = [&](pcl::index_t triangle) {
    const Triangle& corners = model.triangles[static_cast<std::size_t>(triangle)];
    return std::find(corners.begin(), corners.end(), b) != corners.end();
  };
  return std::any_of(model.adjacency.begin(a), model.adjacency.end(a), holds);
}

bool
isConsistentlyWound(const Triangles& triangles,
                    const ccaa::TriangleAdjacency& adjacency)
{
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int corner = 0; corner < 3; ++corner)
      if (ccaa::disagreesAcross(
              triangles, adjacency, static_cast<pcl::index_t>(t), corner))
        return false;
  return true;
}

Directions
externalNormals(const Triangles& triangles,
                const Positions& positions,
                const ccaa::LoopContext& context)
{
  const auto singles = ccaa::vertexNormals(triangles, positions, context);
  Directions normals;
  normals.reserve(singles.size());
  for (const Eigen::Vector3f& normal : singles)
    normals.push_back(normal.cast<double>().normalized()); // NaN stays NaN
  return normals;
}

namespace {

/** The external normals of the vertices on boundaries, for which alone a repair asks:
 * those of all take a quarter of the time of reading. */
Directions
boundaryNormals(const IncompleteModel& model, const ccaa::LoopContext& context)
{
  std::vector<pcl::index_t> around;
  for (std::size_t v = 0; v < model.positions.size(); ++v) {
    const auto vertex = static_cast<pcl::index_t>(v);
    if (model.adjacency.fan(vertex) == ccaa::Fan::OPEN)
      around.insert(
          around.end(), model.adjacency.begin(vertex), model.adjacency.end(vertex));
  }
  ccaa::sortUnique(around); // the order in which externalNormals() adds up
  Positions positions;
  std::unordered_map<pcl::index_t, pcl::index_t> number_of;
  Triangles triangles;
  for (const pcl::index_t t : around) {
    Triangle triangle = model.triangles[static_cast<std::size_t>(t)];
    for (pcl::index_t& corner : triangle) {
      const auto [entry, is_new] =
          number_of.emplace(corner, static_cast<pcl::index_t>(positions.size()));
      if (is_new)
        positions.push_back(model.positions[static_cast<std::size_t>(corner)]);
      corner = entry->second;
    }
    triangles.push_back(triangle);
  }
  const Directions found = externalNormals(triangles, positions, context);
  Directions normals(model.positions.size(), Direction::Zero());
  for (const auto& [vertex, number] : number_of)
    if (model.adjacency.fan(vertex) == ccaa::Fan::OPEN)
      normals[static_cast<std::size_t>(vertex)] =
          found[static_cast<std::size_t>(number)];
  return normals;
}

} // namespace

IncompleteModel
assembleModel(Triangles triangles,
              Positions positions,
              const ccaa::LoopContext& context)
{
  ccaa::TriangleAdjacency adjacency;
  adjacency.build(triangles, positions.size(), context.threads, context.control);
  return assembleModel(
      std::move(triangles), std::move(positions), std::move(adjacency), context);
}

IncompleteModel
assembleModel(Triangles triangles,
              Positions positions,
              ccaa::TriangleAdjacency adjacency,
              const ccaa::LoopContext& context)
{
  IncompleteModel model;
  model.triangles = std::move(triangles);
  model.positions = std::move(positions);
  model.point_of_vertex.resize(model.positions.size());
  std::iota(model.point_of_vertex.begin(), model.point_of_vertex.end(), 0);
  model.adjacency = std::move(adjacency);
  if (context.cancelled())
    return model;
  ccaa::RunControl silent(context.control); // tells no stages
  model.island_of = ccaa::labelIslands(model.adjacency, {1, &silent});
  ccaa::spend(context.control, MEASURING_WORK * model.triangles.size());
  if (context.cancelled())
    return model;
  model.islands = measureIslands(model);
  ccaa::spend(context.control, MEASURING_WORK * model.triangles.size());
  model.normals = boundaryNormals(model, context);
  return model;
}

} // namespace pcl::repair
