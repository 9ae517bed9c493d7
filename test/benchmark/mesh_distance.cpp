// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far a mesh is from another one.
#include "mesh_distance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>

namespace bench {
namespace {

using pcl::ccaa::areaNormal;
using pcl::ccaa::Box;
using pcl::ccaa::boxOf;
using pcl::ccaa::Corners;
using pcl::ccaa::cornersOf;
using pcl::ccaa::PointView;
using pcl::ccaa::Position;
using pcl::ccaa::Triangle;
using pcl::ccaa::Triangles;

double
distanceToSegment(const Position& point, const Position& a, const Position& b)
{
  const Position along = b - a;
  const double sqr_length = along.squaredNorm();
  const double t =
      sqr_length > 0 ? std::clamp((point - a).dot(along) / sqr_length, 0.0, 1.0) : 0.0;
  return (a + t * along - point).norm();
}

/** Distances at the three corners and the centroid. */
using FourDistances = std::array<double, 4>;

/** Distances of the points that triangles use; of the others zero. */
std::vector<double>
cornerDistances(const Triangles& triangles,
                const PointView& positions,
                const MeshDistance& distance)
{
  std::vector<char> used(positions.size());
  for (const Triangle& triangle : triangles)
    for (const pcl::index_t corner : triangle)
      used[static_cast<std::size_t>(corner)] = 1;
  std::vector<double> distances(positions.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i] != 0)
      distances[i] = distance(positions[i]);
  return distances;
}

std::vector<FourDistances>
allDistances(const Triangles& triangles,
             const PointView& positions,
             const MeshDistance& distance)
{
  const std::vector<double> of_point = cornerDistances(triangles, positions, distance);
  std::vector<FourDistances> all(triangles.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Corners corners = cornersOf(triangles[i], positions);
    for (std::size_t c = 0; c < 3; ++c)
      all[i][c] = of_point[static_cast<std::size_t>(triangles[i][c])];
    all[i][3] = distance((corners[0] + corners[1] + corners[2]) / 3);
  }
  return all;
}

} // namespace

double
distanceToTriangle(const Position& point, const Corners& triangle)
{
  double distance = std::numeric_limits<double>::infinity();
  const Position normal = areaNormal(triangle);
  bool above = normal.squaredNorm() > 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Position& a = triangle[i];
    const Position& b = triangle[(i + 1) % 3];
    above = above && normal.dot((b - a).cross(point - a)) >= 0;
    distance = std::min(distance, distanceToSegment(point, a, b));
  }
  if (above)
    distance =
        std::min(distance, std::abs(normal.normalized().dot(point - triangle[0])));
  return distance;
}

MeshDistance::MeshDistance(const Triangles& triangles, const PointView& positions)
{
  std::vector<Box> boxes;
  double sizes = 0;
  for (const Triangle& triangle : triangles) {
    corners_.push_back(cornersOf(triangle, positions));
    boxes.push_back(boxOf(corners_.back()));
    sizes += boxes.back().diagonal().norm();
  }
  if (triangles.empty())
    return;
  tree_ = pcl::ccaa::BoxTree(boxes);
  // Half a triangle: most points asked for lie on or next to the surface.
  first_reach_ = std::max(0.5 * sizes / double(triangles.size()),
                          std::numeric_limits<float>::min() * 1.0);
}

double
MeshDistance::nearestWithin(const Position& point, double reach) const
{
  const Position half(reach, reach, reach);
  double nearest = std::numeric_limits<double>::infinity();
  tree_.forEachMeeting(Box(point - half, point + half), [&](pcl::index_t i) {
    nearest = std::min(
        nearest, distanceToTriangle(point, corners_[static_cast<std::size_t>(i)]));
  });
  return nearest;
}

double
MeshDistance::operator()(const Position& point) const
{
  if (corners_.empty())
    return std::numeric_limits<double>::infinity();
  // A box finds all that is nearer than half its width, and some that is farther.
  double reach = first_reach_;
  double nearest = nearestWithin(point, reach);
  while (nearest > reach) {
    reach = std::min(2 * reach, nearest);
    nearest = nearestWithin(point, reach);
  }
  return nearest;
}

Deviation
measureDeviation(const Triangles& triangles,
                 const PointView& positions,
                 const MeshDistance& distance,
                 double limit)
{
  const std::vector<FourDistances> all = allDistances(triangles, positions, distance);
  Deviation deviation;
  double area = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const FourDistances& four = all[i];
    const double weight = 0.5 * areaNormal(cornersOf(triangles[i], positions)).norm();
    const double largest = *std::max_element(four.begin(), four.end());
    area += weight;
    deviation.mean += weight * (four[0] + four[1] + four[2] + four[3]) / 4;
    deviation.largest = std::max(deviation.largest, largest);
    deviation.far_triangles += largest > limit ? 1 : 0;
  }
  if (area > 0)
    deviation.mean /= area;
  return deviation;
}

} // namespace bench
