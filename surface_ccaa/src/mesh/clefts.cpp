// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where a surface faces itself across hardly any space.
#include "mesh/clefts.h"

#include "mesh/corners.h"
#include "mesh/neck_parts.h"
#include "mesh/surroundings.h"

#include <algorithm>
#include <unordered_set>

namespace pcl::ccaa {
namespace {

using Edge = TriangleAdjacency::Edge;

/** Cosine between the normals of two sides that face each other. */
constexpr double FACING = -0.5;
/** Cosine of half the angle between them, with room for rounding. */
constexpr double COS_OF_HALF = 0.5 + 1e-9;
/** Rings of triangles around such an edge that may face each other: of 14 pairs of
 * bodies that were glued, with two rings 12 were found, with one 6, with three 13. */
constexpr int RINGS_AT_BOTTOM = 3;
/** Such edges that are looked at in turn, without those in clefts that were found. */
constexpr std::size_t EDGES_IN_TURN = 1024;

/** A triangle's middle and its normal of length 1. */
struct Wall {
  Position center, normal;

  /** Whether both are above each other, and their normals more than 120 degrees apart.
   */
  bool
  faces(const Wall& other) const
  {
    return normal.dot(other.normal) < FACING &&
           (other.center - center).dot(normal) > 0.0 &&
           (center - other.center).dot(other.normal) > 0.0;
  }
};

class CleftFinder {
public:
  CleftFinder(const Triangles& triangles,
              const TriangleAdjacency& adjacency,
              const PointView& points)
  : triangles_(triangles), adjacency_(adjacency), points_(points)
  {}

  /** The corners of all triangles around an edge that face each other there. */
  void
  addCleft(const Edge& edge, std::unordered_set<pcl::index_t>& cleft) const
  {
    Surroundings around({edge.begin(), edge.end()}, triangles_, adjacency_, points_);
    for (int ring = 0; ring < RINGS_AT_BOTTOM; ++ring)
      around.addRing();
    const std::vector<Wall> walls = wallsOf(around.triangles());
    for (const std::size_t i : steepOf(walls))
      for (std::size_t j = 0; j < walls.size(); ++j)
        if (walls[i].faces(walls[j]))
          for (const std::size_t wall : {i, j}) {
            const Triangle& triangle = cornersOfWall(around, wall);
            cleft.insert(triangle.begin(), triangle.end());
          }
  }

private:
  std::vector<Wall>
  wallsOf(const std::vector<pcl::index_t>& triangles) const
  {
    std::vector<Wall> walls;
    walls.reserve(triangles.size());
    for (const pcl::index_t t : triangles) {
      const Corners corners =
          cornersOf(triangles_[static_cast<std::size_t>(t)], points_);
      walls.push_back(
          {(corners[0] + corners[1] + corners[2]) / 3.0, unitNormal(corners)});
    }
    return walls;
  }

  /** Those more than 60 degrees off the mean: of two that face each other one is. */
  static std::vector<std::size_t>
  steepOf(const std::vector<Wall>& walls)
  {
    Position mean = Position::Zero();
    for (const Wall& wall : walls)
      mean += wall.normal;
    mean.normalize();
    std::vector<std::size_t> steep;
    for (std::size_t i = 0; i < walls.size(); ++i)
      if (!(walls[i].normal.dot(mean) > COS_OF_HALF))
        steep.push_back(i);
    return steep;
  }

  const Triangle&
  cornersOfWall(const Surroundings& around, std::size_t wall) const
  {
    return triangles_[static_cast<std::size_t>(around.triangles()[wall])];
  }

  const Triangles& triangles_;
  const TriangleAdjacency& adjacency_;
  PointView points_;
};

} // namespace

std::vector<std::uint8_t>
cleftVertices(const std::vector<Edge>& bottoms,
              const Triangles& triangles,
              const TriangleAdjacency& adjacency,
              const PointView& points,
              const LoopContext& context)
{
  const CleftFinder finder(triangles, adjacency, points);
  LoopContext in_turn = context;
  in_turn.block_size = EDGES_IN_TURN;
  std::vector<std::unordered_set<pcl::index_t>> clefts(
      in_turn.blockCount(bottoms.size()));
  forEachBlock(bottoms.size(),
               in_turn,
               [&](std::size_t block, std::size_t begin, std::size_t end) {
                 auto& cleft = clefts[block];
                 for (std::size_t i = begin; i < end; ++i)
                   if (cleft.count(bottoms[i][0]) + cleft.count(bottoms[i][1]) < 2)
                     finder.addCleft(bottoms[i], cleft);
               });
  std::vector<std::uint8_t> is_cleft(points.size(), 0);
  for (const auto& cleft : clefts)
    for (const pcl::index_t vertex : cleft)
      std::for_each(adjacency.begin(vertex), adjacency.end(vertex), [&](auto t) {
        for (const pcl::index_t corner : triangles[static_cast<std::size_t>(t)])
          is_cleft[static_cast<std::size_t>(corner)] = 1;
      });
  return is_cleft;
}

std::vector<pcl::index_t>
neckVertices(const std::vector<ThinNeck>& thin,
             const std::vector<std::uint8_t>& is_cleft,
             const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const PointView& points,
             int threads)
{
  std::vector<pcl::index_t> vertices;
  std::unordered_set<pcl::index_t> told;
  for (const ThinNeck& neck : thin)
    if (!neck.is_handle) {
      vertices.push_back(neck.vertex);
      told.insert(neck.around.begin(), neck.around.end());
    }
  for (const auto& part : neckParts(triangles, adjacency, points, is_cleft, threads))
    if (std::none_of(part.begin(), part.end(), [&](auto v) { return told.count(v); }))
      vertices.push_back(part.front());
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

} // namespace pcl::ccaa
