// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points the camera at an object.
#include "render/camera.h"

#include <Eigen/Geometry>

#include <vtkCamera.h>

#include <algorithm>

namespace app {
namespace {

/** \brief Axes of the picture as rows: right, up, towards the camera. */
Eigen::Matrix3d
pictureAxes(const RenderSettings& settings)
{
  const Eigen::Vector3d back = settings.view.normalized();
  Eigen::Vector3d right = settings.up.cross(back);
  // Looking along the up direction: any other direction will do.
  if (right.norm() < 1e-6 * settings.up.norm())
    right = back.unitOrthogonal();
  Eigen::Matrix3d axes;
  axes.row(0) = right.normalized();
  axes.row(1) = back.cross(axes.row(0).transpose());
  axes.row(2) = back;
  return axes;
}

using pcl::repair::ModelSurvey;

/** \brief A piece of surface or boundary: its outer side, as long as it is large. */
using Weights = std::vector<Eigen::Vector3d>;

/** Mean of the area vectors, over the mean area, from which a surface faces one way. */
constexpr double ONE_SIDED_SHARE = 0.5;

/** How much more has to be seen from a less simple direction. */
constexpr double WORTH_A_CHANGE = 1.03;

Weights
areaWeights(const ModelSurvey& survey)
{
  Weights weights;
  for (const auto& triangle : survey.model.triangles) {
    const auto corner = [&](std::size_t k) {
      return survey.model.positions[static_cast<std::size_t>(triangle[k])];
    };
    weights.emplace_back(
        0.5 * (corner(1) - corner(0)).cross(Eigen::Vector3d(corner(2) - corner(0))));
  }
  return weights;
}

Weights
boundaryWeights(const ModelSurvey& survey)
{
  Weights weights;
  for (const auto& loop : survey.loops)
    for (std::size_t k = 0; k < loop.curve.size(); ++k)
      weights.emplace_back(loop.curve.edge(k).norm() * loop.curve.normals[k]);
  return weights;
}

/** \brief The axes first, then the diagonals of the faces and of the cube. */
std::vector<Eigen::Vector3d>
candidates()
{
  std::vector<Eigen::Vector3d> directions;
  for (int axes = 1; axes <= 3; ++axes)
    for (int code = 0; code < 27; ++code) {
      const Eigen::Vector3d direction(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
      if (std::lround(direction.cwiseAbs().sum()) == axes)
        directions.push_back(direction.normalized());
    }
  return directions;
}

/** \brief How much shows its outer side in a direction. */
double
seenFrom(const Eigen::Vector3d& direction, const Weights& weights)
{
  double seen = 0.0;
  for (const auto& weight : weights)
    seen += std::max(0.0, direction.dot(weight));
  return seen;
}

/** \brief The first candidate from which most is seen, from its opposite too if both
 * are shown. */
Eigen::Vector3d
bestDirection(const Weights& weights, bool both)
{
  Eigen::Vector3d best = Eigen::Vector3d::UnitZ();
  double most = 0.0;
  for (const auto& direction : candidates()) {
    const double seen =
        seenFrom(direction, weights) + (both ? seenFrom(-direction, weights) : 0.0);
    if (seen > most * WORTH_A_CHANGE) {
      best = direction;
      most = seen;
    }
  }
  return best;
}

} // namespace

void
aimCamera(const std::vector<Eigen::Vector3d>& positions,
          const RenderSettings& settings,
          vtkCamera& camera)
{
  const Eigen::Matrix3d axes = pictureAxes(settings);
  Eigen::AlignedBox3d box;
  for (const auto& position : positions)
    box.extend(Eigen::Vector3d(axes * position));
  const Eigen::Vector3d focus =
      settings.focus.value_or(Eigen::Vector3d(axes.transpose() * box.center()));

  const Eigen::Vector3d size = box.sizes();
  const double aspect = static_cast<double>(settings.width) / settings.height;
  const double margin = 1.05;
  double half_height = margin * std::max(size.y(), size.x() / aspect) / 2.0;
  if (half_height <= 0.0) // one point, or a line seen end on
    half_height = std::max(size.z(), 1.0);

  // From any focus inside the box the far side is nearer than its diagonal.
  const double depth = std::max(size.norm(), half_height);
  const Eigen::Vector3d position = focus + 2.0 * depth * axes.row(2).transpose();
  camera.ParallelProjectionOn();
  camera.SetParallelScale(half_height / settings.zoom);
  camera.SetFocalPoint(focus.data());
  camera.SetPosition(position.data());
  camera.SetViewUp(axes(1, 0), axes(1, 1), axes(1, 2));
  camera.SetClippingRange(0.5 * depth, 3.5 * depth);
}

std::vector<Eigen::Vector3d>
chooseViews(const ModelSurvey& survey)
{
  const Weights areas = areaWeights(survey);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double whole = 0.0;
  for (const auto& area : areas) {
    sum += area;
    whole += area.norm();
  }
  if (sum.norm() > ONE_SIDED_SHARE * whole)
    return {bestDirection(areas, false)};
  const Weights boundary = boundaryWeights(survey);
  const Eigen::Vector3d best = bestDirection(boundary.empty() ? areas : boundary, true);
  return {best, -best};
}

Eigen::Vector3d
chooseView(const ModelSurvey& survey)
{
  const std::vector<Eigen::Vector3d> views = chooseViews(survey);
  if (views.size() == 1)
    return views.front();
  const Weights boundary = boundaryWeights(survey);
  return bestDirection(boundary.empty() ? areaWeights(survey) : boundary, false);
}

Eigen::Vector3d
chooseUp(const ModelSurvey& survey, const Eigen::Vector3d& view)
{
  Eigen::AlignedBox3d box;
  for (const auto& island : survey.model.islands)
    box.extend(island.box);
  const bool z_is_taller = box.sizes().z() > box.sizes().y();
  Eigen::Vector3d up =
      z_is_taller ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
  if (std::abs(view.normalized().dot(up)) > 0.9)
    up = z_is_taller ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  return up;
}

} // namespace app
