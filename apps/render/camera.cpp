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

} // namespace app
