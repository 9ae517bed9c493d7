// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what normals, sensor, volume and shape say about the outer
// side of a component.
#include "mesh/outward_votes.h"

#include <Eigen/Eigenvalues>

#include "mesh/corners.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl::ccaa {
namespace {

/** \brief A facet whose plane passes the centroid of its surface closer than this share
 * of the surface's size bulges neither way: what is left is rounding. */
constexpr double FLATNESS = 1e-4;

/** \brief Of a surface that follows a plane: least share of the greatest eigenvalue of
 * its normal tensor; 1/3 for a sphere, 1 in the plane. */
constexpr double LEAST_PLANE_SHARE = 0.6;

/** \brief Cosine of 10 degrees: in the frame of a survey the ground lies across an
 * axis, in that of a sensor only by chance. */
constexpr double LEAST_AXIS_COSINE = 0.984807753012208;

/** \brief Most area of a terrain over the area that it covers, both along an axis: 2
 * for the two sides of a plate, or for a floor with a ceiling. */
constexpr double MOST_LAYERS = 1.4;

/** \brief Triangles for each cell of the grid in which that is counted. */
constexpr std::size_t TRIANGLES_IN_CELL = 8;

/** \brief A triangle, wound as its component. */
Facet
facetOf(const WoundMesh& mesh, std::size_t index)
{
  Facet facet = ccaa::facetOf(cornersOf(mesh.triangles[index], mesh.positions));
  facet.area *= mesh.winding.sign(index);
  return facet;
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

/** \brief Sum of area-weighted n n^T over triangles: how their planes lie, whichever
 * way they look. */
struct NormalTensor {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();

  void
  add(const Eigen::Vector3d& area)
  {
    const double size = area.norm();
    if (size > 0.0 && std::isfinite(size))
      sum += area * area.transpose() / size;
  }

  void
  add(const NormalTensor& other)
  {
    sum += other.sum;
  }
};

} // namespace

std::vector<OutwardEvidence>
collectEvidence(const WoundMesh& mesh,
                const OrientationHints& hints,
                const LoopContext& context)
{
  const GivenVotes given(hints);
  const auto& components = mesh.winding.components();
  ComponentFlags wanted;
  for (const WoundComponent& component : components)
    wanted.push_back(!component.one_sided && (component.closed || given.any()));
  const auto addTriangle = [&](std::size_t component,
                               std::size_t index,
                               OutwardEvidence& sum) {
    const Facet facet = facetOf(mesh, index);
    sum.area += facet.area.norm();
    given.add(mesh.triangles[index], facet, sum.given);
    if (given.isOrigin())
      sum.shown += std::abs(facet.area.dot(facet.centroid.normalized()));
    if (!components[component].closed)
      return;
    const auto first = static_cast<std::size_t>(components[component].first_triangle);
    const Position origin = mesh.positions[mesh.triangles[first][0]];
    sum.volume.add(facet.area.dot(facet.centroid - origin));
  };
  return sumByComponent<OutwardEvidence>(
      mesh.winding, mesh.triangles.size(), wanted, context, addTriangle);
}

namespace {

/** \brief Whether a surface lies over itself along an axis, as no terrain does: its
 * area, projected, is well above that of the cells of a grid that its triangles are in.
 */
bool
isLayered(const WoundMesh& mesh, int axis)
{
  const std::size_t count = mesh.triangles.size();
  Eigen::AlignedBox3d box;
  double doubled_area = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Facet facet = facetOf(mesh, i);
    box.extend(facet.centroid);
    doubled_area += std::abs(facet.area[axis]);
  }
  const auto side = static_cast<std::size_t>(
      std::sqrt(static_cast<double>(count / TRIANGLES_IN_CELL)) + 1.0);
  const std::array<int, 2> axes = {(axis + 1) % 3, (axis + 2) % 3};
  const auto cellOf = [&](const Position& place, int along) {
    const double share = (place[along] - box.min()[along]) / box.sizes()[along];
    return std::min(side - 1,
                    static_cast<std::size_t>(share * static_cast<double>(side)));
  };
  const double covered = box.sizes()[axes[0]] * box.sizes()[axes[1]];
  if (!(covered > 0.0))
    return false;
  std::vector<bool> taken(side * side, false);
  for (std::size_t i = 0; i < count; ++i) {
    const Position place = facetOf(mesh, i).centroid;
    taken[cellOf(place, axes[0]) * side + cellOf(place, axes[1])] = true;
  }
  const auto cells = std::count(taken.begin(), taken.end(), true);
  const double cell_area = covered / static_cast<double>(side * side);
  return 0.5 * doubled_area > MOST_LAYERS * cell_area * static_cast<double>(cells);
}

} // namespace

int
axisOfPlane(const Eigen::Matrix3d& tensor, Eigen::Vector3d& normal)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
  normal = solver.eigenvectors().col(2);
  Eigen::Index axis = 0;
  const double along = normal.cwiseAbs().maxCoeff(&axis);
  const bool is_plane = tensor.trace() > 0.0 && along >= LEAST_AXIS_COSINE &&
                        solver.eigenvalues()[2] >= LEAST_PLANE_SHARE * tensor.trace();
  return is_plane ? static_cast<int>(axis) : -1;
}

std::vector<SideVotes>
collectPlane(const WoundMesh& mesh, const LoopContext& context, int& axis)
{
  const std::size_t count = mesh.triangles.size();
  const ComponentFlags all(mesh.winding.components().size(), 1);
  NormalTensor tensor;
  for (const NormalTensor& part : sumByComponent<NormalTensor>(
           mesh.winding,
           count,
           all,
           context,
           [&](std::size_t, std::size_t index, NormalTensor&sum) {
             sum.add(facetOf(mesh, index).area);
           }))
    tensor.add(part);
  Eigen::Vector3d up;
  axis = axisOfPlane(tensor.sum, up);
  if (axis < 0 || isLayered(mesh, axis))
    return std::vector<SideVotes>(all.size());
  if (up[axis] < 0.0)
    up = -up;
  std::vector<SideVotes> votes =
      sumByComponent<SideVotes>(mesh.winding,
                                count,
                                all,
                                context,
                                [&](std::size_t, std::size_t index, SideVotes& sum) {
                                  sum.add(facetOf(mesh, index).area.dot(up));
                                });
  for (SideVotes& of_component : votes)
    if (of_component.margin() < LEAST_TERRAIN_MARGIN)
      of_component = {};
  return votes;
}

std::vector<SideVotes>
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
  return sumByComponent<SideVotes>(
      mesh.winding,
      count,
      wanted,
      context,
      [&](std::size_t component, std::size_t index, SideVotes& sum) {
        const SurfaceMoment& surface = moments[component];
        const Facet facet = facetOf(mesh, index);
        const double vote =
            facet.area.dot(facet.centroid - surface.moment / surface.area);
        const double flat = FLATNESS * facet.area.norm() * std::sqrt(surface.area);
        sum.add(std::abs(vote) > flat ? vote : 0.0);
      });
}

} // namespace pcl::ccaa
