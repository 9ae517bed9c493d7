// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether a boundary is a jump in depth of one sensor's view.

#include "junction/depth_jump.h"

#include "junction/junction.h"
#include "mesh/quantile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace pcl::repair {

namespace {

/** Edges of the surface around: what lies within less of depth is no jump. */
constexpr double LEAST_JUMP = 4.0;
/** A hole in a surface is seen at the angle at which the surface around it is seen: the
 * cosine is less than this share of that of the rim only where it is none. On the
 * Bunny's scans shadows have at most 0.33. */
constexpr double EDGE_ON = 0.4;

/** Share of the disc around it that a loop takes up in the view of a sensor, from which
 * on the way it runs around says whether it is a hole. */
constexpr double LEAST_OPENING = 0.1;

/** The sensor that has measured all vertices that have one; null where they differ. */
const Position*
onlySensor(const std::vector<pcl::index_t>& vertices, const IncompleteModel& model)
{
  const Position* sensor = nullptr;
  for (const pcl::index_t vertex : vertices) {
    const auto v = static_cast<std::size_t>(vertex);
    if (v >= model.viewpoints.size() || !model.viewpoints[v].allFinite())
      continue;
    if (sensor != nullptr && *sensor != model.viewpoints[v])
      return nullptr;
    sensor = &model.viewpoints[v];
  }
  return sensor;
}

/** The surface around a curve: mean normal, and median length of edges. */
struct Surroundings {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double edge = 0.0;
};

Surroundings
surroundingsOf(const std::vector<pcl::index_t>& vertices, const IncompleteModel& model)
{
  Surroundings around;
  std::vector<double> edges;
  for (const pcl::index_t vertex : vertices) {
    if (static_cast<std::size_t>(vertex) >= model.positions.size())
      continue;
    const SurfaceEnd end = surfaceEndAt(model, vertex);
    around.normal += end.normal;
    edges.push_back(end.edge);
  }
  if (!edges.empty()) {
    around.normal /= static_cast<double>(edges.size());
    around.edge = ccaa::medianOf(std::move(edges));
  }
  return around;
}

Position
centerOf(const BoundaryCurve& curve)
{
  Position center = Position::Zero();
  for (const Position& point : curve.points)
    center += point / static_cast<double>(curve.size());
  return center;
}

} // namespace

FillArea
fillAreaOf(const BoundaryCurve& curve)
{
  FillArea fill;
  const Position center = centerOf(curve);
  for (std::size_t k = 0; k < curve.size(); ++k) // clockwise, seen from outside
    fill.vector -= (curve.points[k] - center).cross(curve.edge(k));
  fill.size = fill.vector.norm();
  return fill;
}

bool
isDepthJump(const FillArea& fill,
            const BoundaryCurve& curve,
            const std::vector<pcl::index_t>& vertices,
            const IncompleteModel& model)
{
  const Position* sensor = onlySensor(vertices, model);
  if (sensor == nullptr || !(fill.size > 0.0))
    return false;
  const Position center = centerOf(curve);
  const Eigen::Vector3d to_sensor = (*sensor - center).normalized();
  const double shown = fill.vector.dot(to_sensor) / fill.size;
  if (shown >= EDGE_ON) // the surface around cannot show more of itself
    return false;
  double nearest = 0.0, furthest = 0.0;
  for (const Position& point : curve.points) {
    const double depth = (center - point).dot(to_sensor);
    nearest = std::min(nearest, depth);
    furthest = std::max(furthest, depth);
  }
  const Surroundings around = surroundingsOf(vertices, model);
  return furthest - nearest > LEAST_JUMP * around.edge &&
         shown < EDGE_ON * around.normal.dot(to_sensor);
}

bool
isOutline(const BoundaryCurve& curve,
          const std::vector<pcl::index_t>& vertices,
          const IncompleteModel& model)
{
  const Position* sensor = onlySensor(vertices, model);
  if (sensor == nullptr)
    return false;
  BoundaryCurve view; // on the unit sphere around the sensor
  for (const Position& point : curve.points)
    view.points.push_back((point - *sensor).normalized());
  const Position center = centerOf(view);
  double radius = 0.0; // squared
  for (const Position& point : view.points)
    radius = std::max(radius, (point - center).squaredNorm());
  const double shown = -fillAreaOf(view).vector.dot(center.normalized());
  return shown < -2.0 * LEAST_OPENING * M_PI * radius;
}

} // namespace pcl::repair
