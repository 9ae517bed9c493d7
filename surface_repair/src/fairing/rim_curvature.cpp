// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how strongly the model is bent where a patch joins it.

#include "fairing/rim_curvature.h"

#include <Eigen/Geometry>

#include "mesh/corners.h"
#include "mesh/quantile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace pcl::repair {

namespace {

/** Integrals over some part of the surface. */
struct BendIntegral {
  double bend = 0.0; /**< of the curvature */
  double area = 0.0;

  void
  add(const BendIntegral& other)
  {
    bend += other.bend;
    area += other.area;
  }
};

Eigen::Vector3d
normalOf(const JoinedSurface& surface, std::size_t triangle)
{
  return ccaa::unitNormal(
      ccaa::cornersOf(surface.triangles[triangle], surface.positions));
}

/** Pairs of the model's triangles that lie against each other: sides 3 t + c. */
std::vector<std::pair<std::size_t, std::size_t>>
modelPairs(const JoinedSurface& surface)
{
  std::vector<std::pair<std::uint64_t, std::size_t>> sides;
  for (std::size_t t = surface.patch_triangles; t < surface.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto a = static_cast<std::uint64_t>(surface.triangles[t][c]);
      const auto b = static_cast<std::uint64_t>(surface.triangles[t][(c + 1) % 3]);
      sides.emplace_back(std::min(a, b) << 32 | std::max(a, b), 3 * t + c);
    }
  std::sort(sides.begin(), sides.end());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].first == sides[i - 1].first)
      pairs.emplace_back(sides[i - 1].second, sides[i].second);
  return pairs;
}

/** Length of the edge times the angle between the normals, above 0 on a bulge. */
double
bendAt(const JoinedSurface& surface, std::size_t side, std::size_t other)
{
  const Triangle& triangle = surface.triangles[side / 3];
  const Position& from =
      surface.positions[static_cast<std::size_t>(triangle[side % 3])];
  const Position& to =
      surface.positions[static_cast<std::size_t>(triangle[(side + 1) % 3])];
  const Eigen::Vector3d edge = to - from;
  const Eigen::Vector3d one = normalOf(surface, side / 3);
  const Eigen::Vector3d two = normalOf(surface, other / 3);
  const double length = edge.norm();
  return length > 0.0
             ? length * std::atan2(one.cross(two).dot(edge) / length, one.dot(two))
             : 0.0;
}

/** A third of the integrals of its triangles at each vertex. */
std::vector<BendIntegral>
vertexIntegrals(const JoinedSurface& surface)
{
  std::vector<BendIntegral> of_triangle(surface.triangles.size());
  for (const auto& [side, other] : modelPairs(surface)) {
    const double bend = bendAt(surface, side, other);
    for (const std::size_t triangle : {side / 3, other / 3}) {
      const Eigen::Vector3d normal = ccaa::areaNormal(
          ccaa::cornersOf(surface.triangles[triangle], surface.positions));
      of_triangle[triangle].add({0.5 * bend, normal.norm() / 6.0});
    }
  }
  std::vector<BendIntegral> integrals(surface.positions.size());
  for (std::size_t t = surface.patch_triangles; t < surface.triangles.size(); ++t)
    for (const pcl::index_t corner : surface.triangles[t])
      integrals[static_cast<std::size_t>(corner)].add(of_triangle[t]);
  return integrals;
}

/** Every vertex takes in what its neighbours in the model have. */
std::vector<BendIntegral>
widened(const JoinedSurface& surface, const std::vector<BendIntegral>& integrals)
{
  std::vector<BendIntegral> wide = integrals;
  for (std::size_t t = surface.patch_triangles; t < surface.triangles.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto a = static_cast<std::size_t>(surface.triangles[t][c]);
      const auto b = static_cast<std::size_t>(surface.triangles[t][(c + 1) % 3]);
      wide[a].add({0.5 * integrals[b].bend, 0.5 * integrals[b].area});
      wide[b].add({0.5 * integrals[a].bend, 0.5 * integrals[a].area});
    }
  return wide;
}

/** Keep the curvatures between 0 and twice their median. A rim that crosses a sharp
 * edge has some that are far from the others and do not go on across the hole; where
 * the median is near 0, as on saddles, none is worth continuing. */
void
limitCurvatures(std::vector<double>& curvatures)
{
  const double median = ccaa::medianOf(curvatures);
  const double low = std::min(0.0, 2.0 * median);
  const double high = std::max(0.0, 2.0 * median);
  for (double& curvature : curvatures)
    curvature = std::clamp(curvature, low, high);
}

} // namespace

std::vector<double>
rimCurvatures(const JoinedSurface& surface, std::size_t rim)
{
  std::vector<BendIntegral> integrals = vertexIntegrals(surface);
  const std::size_t rings = surface.rings.empty() ? 0 : surface.rings.back();
  for (std::size_t ring = 1; ring < rings; ++ring)
    integrals = widened(surface, integrals);
  std::vector<double> curvatures(rim, 0.0);
  for (std::size_t v = 0; v < rim; ++v)
    if (integrals[v].area > 0.0)
      curvatures[v] = integrals[v].bend / integrals[v].area;
  limitCurvatures(curvatures);
  return curvatures;
}

} // namespace pcl::repair
