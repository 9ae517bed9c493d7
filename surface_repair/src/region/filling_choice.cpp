// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which filling method closes a hole.

#include "region/filling_choice.h"

#include "filling/avoiding_fans.h"
#include "filling/completion_filling.h"
#include "filling/fan_filling.h"
#include "filling/minimum_weight_filling.h"
#include "filling/ring_stitching.h"
#include "mesh/box_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {

namespace {

/** Share of the points that a patch of the boundary's density would have from which
 * free points are enough to be its vertices. */
constexpr double ENOUGH = 0.4;
/** A free point counts within so much of the size of the patch from it. */
constexpr double DEPTH = 0.25;

/** Triangles that close a hole, as they are. */
std::vector<ccaa::Corners>
cornersOf(const Filling& filling, const BoundaryCurve& polygon)
{
  Positions positions = polygon.points;
  positions.insert(positions.end(), filling.inner.begin(), filling.inner.end());
  return ccaa::cornersOf(filling.triangles, positions);
}

double
areaOf(const std::vector<ccaa::Corners>& triangles)
{
  double area = 0.0;
  for (const ccaa::Corners& corners : triangles)
    area += 0.5 * ccaa::areaNormal(corners).norm();
  return area;
}

/** Whether a filling runs through something, where that is to be looked at. A fan never
 * looks. */
bool
isObstructed(const Filling& filling, const FillingTask& task)
{
  if (!task.obstructed)
    return false;
  const std::vector<ccaa::Corners> triangles = cornersOf(filling, task.polygon);
  return std::any_of(triangles.begin(), triangles.end(), task.obstructed);
}

/** Whether a point lies over the inside of a triangle, within a height. */
bool
liesOver(const Position& point, const ccaa::Corners& corners, double height)
{
  const Eigen::Vector3d normal = ccaa::unitNormal(corners);
  if (std::abs(normal.dot(point - corners[0])) > height)
    return false;
  for (std::size_t c = 0; c < 3; ++c) {
    const Position& from = corners[c];
    const Position& to = corners[(c + 1) % 3];
    if (normal.cross(to - from).dot(point - from) < 0.0)
      return false;
  }
  return true;
}

/** The free points over a filling, ascending. */
std::vector<std::size_t>
freePointsOver(const std::vector<ccaa::Corners>& triangles,
               const FreePointField& free_points)
{
  const double height = DEPTH * std::sqrt(areaOf(triangles));
  ccaa::Box box;
  for (const ccaa::Corners& corners : triangles)
    box.extend(ccaa::boxOf(corners));
  const double radius = 0.5 * box.diagonal().norm() + height;
  std::vector<std::size_t> over;
  for (const pcl::index_t i : free_points.within(box.center(), radius)) {
    const auto point = static_cast<std::size_t>(i);
    if (std::any_of(triangles.begin(), triangles.end(), [&](const auto& corners) {
          return liesOver(free_points.points()[point], corners, height);
        }))
      over.push_back(point);
  }
  return over;
}

/** Vertices inside a patch that is as dense as its border. */
double
usualNumber(const std::vector<ccaa::Corners>& triangles, const BoundaryCurve& polygon)
{
  const double edge = lengthOf(polygon) / static_cast<double>(polygon.size());
  return areaOf(triangles) / (0.5 * std::sqrt(3.0) * edge * edge);
}

Filling
complete(FillingTask& task,
         const std::vector<std::size_t>& chosen,
         const FreePointField& free_points)
{
  for (const std::size_t point : chosen)
    task.free_points.push_back(free_points.points()[point]);
  Filling filling = CompletionFilling().close(task);
  for (std::size_t& point : filling.free_point)
    if (point != NONE)
      point = chosen[point];
  return filling;
}

} // namespace

std::unique_ptr<const FillingMethod>
methodFor(FillingChoice choice)
{
  if (choice == FillingChoice::FAN)
    return std::make_unique<FanFilling>();
  if (choice == FillingChoice::COMPLETION)
    return std::make_unique<CompletionFilling>();
  return std::make_unique<MinimumWeightFilling>();
}

std::size_t
simpleEdges(const FillingParameters& parameters)
{
  return parameters.simple_edges > 0 ? parameters.simple_edges
                                     : methodFor(parameters.choice)->simpleEdges();
}

ChosenFilling
fillHole(FillingTask task, FillingChoice choice, const FreePointField* free_points)
{
  const MinimumWeightFilling basic;
  if (task.second_loop > 0 && !task.obstructed)
    return {stitchRing(task.polygon, task.second_loop), basic.name()};
  if (choice == FillingChoice::FAN) {
    const FanFilling fan;
    Filling made = fan.close(task);
    if (made.closed() && !isObstructed(made, task))
      return {std::move(made), fan.name()};
  }
  Filling made = basic.close(task);
  if (!made.closed() && task.obstructed && task.second_loop == 0) {
    const AvoidingFans fans;
    Filling around = fans.close(task);
    if (around.closed())
      return {std::move(around), fans.name()};
  }
  if (choice == FillingChoice::FAN || choice == FillingChoice::MINIMUM_WEIGHT ||
      free_points == nullptr || !made.closed())
    return {std::move(made), basic.name()};
  const std::vector<ccaa::Corners> triangles = cornersOf(made, task.polygon);
  const std::vector<std::size_t> over = freePointsOver(triangles, *free_points);
  const bool enough =
      static_cast<double>(over.size()) >= ENOUGH * usualNumber(triangles, task.polygon);
  if (over.empty() || (choice == FillingChoice::AUTOMATIC && !enough))
    return {std::move(made), basic.name()};
  Filling completed = complete(task, over, *free_points);
  if (!completed.closed())
    return {std::move(made), basic.name()};
  return {std::move(completed), CompletionFilling().name()};
}

} // namespace pcl::repair
