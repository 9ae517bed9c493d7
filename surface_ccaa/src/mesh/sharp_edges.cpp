// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges at which a surface is sharp.
#include "mesh/sharp_edges.h"

#include "mesh/corners.h"
#include "mesh/uninitialized.h"

namespace pcl::ccaa {
namespace {

using Edge = TriangleAdjacency::Edge;

/** Cosine between the normals at a sharp edge. */
constexpr float SHARP = 0.5f;

/** Whether the corner of a triangle that is not on an edge lies above another one. */
bool
isConcave(const Triangle& triangle,
          const Triangle& across,
          const Edge& edge,
          const PointView& points)
{
  const pcl::index_t apex = across[0] + across[1] + across[2] - edge[0] - edge[1];
  return (points[apex] - points[edge[0]]).dot(areaNormal(cornersOf(triangle, points))) >
         0.0;
}

} // namespace

SharpEdges
findSharpEdges(const Triangles& triangles,
               const TriangleAdjacency& adjacency,
               const PointView& points,
               const LoopContext& context)
{
  UninitializedVector<Eigen::Vector3f> normals(triangles.size());
  forEachBlock(
      triangles.size(), context, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          normals[i] = unitNormal(cornersOf(triangles[i], points)).cast<float>();
      });
  const std::size_t blocks = context.blockCount(triangles.size());
  std::vector<std::vector<Edge>> concave(blocks), convex(blocks);
  const auto find = [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const auto t = static_cast<pcl::index_t>(i);
        const pcl::index_t across = adjacency.across(t, static_cast<int>(corner));
        if (across <= t ||
            normals[i].dot(normals[static_cast<std::size_t>(across)]) >= SHARP)
          continue;
        const Edge edge{triangles[i][corner], triangles[i][(corner + 1) % 3]};
        const Triangle& other = triangles[static_cast<std::size_t>(across)];
        (isConcave(triangles[i], other, edge, points) ? concave : convex)[block]
            .push_back(edge);
      }
  };
  forEachBlock(triangles.size(), context, find);
  return {joinBlocks(concave), joinBlocks(convex)};
}

} // namespace pcl::ccaa
