// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is done to a force line once it has been traced.

#include "force_line/line_shape.h"

#include "force_line/force_line_tracker.h"
#include "force_line/line_state.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {

void
completeNormals(ForceLine& line, const std::vector<bool>& undetermined)
{
  const std::size_t count = line.points.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (!undetermined[k] || k == 0)
      continue;
    std::size_t after = k;
    while (after < count && undetermined[after])
      ++after;
    if (after == count)
      return; // nothing to interpolate to: the normals carried along stay
    const Direction from = line.normals[k - 1];
    const Direction to = line.normals[after];
    double total = 0.0;
    for (std::size_t i = k; i <= after; ++i)
      total += (line.points[i] - line.points[i - 1]).norm();
    double arc = 0.0;
    for (std::size_t i = k; i < after; ++i) {
      arc += (line.points[i] - line.points[i - 1]).norm();
      const Direction mixed = (1.0 - arc / total) * from + arc / total * to;
      const Direction along = (line.points[i + 1] - line.points[i - 1]).normalized();
      const Direction across = unitAcross(mixed, along);
      if (!across.isZero())
        line.normals[i] = across;
    }
    k = after;
  }
}

double
meanTension(const ForceLine& line)
{
  double sum = 0.0;
  for (std::size_t k = 1; k < line.points.size(); ++k)
    sum += 0.5 * (line.tensions[k - 1] + line.tensions[k]) *
           (line.points[k] - line.points[k - 1]).norm();
  return line.length > 0.0 ? sum / line.length : 0.0;
}

namespace {

/** Unit direction of a line at one of its points: across the chord of its neighbours.
 */
Direction
directionAt(const ForceLine& line, std::size_t k)
{
  const std::size_t before = k == 0 ? 0 : k - 1;
  const std::size_t after = std::min(k + 1, line.points.size() - 1);
  return (line.points[after] - line.points[before]).normalized();
}

/** Cubic through two points with given directions there; share in [0, 1]. */
Position
onCubic(const ForceLine& line, std::size_t k, double share)
{
  const Position& a = line.points[k];
  const Position& b = line.points[k + 1];
  const double chord = (b - a).norm();
  const double t = share;
  const double u = 1.0 - share;
  return u * u * (1.0 + 2.0 * t) * a + t * t * (1.0 + 2.0 * u) * b +
         chord * t * u * (u * directionAt(line, k) - t * directionAt(line, k + 1));
}

} // namespace

void
bringNormalsAcross(ForceLine& line)
{
  for (std::size_t k = 1; k + 1 < line.points.size(); ++k) {
    const Direction across = unitAcross(line.normals[k], directionAt(line, k));
    if (!across.isZero())
      line.normals[k] = across;
  }
}

ForceLine
resampled(const ForceLine& line, double spacing)
{
  if (line.points.size() < 2 || !(spacing > 0.0) || !(line.length > 0.0))
    return line;
  const auto pieces =
      static_cast<std::size_t>(std::max(1.0, std::round(line.length / spacing)));
  ForceLine even = line;
  even.points.assign(1, line.points.front());
  even.normals.assign(1, line.normals.front());
  even.tensions.assign(1, line.tensions.front());
  std::size_t k = 0;
  double arc = 0.0; // at point k
  for (std::size_t i = 1; i < pieces; ++i) {
    const double wanted =
        line.length * static_cast<double>(i) / static_cast<double>(pieces);
    double step = (line.points[k + 1] - line.points[k]).norm();
    while (k + 2 < line.points.size() && arc + step < wanted) {
      arc += step;
      ++k;
      step = (line.points[k + 1] - line.points[k]).norm();
    }
    const double share = std::clamp((wanted - arc) / step, 0.0, 1.0);
    even.points.push_back(onCubic(line, k, share));
    even.normals.push_back((1.0 - share) * line.normals[k] +
                           share * line.normals[k + 1]);
    even.tensions.push_back((1.0 - share) * line.tensions[k] +
                            share * line.tensions[k + 1]);
  }
  even.points.push_back(line.points.back());
  even.normals.push_back(line.normals.back());
  even.tensions.push_back(line.tensions.back());
  bringNormalsAcross(even);
  return even;
}

} // namespace pcl::repair
