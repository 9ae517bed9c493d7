// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: new vertices spread evenly within the surface of a patch.

#include "fairing/vertex_spacing.h"

#include <Eigen/Geometry>

#include "fairing/vertex_triangles.h"
#include "mesh/corners.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {

namespace {

constexpr double LEAST_TURN = 0.3; /**< cosine between a triangle's normals */
/** Operations for a vertex, and vertices after which they are told. */
constexpr std::size_t VERTEX_WORK = 30;
constexpr std::size_t VERTICES_AT_ONCE = 4096;

class Spacing {
public:
  Spacing(const std::vector<double>& lengths, Patch& patch, bool keeps_shape)
  : lengths_(lengths)
  , patch_(patch)
  , least_turn_(keeps_shape ? ONE_PLANE : LEAST_TURN)
  , around_(patch.triangles, patch.positions.size())
  {}

  void
  moveVertex(std::size_t vertex)
  {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
    double weights = 0.0;
    for (const auto* t = around_.begin(vertex); t != around_.end(vertex); ++t) {
      const ccaa::Corners corners =
          ccaa::cornersOf(patch_.triangles[*t], patch_.positions);
      const Eigen::Vector3d area = ccaa::areaNormal(corners);
      const double weight = area.norm() * density(*t);
      normal += area;
      moment += weight * ((corners[0] + corners[1] + corners[2]) / 3.0);
      weights += weight;
    }
    if (!(weights > 0.0) || !(normal.norm() > 0.0))
      return;
    normal.normalize();
    if (least_turn_ == ONE_PLANE && !liesInPlane(vertex, normal))
      return;
    const Eigen::Vector3d offset = moment / weights - patch_.positions[vertex];
    moveUnlessTurned(vertex, offset - offset.dot(normal) * normal);
  }

private:
  /** Centroids in this density are spaced like the sizing field. */
  double
  density(std::size_t triangle) const
  {
    double length = 0.0;
    for (const pcl::index_t corner : patch_.triangles[triangle])
      length += lengths_[static_cast<std::size_t>(corner)] / 3.0;
    const double relative = length / lengths_[0];
    return 1.0 / (relative * relative * relative * relative);
  }

  bool
  liesInPlane(std::size_t vertex, const Eigen::Vector3d& normal) const
  {
    return std::all_of(around_.begin(vertex), around_.end(vertex), [&](const auto t) {
      return normalOf(t).dot(normal) > ONE_PLANE;
    });
  }

  void
  moveUnlessTurned(std::size_t vertex, const Eigen::Vector3d& step)
  {
    const Position before = patch_.positions[vertex];
    std::vector<Eigen::Vector3d>& normals = normals_;
    normals.clear();
    for (const auto* t = around_.begin(vertex); t != around_.end(vertex); ++t)
      normals.push_back(normalOf(*t));
    patch_.positions[vertex] = before + step;
    std::size_t i = 0;
    for (const auto* t = around_.begin(vertex); t != around_.end(vertex); ++t, ++i)
      if (normalOf(*t).dot(normals[i]) < least_turn_) {
        patch_.positions[vertex] = before;
        return;
      }
  }

  Eigen::Vector3d
  normalOf(std::size_t triangle) const
  {
    return ccaa::unitNormal(
        ccaa::cornersOf(patch_.triangles[triangle], patch_.positions));
  }

  const std::vector<double>& lengths_;
  Patch& patch_;
  double least_turn_;
  VertexTriangles around_;
  std::vector<Eigen::Vector3d> normals_;
};

} // namespace

void
spaceVertices(std::size_t first,
              const std::vector<double>& lengths,
              Patch& patch,
              bool keeps_shape,
              ccaa::RunControl* control)
{
  Spacing spacing(lengths, patch, keeps_shape);
  for (std::size_t vertex = first; vertex < patch.positions.size(); ++vertex) {
    if (!patch.isHeld(vertex))
      spacing.moveVertex(vertex);
    if (vertex % VERTICES_AT_ONCE == 0 &&
        !ccaa::spend(control, VERTICES_AT_ONCE * VERTEX_WORK))
      return;
  }
}

} // namespace pcl::repair
