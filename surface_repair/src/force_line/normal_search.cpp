// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the normal that a force line has at a point (4.44).

#include "force_line/normal_search.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {

FieldNormal
searchNormal(const Tension& tension, const Direction& across)
{
  const Direction first = across.unitOrthogonal();
  const Direction second = across.cross(first);
  // |H n|^2 for n = cos(phi) first + sin(phi) second has the matrix (a b; b c).
  const Eigen::Vector3d along_first = tension * first;
  const Eigen::Vector3d along_second = tension * second;
  const double a = along_first.squaredNorm();
  const double b = along_first.dot(along_second);
  const double c = along_second.squaredNorm();
  const double mean = 0.5 * (a + c);
  const double half_gap = std::hypot(0.5 * (a - c), b);
  const double phi = 0.5 * std::atan2(b, 0.5 * (a - c));

  FieldNormal found;
  found.normal = std::cos(phi) * first + std::sin(phi) * second;
  found.tension = std::sqrt(mean + half_gap);
  if (found.tension > 0.0)
    found.clearness = 1.0 - std::sqrt(std::max(0.0, mean - half_gap)) / found.tension;
  return found;
}

OriginForce
forceAtOrigin(const Direction& tangent, const Direction& normal, const Tension& tension)
{
  OriginForce origin;
  origin.normal = searchNormal(tension, tangent).normal;
  if (origin.normal.dot(normal) < 0.0)
    origin.normal = -origin.normal;
  origin.force = tension * origin.normal;
  origin.outward = origin.force.dot(tangent.cross(normal));
  return origin;
}

} // namespace pcl::repair
