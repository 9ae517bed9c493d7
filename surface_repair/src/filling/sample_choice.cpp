// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which free points may become vertices of a filling.

#include "filling/sample_choice.h"

#include <pcl/surface_ccaa/impl/point_blocks.h>

#include "filling/local_floats.h"
#include "mesh/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace pcl::repair {

namespace {

/** The distance to the so many-th neighbour tells how isolated a point is. */
constexpr unsigned int NEIGHBOURS = 3;
/** Outliers are more isolated than so many times the median of all free points. */
constexpr float OUTLIER = 4.0F;
/** Height of a spike by the mean distance of the vertices around from their middle. */
constexpr double SPIKE = 0.8;

/** Finite free points at places of their own. */
std::vector<std::size_t>
distinctSamples(const FillingTask& task)
{
  const auto placeOf = [](const Position& p) {
    return std::array<double, 3>{p.x(), p.y(), p.z()};
  };
  std::set<std::array<double, 3>> taken;
  for (const Position& point : task.polygon.points)
    taken.insert(placeOf(point));
  std::vector<std::size_t> distinct;
  for (std::size_t i = 0; i < task.free_points.size(); ++i)
    if (task.free_points[i].allFinite() &&
        taken.insert(placeOf(task.free_points[i])).second)
      distinct.push_back(i);
  return distinct;
}

/** Squared distances of points, from a number on, to their neighbours. */
std::vector<float>
isolationOf(const Positions& points, std::size_t first)
{
  const auto floats = localFloats(points);
  ccaa::PointBlocks blocks;
  blocks.build({floats.front().data(), 3, floats.size()}, 1);
  std::vector<float> isolation;
  for (std::size_t i = first; i < floats.size(); ++i)
    isolation.push_back(blocks.nearest(floats[i], NEIGHBOURS + 1).back().sqr_distance);
  return isolation;
}

/** Height of a point over the plane through others, by their distance from their
 * middle. The others in the order of the fan. */
double
relativeHeight(const Position& point, const Positions& around)
{
  Position middle = Position::Zero();
  for (const Position& other : around)
    middle += other / static_cast<double>(around.size());
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  double size = 0.0;
  for (std::size_t k = 0; k < around.size(); ++k) {
    normal += (around[k] - middle).cross(around[(k + 1) % around.size()] - middle);
    size += (around[k] - middle).norm() / static_cast<double>(around.size());
  }
  return size > 0.0 ? std::abs((point - middle).dot(normal.normalized())) / size : 0.0;
}

} // namespace

std::vector<std::size_t>
usableSamples(const FillingTask& task)
{
  const std::vector<std::size_t> distinct = distinctSamples(task);
  if (distinct.empty())
    return {};
  Positions points = task.polygon.points;
  for (const std::size_t i : distinct)
    points.push_back(task.free_points[i]);
  const std::vector<float> isolation = isolationOf(points, task.polygon.size());
  const float median = ccaa::medianOf(isolation);
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < distinct.size(); ++i)
    if (isolation[i] <= OUTLIER * OUTLIER * median)
      usable.push_back(distinct[i]);
  return usable;
}

std::set<pcl::index_t>
spikesOf(const Triangles& triangles, const Positions& points, std::size_t first)
{
  // Of each inner vertex, which neighbour follows which.
  std::map<pcl::index_t, std::map<pcl::index_t, pcl::index_t>> fans;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (static_cast<std::size_t>(t[i]) >= first)
        fans[t[i]][t[(i + 1) % 3]] = t[(i + 2) % 3];
  std::set<pcl::index_t> spikes;
  for (const auto& [vertex, fan] : fans) {
    Positions around;
    pcl::index_t at = fan.begin()->first;
    for (std::size_t k = 0; k < fan.size(); ++k, at = fan.at(at))
      around.push_back(points[static_cast<std::size_t>(at)]);
    if (relativeHeight(points[static_cast<std::size_t>(vertex)], around) > SPIKE)
      spikes.insert(vertex);
  }
  return spikes;
}

} // namespace pcl::repair
