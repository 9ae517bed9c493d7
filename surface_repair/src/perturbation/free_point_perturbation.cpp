// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: free points pull a traced line to themselves (4.6).

#include "perturbation/free_point_perturbation.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl::repair {

namespace {

/** Poles on a normal line: X' is their mean, weighted by w squared (E4.6-3). */
struct Poles {
  double weights = 0.0;
  double moment = 0.0;

  void
  add(double weight, double place)
  {
    weights += weight * weight;
    moment += weight * weight * place;
  }
  double
  mean() const
  {
    return weights > 0.0 ? moment / weights : 0.0;
  }
};

/** Where a point projects onto the normal line, and how far it is from there. */
struct Projection {
  double place = 0.0;
  double distance = 0.0;
};

Projection
project(const Position& point, const Position& origin, const Direction& normal)
{
  const Eigen::Vector3d offset = point - origin;
  const double place = offset.dot(normal);
  return {place, (offset - place * normal).norm()};
}

/** 0 with slope 0 at x = 0, 1 with slope 0 from x = 1 on. */
double
smoothStep(double x)
{
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

std::vector<double>
arcLengths(const Positions& points)
{
  std::vector<double> arcs(1, 0.0);
  for (std::size_t k = 1; k < points.size(); ++k)
    arcs.push_back(arcs.back() + (points[k] - points[k - 1]).norm());
  return arcs;
}

} // namespace

double
displacementAt(const ForceLine& line,
               std::size_t point,
               const FreePointField& free_points,
               const PerturbationParameters& parameters)
{
  const Falloff& falloff = free_points.falloff();
  const double tension = trustedTension(parameters.trust); // G(0)
  const double height = parameters.half_height * falloff.far;
  const Position& origin = line.points[point];
  const Direction& normal = line.normals[point];
  Poles poles;
  for (const pcl::index_t index :
       free_points.within(origin, std::hypot(falloff.far, height))) {
    const Position& free_point = free_points.points()[static_cast<std::size_t>(index)];
    const Projection pole = project(free_point, origin, normal);
    if (std::abs(pole.place) <= height)
      poles.add(tension * falloff(pole.distance), pole.place); // E4.6-1
  }
  if (!(poles.weights > 0.0))
    return 0.0;
  for (const Position& support : {line.points.front(), line.points.back()}) {
    const Projection pole = project(support, origin, normal);
    poles.add(parameters.support_weight * tension * falloff(pole.distance),
              pole.place); // E4.6-4
  }
  poles.add(parameters.own_weight, 0.0);
  return poles.mean();
}

ForceLine
perturbed(const ForceLine& line,
          const FreePointField& free_points,
          const PerturbationParameters& parameters)
{
  if (line.points.size() < 3 || free_points.points().empty())
    return line;
  const std::vector<double> arcs = arcLengths(line.points);
  const double taper = std::min(free_points.falloff().far, 0.5 * arcs.back());
  ForceLine moved = line;
  for (std::size_t k = 1; k + 1 < line.points.size(); ++k) {
    const double from_end = std::min(arcs[k], arcs.back() - arcs[k]);
    moved.points[k] += smoothStep(from_end / taper) *
                       displacementAt(line, k, free_points, parameters) *
                       line.normals[k];
  }
  bringNormalsAcross(moved);
  moved.length = arcLengths(moved.points).back();
  return moved;
}

} // namespace pcl::repair
