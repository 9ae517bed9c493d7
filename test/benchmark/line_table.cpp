// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how straight force lines between two caps of a sphere run.

#include "line_table.h"

#include "field/source_sampling.h"
#include "force_line/line_origins.h"
#include "measuring.h"

#include <cmath>
#include <iomanip>
#include <ostream>
#include <vector>

namespace bench {

namespace {

using namespace pcl::repair;

constexpr double TWO_PI = 6.28318530717958647692;

/** The rim at height z of the part of the unit sphere above it, or below it. */
BoundaryCurve
sphereRim(double z, bool is_above, std::size_t count)
{
  BoundaryCurve rim;
  const double radius = std::sqrt(1.0 - z * z);
  for (std::size_t k = 0; k < count; ++k) {
    const double angle = (is_above ? TWO_PI : -TWO_PI) * static_cast<double>(k) /
                         static_cast<double>(count);
    rim.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  for (std::size_t k = 0; k < count; ++k)
    rim.normals.push_back((rim.points[k] + rim.points[rim.next(k)]).normalized());
  return rim;
}

struct CapCase {
  std::size_t sources;
  double half_gap;      /**< of a sphere of radius 1 */
  double exponent;      /**< chi */
  double interpolation; /**< k_i */
};

SourceCurve
sampled(const BoundaryCurve& rim, std::size_t island)
{
  SourceCurve curve = sampleSources(rim);
  curve.island = curve.loop = island;
  return curve;
}

void
printRow(std::ostream& out, const CapCase& tried)
{
  // The other rim has another number of vertices, so that none lies opposite one.
  const BoundaryCurve above = sphereRim(tried.half_gap, true, tried.sources);
  const BoundaryCurve below =
      sphereRim(-tried.half_gap, false, tried.sources + tried.sources / 17 + 1);
  const IndicatorField field(gatherSources({sampled(above, 0), sampled(below, 1)}),
                             tried.interpolation);
  const BoundaryEdges targets({{above, 0}, {below, 1}});
  Reach reach;
  reach.exponent = tried.exponent;
  std::vector<LineOrigin> origins;
  for (const PossibleOrigin& origin : originsBetweenIslands(field, targets, reach, {}))
    origins.push_back(origin.origin);
  std::vector<ForceLine> lines;
  const double seconds = secondsOf(
      [&] { lines = ForceLineTracker(field, targets, {}).track(origins, {}); });

  std::size_t arrived = 0;
  double worst = 0.0;
  const double gap = 2.0 * tried.half_gap;
  for (const ForceLine& line : lines) {
    if (line.end != LineEnd::BRIDGE)
      continue;
    ++arrived;
    const Position& end = line.points.back();
    const Position& begin = line.points.front();
    const double turn = std::remainder(
        std::atan2(end.y(), end.x()) - std::atan2(begin.y(), begin.x()), TWO_PI);
    worst = std::max(worst, std::abs(turn) * std::sqrt(1.0 - 0.25 * gap * gap) / gap);
  }
  out << std::setw(8) << tried.sources << std::setw(8) << std::fixed
      << std::setprecision(2) << gap << std::setw(6) << std::setprecision(1)
      << tried.exponent << std::setw(6) << tried.interpolation << std::setw(8)
      << lines.size() << std::setw(10) << arrived << std::setw(14)
      << std::setprecision(3) << 100.0 * worst << std::setw(14) << std::setprecision(1)
      << 1e6 * seconds / static_cast<double>(lines.size()) << "\n";
}

} // namespace

void
printLineTable(std::ostream& out)
{
  out << "force lines between two caps of a unit sphere\n"
      << " sources     gap   chi   k_i   lines   arrived  worst drift %  us a line\n";
  for (const CapCase& tried : {CapCase{60, 0.35, 2.5, 0.0},
                               CapCase{120, 0.35, 2.5, 0.0},
                               CapCase{120, 0.35, 2.5, 1.0},
                               CapCase{120, 0.35, 1.7, 1.0},
                               CapCase{400, 0.35, 2.5, 0.0},
                               CapCase{1600, 0.35, 2.5, 0.0},
                               CapCase{120, 0.1, 2.5, 0.0},
                               CapCase{120, 0.7, 2.5, 0.0}})
    printRow(out, tried);
}

} // namespace bench
