// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points at which holes meet, as one vertex while these holes
// are closed.

#include "icadm/pinched_points.h"

#include "icadm/model_assembly.h"
#include "icadm/point_fans.h"
#include "icadm/vertex_numbers.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace pcl::repair {

std::vector<bool>
copiesOfPoints(const std::vector<pcl::index_t>& point_of)
{
  std::vector<bool> is_copy(point_of.size(), false);
  std::vector<bool> is_taken;
  for (std::size_t v = 0; v < point_of.size(); ++v) {
    if (point_of[v] == pcl::UNAVAILABLE)
      continue;
    const auto point = static_cast<std::size_t>(point_of[v]);
    if (point >= is_taken.size())
      is_taken.resize(2 * point + 1, false);
    is_copy[v] = is_taken[point];
    is_taken[point] = true;
  }
  return is_copy;
}

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
  rebuildAdjacency(context, model);
}

namespace {

/** Edges of one triangle only, by where they begin. */
struct OpenEdges {
  std::map<pcl::index_t, pcl::index_t> next;
  std::set<pcl::index_t> of_added; /**< they begin there and are of a new triangle */
};

OpenEdges
openEdges(const IncompleteModel& model, const Triangles& added)
{
  std::set<std::pair<pcl::index_t, pcl::index_t>> edges;
  for (const Triangle& triangle : added)
    for (std::size_t c = 0; c < 3; ++c)
      edges.emplace(triangle[c], triangle[(c + 1) % 3]);
  OpenEdges open;
  const auto old = static_cast<pcl::index_t>(model.adjacency.vertexCount());
  for (const auto& [from, to] : edges)
    if (edges.count({to, from}) == 0 &&
        !(from < old && to < old && areJoined(model, from, to))) {
      open.next.emplace(from, to);
      open.of_added.insert(from);
    }
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c) {
      const pcl::index_t from = model.triangles[t][static_cast<std::size_t>(c)];
      const pcl::index_t to = model.triangles[t][static_cast<std::size_t>((c + 1) % 3)];
      if (model.adjacency.across(static_cast<pcl::index_t>(t), c) < 0 &&
          edges.count({to, from}) == 0)
        open.next.emplace(from, to);
    }
  return open;
}

/** All vertices that share an edge with one. */
std::set<pcl::index_t>
neighborsOf(const IncompleteModel& model, const Triangles& added, pcl::index_t vertex)
{
  std::set<pcl::index_t> neighbors;
  const auto* triangle = model.adjacency.begin(vertex);
  for (; triangle != model.adjacency.end(vertex); ++triangle)
    for (const pcl::index_t corner :
         model.triangles[static_cast<std::size_t>(*triangle)])
      neighbors.insert(corner);
  for (const Triangle& corners : added)
    if (std::find(corners.begin(), corners.end(), vertex) != corners.end())
      neighbors.insert(corners.begin(), corners.end());
  neighbors.erase(vertex);
  return neighbors;
}

} // namespace

VertexMap
slitsBetween(const IncompleteModel& model, const Triangles& added)
{
  VertexMap slits;
  const std::vector<bool> is_copy = copiesOfPoints(model.point_of_vertex);
  if (added.empty() || std::find(is_copy.begin(), is_copy.end(), true) == is_copy.end())
    return slits; // each point has one vertex
  const auto old = static_cast<pcl::index_t>(model.adjacency.vertexCount());
  const OpenEdges open = openEdges(model, added);
  for (const auto& [first, middle] : open.next) {
    const auto found = open.next.find(middle);
    if (found == open.next.end() || first >= old || found->second >= old ||
        (open.of_added.count(first) == 0 && open.of_added.count(middle) == 0))
      continue;
    const auto [kept, other] = std::minmax(first, found->second);
    const auto point = [&](pcl::index_t vertex) {
      return model.point_of_vertex[static_cast<std::size_t>(vertex)];
    };
    if (kept == other || point(kept) == pcl::UNAVAILABLE || point(kept) != point(other))
      continue;
    const std::set<pcl::index_t> one = neighborsOf(model, added, kept);
    const std::set<pcl::index_t> two = neighborsOf(model, added, other);
    const pcl::index_t tip = middle;
    const bool would_fit = std::none_of(one.begin(), one.end(), [&](pcl::index_t v) {
      return v != tip && two.count(v) > 0;
    });
    if (would_fit && slits.count(kept) == 0)
      slits.emplace(other, kept);
  }
  return slits;
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
  rebuildAdjacency(context, model);
  if (context.cancelled())
    return number;
  PointFans split = separateFans(model.triangles, model.adjacency);
  if (split.vertices.empty())
    return number;
  model.triangles = std::move(split.triangles);
  for (const pcl::index_t vertex : split.vertices) {
    const auto place = static_cast<std::size_t>(vertex);
    model.positions.push_back(Position(model.positions[place]));
    model.point_of_vertex.push_back(pcl::index_t(model.point_of_vertex[place]));
    if (!model.viewpoints.empty())
      model.viewpoints.push_back(Position(model.viewpoints[place]));
  }
  rebuildAdjacency(context, model);
  return number;
}

} // namespace pcl::repair
