// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what hints say about the side of a triangle.
#include "mesh/given_votes.h"

#include <cmath>

namespace pcl::ccaa {
namespace {

/** Sum of the directions of the given normals; zero when there is none. */
Eigen::Vector3d
sumOfNormals(const PointView& normals, const Triangle& triangle)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const pcl::index_t vertex : triangle) {
    const Eigen::Vector3d normal = normals[vertex];
    const double length = normal.norm();
    if (length > 0.0 && std::isfinite(length))
      sum += normal / length;
  }
  return sum;
}

/** Solid angle a small facet fills, positive when its front is seen. */
double
solidAngle(const Facet& facet, const Position& viewpoint)
{
  const Eigen::Vector3d sight = viewpoint - facet.centroid;
  const double distance = sight.norm();
  if (!(distance > 0.0))
    return 0.0;
  return 0.5 * facet.area.dot(sight) / (distance * distance * distance);
}

} // namespace

void
GivenVotes::add(const Triangle& triangle, const Facet& facet, GivenSides& sides) const
{
  const auto votes = [&](OutwardRule rule) -> SideVotes& {
    return sides[static_cast<std::size_t>(rule)];
  };
  if (hints_.told_viewpoint)
    votes(OutwardRule::TOLD_VIEWPOINT).add(solidAngle(facet, *hints_.told_viewpoint));
  if (hints_.up)
    votes(OutwardRule::UP).add(facet.area.dot(*hints_.up));
  if (!hints_.normals.empty())
    votes(OutwardRule::NORMALS)
        .add(facet.area.dot(sumOfNormals(hints_.normals, triangle)));
  if (has_viewpoint_)
    votes(is_origin_ ? OutwardRule::ORIGIN : OutwardRule::VIEWPOINT)
        .add(solidAngle(facet, viewpointOf(triangle)));
}

Position
GivenVotes::viewpointOf(const Triangle& triangle) const
{
  const PointView& each = hints_.viewpoints;
  if (each.empty())
    return *hints_.viewpoint;
  return (each[triangle[0]] + each[triangle[1]] + each[triangle[2]]) / 3.0;
}

} // namespace pcl::ccaa
