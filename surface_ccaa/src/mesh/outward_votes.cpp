// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what normals, sensor, volume and shape say about the outer
// side of a component.
#include "outward_votes.h"

#include <pcl/surface_ccaa/mesh/corners.h>

#include <cmath>

namespace pcl {
namespace ccaa {
namespace {

/** \brief A facet whose plane passes the centroid of its surface closer than this share
 * of the surface's size bulges neither way: what is left is rounding. */
constexpr double FLATNESS = 1e-4;

/** \brief A triangle as far as the rules need it. */
struct Facet {
  Position centroid;
  Eigen::Vector3d area; /**< normal as long as twice the area, wound as the component */
};

Facet
facetOf(const WoundMesh& mesh, std::size_t index)
{
  const Corners c = cornersOf(mesh.triangles[index], mesh.positions);
  return {(c[0] + c[1] + c[2]) / 3.0, mesh.winding.sign(index) * areaNormal(c)};
}

/** \brief Sum of the directions of the given normals; zero when there is none. */
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

Position
viewpointOf(const OrientationHints& hints, const Triangle& triangle)
{
  const PointView& each = hints.viewpoints;
  if (each.empty())
    return *hints.viewpoint;
  return (each[triangle[0]] + each[triangle[1]] + each[triangle[2]]) / 3.0;
}

/** \brief Solid angle a small facet fills, positive when its front is seen. */
double
solidAngle(const Facet& facet, const Position& viewpoint)
{
  const Eigen::Vector3d sight = viewpoint - facet.centroid;
  const double distance = sight.norm();
  if (!(distance > 0.0))
    return 0.0;
  return 0.5 * facet.area.dot(sight) / (distance * distance * distance);
}

/** \brief Area and first moment, for the centroid of a surface. */
struct SurfaceMoment {
  double area = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();

  void
  add(const Facet& facet)
  {
    const double facet_area = facet.area.norm();
    if (!std::isfinite(facet_area))
      return;
    area += facet_area;
    moment += facet_area * facet.centroid;
  }

  void
  add(const SurfaceMoment& other)
  {
    area += other.area;
    moment += other.moment;
  }
};

} // namespace

std::vector<OutwardEvidence>
collectEvidence(const WoundMesh& mesh,
                const OrientationHints& hints,
                const LoopContext& context)
{
  const bool has_normals = !hints.normals.empty();
  const bool has_viewpoint = !hints.viewpoints.empty() || hints.viewpoint;
  const auto& components = mesh.winding.components();
  ComponentFlags wanted;
  for (const WoundComponent& component : components)
    wanted.push_back(!component.one_sided &&
                     (component.closed || has_normals || has_viewpoint));
  const auto addTriangle = [&](std::size_t component,
                               std::size_t index,
                               OutwardEvidence& sum) {
    const Triangle& triangle = mesh.triangles[index];
    const Facet facet = facetOf(mesh, index);
    if (has_normals)
      sum.normals.add(facet.area.dot(sumOfNormals(hints.normals, triangle)));
    if (has_viewpoint)
      sum.viewpoint.add(solidAngle(facet, viewpointOf(hints, triangle)));
    if (!components[component].closed)
      return;
    const auto first = static_cast<std::size_t>(components[component].first_triangle);
    const Position origin = mesh.positions[mesh.triangles[first][0]];
    sum.volume.add(facet.area.dot(facet.centroid - origin));
    sum.area += facet.area.norm();
  };
  return sumByComponent<OutwardEvidence>(
      mesh.winding, mesh.triangles.size(), wanted, context, addTriangle);
}

std::vector<Votes>
collectBulge(const WoundMesh& mesh,
             const ComponentFlags& wanted,
             const LoopContext& context)
{
  const std::size_t count = mesh.triangles.size();
  const auto moments = sumByComponent<SurfaceMoment>(
      mesh.winding,
      count,
      wanted,
      context,
      [&](std::size_t, std::size_t index, SurfaceMoment& sum) {
        sum.add(facetOf(mesh, index));
      });
  return sumByComponent<Votes>(
      mesh.winding,
      count,
      wanted,
      context,
      [&](std::size_t component, std::size_t index, Votes& sum) {
        const SurfaceMoment& surface = moments[component];
        const Facet facet = facetOf(mesh, index);
        const double vote =
            facet.area.dot(facet.centroid - surface.moment / surface.area);
        const double flat = FLATNESS * facet.area.norm() * std::sqrt(surface.area);
        sum.add(std::abs(vote) > flat ? vote : 0.0);
      });
}

} // namespace ccaa
} // namespace pcl
