// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: patches that lie in the plane of their rim.

#include "fairing/flat_cap.h"

#include <Eigen/Eigenvalues>

#include "boundary/smooth_conormals.h"
#include "fairing/fairing_system.h"
#include "fairing/joined_surface.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {

namespace {

/** Of the diagonal of the model: smaller rims are those of limbs and of holes: 0.12 on
 * the Bunny, 0.48 at the base of a bust. */
constexpr double LEAST_SIZE = 0.2;
/** Distance from the plane in sizes, root mean square: 0.05 for the hems of clothes. */
constexpr double MOST_RESIDUAL = 0.02;
/** Sine of the angle between surface and plane: 0.45 for the rims of scans. */
constexpr double LEAST_STEEPNESS = 0.8;
/** How far the surface may go beyond the plane, in sizes: 0.02 at a base, while a limb
 * goes on behind its stump. */
constexpr double MOST_BEYOND = 0.06;

double
weightOf(const BoundaryCurve& rim, std::size_t k)
{
  const std::size_t before = k == 0 ? rim.size() - 1 : k - 1;
  return 0.5 * (rim.edge(k).norm() + rim.edge(before).norm());
}

bool
liesOnOneSide(const IncompleteModel& model, std::size_t island, const RimPlane& plane)
{
  const double highest = MOST_BEYOND * plane.size;
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    for (const pcl::index_t corner : model.triangles[t])
      if (model.island_of[t] == island &&
          plane.normal.dot(model.positions[static_cast<std::size_t>(corner)] -
                           plane.center) > highest)
        return false;
  return true;
}

/** Mean of weighted places, and how they are spread around it. */
struct Spread {
  Position center = Position::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
};

Spread
spreadOf(const Positions& points, const std::vector<double>& weights)
{
  Spread spread;
  double sum = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    spread.center += weights[k] * points[k];
    sum += weights[k];
  }
  spread.center /= sum;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Eigen::Vector3d offset = points[k] - spread.center;
    spread.squares += weights[k] / sum * offset * offset.transpose();
  }
  return spread;
}

} // namespace

RimPlane
planeOf(const BoundaryCurve& rim)
{
  RimPlane plane;
  const double length = lengthOf(rim);
  if (!(length > 0.0))
    return plane;
  std::vector<double> weights;
  for (std::size_t k = 0; k < rim.size(); ++k)
    weights.push_back(weightOf(rim, k));
  const Spread spread = spreadOf(rim.points, weights);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread.squares);
  plane.center = spread.center;
  plane.normal = axes.eigenvectors().col(0);
  plane.size = 2.0 * std::sqrt(spread.squares.trace());
  plane.residual = std::sqrt(std::max(axes.eigenvalues()[0], 0.0)) / plane.size;
  const Directions conormals = smoothConormals(rim, 0.0);
  for (std::size_t k = 0; k < rim.size(); ++k)
    plane.steepness += weights[k] / length * plane.normal.dot(conormals[k]);
  if (plane.steepness < 0.0)
    plane.normal = -plane.normal;
  plane.steepness = std::abs(plane.steepness);
  return plane;
}

bool
isBase(const BoundaryCurve& rim, const IncompleteModel& model, pcl::index_t triangle)
{
  const RimPlane plane = planeOf(rim);
  const std::size_t island = model.island_of[static_cast<std::size_t>(triangle)];
  return plane.residual <= MOST_RESIDUAL && plane.steepness >= LEAST_STEEPNESS &&
         plane.size >= LEAST_SIZE * model.islands[island].box.diagonal().norm() &&
         liesOnOneSide(model, island, plane);
}

void
flattenPatch(const IncompleteModel& model, Patch& patch, ccaa::RunControl* control)
{
  const std::size_t rim = patch.rim.size();
  const Positions points(patch.positions.begin(),
                         patch.positions.begin() + static_cast<std::ptrdiff_t>(rim));
  const Spread spread = spreadOf(points, std::vector<double>(rim, 1.0));
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread.squares);
  const Direction normal = axes.eigenvectors().col(0);
  std::vector<double> heights;
  for (const Position& point : points)
    heights.push_back(normal.dot(point - spread.center));
  const std::vector<double> wanted =
      harmonicValues(joinSurface(model, patch, 0), heights, control);
  for (std::size_t v = rim; v < patch.positions.size(); ++v) {
    const double height = normal.dot(patch.positions[v] - spread.center);
    if (!patch.isHeld(v))
      patch.positions[v] += (wanted[v] - height) * normal;
  }
}

} // namespace pcl::repair
