// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what lies at a place of a picture.
#include "viewer/picking.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <utility>

namespace app {
namespace {

/** A place of the picture that is nearest to the one looked at, and how near. */
struct Nearest {
  double distance = std::numeric_limits<double>::infinity(); /**< pixels */
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
};

void
approach(const Eigen::Vector3d& from,
         const Eigen::Vector3d& to,
         const Eigen::Vector2d& place,
         Nearest& nearest)
{
  const Eigen::Vector3d way = to - from;
  const double length = way.head<2>().squaredNorm();
  const double share =
      length > 0.0
          ? std::clamp((place - from.head<2>()).dot(way.head<2>()) / length, 0.0, 1.0)
          : 0.0;
  const Eigen::Vector3d at = from + share * way;
  const double distance = (place - at.head<2>()).norm();
  if (distance < nearest.distance)
    nearest = {distance, at};
}

Nearest
nearestOf(const PickLine& line,
          const Eigen::Matrix4d& projection,
          const Eigen::Vector2d& place)
{
  Nearest nearest;
  std::optional<Eigen::Vector3d> before;
  const std::size_t count = line.points.size() + (line.closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector4d seen =
        projection * line.points[i % line.points.size()].homogeneous();
    if (seen.w() <= 0.0) {
      before.reset();
      continue;
    }
    const Eigen::Vector3d here = seen.hnormalized();
    approach(before.value_or(here), here, place, nearest);
    before = here;
  }
  return nearest;
}

} // namespace

std::optional<std::size_t>
pickNear(const std::vector<PickLine>& lines,
         const Eigen::Matrix4d& projection,
         const Eigen::Vector2d& place,
         double reach,
         const IsHidden& is_hidden)
{
  std::optional<std::size_t> picked;
  std::pair<bool, double> best;
  for (const PickLine& line : lines) {
    const Nearest nearest = nearestOf(line, projection, place);
    if (nearest.distance > reach)
      continue;
    const std::pair<bool, double> rank(is_hidden(nearest.at), nearest.distance);
    if (!picked || rank < best) {
      picked = line.thing;
      best = rank;
    }
  }
  return picked;
}

} // namespace app
