// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the nearest of many triangles.

#include "fairing/triangle_search.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl::repair {

namespace {

/** Barycentric coordinates of the foot on the plane; false where there is none within
 * the triangle. */
bool
footWithin(const Position& point,
           const ccaa::Corners& triangle,
           Eigen::Vector3d& barycentric)
{
  const Eigen::Vector3d normal = ccaa::areaNormal(triangle);
  const double sqr_area = normal.squaredNorm();
  if (!(sqr_area > 0.0))
    return false;
  for (std::size_t c = 0; c < 3; ++c) {
    const Position& a = triangle[(c + 1) % 3];
    const Position& b = triangle[(c + 2) % 3];
    barycentric[static_cast<Eigen::Index>(c)] =
        (b - a).cross(point - a).dot(normal) / sqr_area;
  }
  return barycentric.minCoeff() >= 0.0;
}

void
tryEdge(const Position& point,
        const ccaa::Corners& triangle,
        std::size_t from,
        TrianglePlace& best)
{
  const std::size_t to = (from + 1) % 3;
  const Eigen::Vector3d along = triangle[to] - triangle[from];
  const double sqr_length = along.squaredNorm();
  const double t =
      sqr_length > 0.0
          ? std::clamp((point - triangle[from]).dot(along) / sqr_length, 0.0, 1.0)
          : 0.0;
  const double distance = (triangle[from] + t * along - point).norm();
  if (!(distance < best.distance))
    return;
  best.distance = distance;
  best.barycentric.setZero();
  best.barycentric[static_cast<Eigen::Index>(from)] = 1.0 - t;
  best.barycentric[static_cast<Eigen::Index>(to)] = t;
}

} // namespace

TrianglePlace
nearestPlace(const Position& point, const ccaa::Corners& triangle)
{
  TrianglePlace place;
  if (footWithin(point, triangle, place.barycentric)) {
    place.distance =
        (place.barycentric[0] * triangle[0] + place.barycentric[1] * triangle[1] +
         place.barycentric[2] * triangle[2] - point)
            .norm();
    return place;
  }
  place.distance = std::numeric_limits<double>::infinity();
  for (std::size_t from = 0; from < 3; ++from)
    tryEdge(point, triangle, from, place);
  return place;
}

TriangleSearch::TriangleSearch(std::vector<ccaa::Corners> triangles)
: triangles_(std::move(triangles))
{
  std::vector<ccaa::Box> boxes;
  boxes.reserve(triangles_.size());
  for (const ccaa::Corners& triangle : triangles_)
    boxes.push_back(ccaa::boxOf(triangle));
  tree_ = ccaa::BoxTree(boxes);
}

TrianglePlace
TriangleSearch::nearest(const Position& point, double reach, const Filter& counts) const
{
  TrianglePlace best;
  best.distance = reach;
  const auto take = [&](std::size_t triangle) {
    if (counts && !counts(triangles_[triangle]))
      return;
    TrianglePlace place = nearestPlace(point, triangles_[triangle]);
    if (place.distance > best.distance ||
        (place.distance == best.distance && triangle > best.triangle))
      return;
    place.triangle = triangle;
    best = place;
  };
  tree_.forEachNear(ccaa::Box(point), reach * reach, [&](pcl::index_t triangle) {
    take(static_cast<std::size_t>(triangle));
    return best.distance * best.distance;
  });
  return best;
}

} // namespace pcl::repair
