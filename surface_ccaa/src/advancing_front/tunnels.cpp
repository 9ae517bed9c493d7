// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tunnels that a start algorithm made through thin places.
#include "advancing_front/tunnels.h"

#include "mesh/box_tree.h"
#include "mesh/surface_topology.h"
#include "mesh/vertex_normals.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl {
namespace ccaa {
namespace {

/** Lengths of the edges at a point within which its other side is looked for. */
constexpr double REACH = 2.0;
/** Cosine between normals of two sides. */
constexpr float OPPOSITE = -0.3f;
/** Triangles around a thin place that depend on it. */
constexpr int AROUND = 4;

class ThinPlaces {
public:
  ThinPlaces(const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const PointView& points,
             const LoopContext& context)
  : triangles_(triangles), adjacency_(adjacency), context_(context)
  {
    for (std::size_t v = 0; v < points.size(); ++v)
      positions_.push_back(points[v]);
    normals_ = vertexNormals(triangles, positions_, context);
    std::vector<Box> boxes;
    for (std::size_t v = 0; v < positions_.size(); ++v)
      boxes.push_back(isUsed(v) ? Box(positions_[v]) : Box());
    tree_ = BoxTree(boxes);
  }

  std::vector<pcl::index_t>
  run() const
  {
    std::vector<std::uint8_t> is_thin(positions_.size(), 0);
    const auto look = [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t v = begin; v < end; ++v)
        is_thin[v] = isUsed(v) && isThin(v) ? 1 : 0;
    };
    forEachBlock(positions_.size(), context_, look);
    std::vector<pcl::index_t> found;
    for (int ring = 0; ring < AROUND; ++ring) {
      found = trianglesAt(is_thin);
      for (const pcl::index_t t : found)
        for (const pcl::index_t corner : triangles_[static_cast<std::size_t>(t)])
          is_thin[static_cast<std::size_t>(corner)] = 1;
    }
    return found;
  }

private:
  std::vector<pcl::index_t>
  trianglesAt(const std::vector<std::uint8_t>& is_chosen) const
  {
    std::vector<pcl::index_t> found;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (std::any_of(triangles_[t].begin(), triangles_[t].end(), [&](pcl::index_t v) {
            return is_chosen[static_cast<std::size_t>(v)] != 0;
          }))
        found.push_back(static_cast<pcl::index_t>(t));
    return found;
  }

  bool
  isUsed(std::size_t vertex) const
  {
    const auto v = static_cast<pcl::index_t>(vertex);
    return vertex < adjacency_.vertexCount() &&
           adjacency_.begin(v) != adjacency_.end(v) && normals_[vertex].allFinite();
  }

  double
  edgeLength(std::size_t vertex) const
  {
    const auto v = static_cast<pcl::index_t>(vertex);
    double sum = 0.0;
    std::size_t count = 0;
    for (const auto* t = adjacency_.begin(v); t != adjacency_.end(v); ++t)
      for (const pcl::index_t c : triangles_[static_cast<std::size_t>(*t)])
        if (c != v) {
          sum += (positions_[static_cast<std::size_t>(c)] - positions_[vertex]).norm();
          ++count;
        }
    return sum / static_cast<double>(count);
  }

  bool
  isThin(std::size_t vertex) const
  {
    const double reach = REACH * edgeLength(vertex);
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(reach);
    bool found = false;
    tree_.forEachMeeting(
        Box(positions_[vertex] - half, positions_[vertex] + half), [&](pcl::index_t o) {
          const auto other = static_cast<std::size_t>(o);
          found = found || (normals_[other].dot(normals_[vertex]) < OPPOSITE &&
                            (positions_[other] - positions_[vertex]).norm() <= reach);
        });
    return found;
  }

  const Triangles& triangles_;
  const TriangleAdjacency& adjacency_;
  const LoopContext& context_;
  Positions positions_;
  std::vector<Eigen::Vector3f> normals_;
  BoxTree tree_;
};

SurfaceTopology
topologyIn(const CompletedMesh& mesh, std::size_t vertices, int threads)
{
  TriangleAdjacency adjacency;
  adjacency.build(mesh.triangles, vertices, threads);
  return topologyOf(mesh.triangles, adjacency);
}

/** What a body is unlikely to have: handles, openings, points beside its surface. */
std::size_t
flawsOf(const SurfaceTopology& topology, const CompletionReport& report)
{
  return 2 * static_cast<std::size_t>(topology.genus.value_or(0)) +
         topology.boundary_loops + report.free_points;
}

} // namespace

std::vector<pcl::index_t>
trianglesAtThinPlaces(const Triangles& triangles,
                      const TriangleAdjacency& adjacency,
                      const PointView& points,
                      const LoopContext& context)
{
  return ThinPlaces(triangles, adjacency, points, context).run();
}

void
openTunnels(const PartialMesh& mesh,
            const CompletionWithout& complete,
            const LoopContext& context,
            CompletedMesh& result,
            CompletionReport& report)
{
  const std::size_t vertices = mesh.points.size();
  const SurfaceTopology topology = topologyIn(result, vertices, context.threads);
  if (context.cancelled() || topology.genus.value_or(0) <= 0)
    return;
  TriangleAdjacency adjacency;
  adjacency.build(mesh.given, vertices, context.threads);
  const auto thin = trianglesAtThinPlaces(mesh.given, adjacency, mesh.points, context);
  if (thin.empty() || context.cancelled())
    return;
  CompletionReport other_report;
  CompletedMesh other = complete(thin, other_report);
  if (context.cancelled() || flawsOf(topologyIn(other, vertices, context.threads),
                                     other_report) >= flawsOf(topology, report))
    return;
  result = std::move(other);
  report = other_report;
}

} // namespace ccaa
} // namespace pcl
