// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the boundary integral costs on long boundaries.
#include "boundary_times.h"

#include "boundary/boundary_integral.h"
#include "damage/random_numbers.h"
#include "measuring.h"

#include <cmath>
#include <functional>
#include <iomanip>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace bench {
namespace {

using pcl::repair::BoundaryCurve;
using pcl::repair::Position;

/** \brief Where a curve is at an angle; may draw random numbers. */
using Course = std::function<Position(double, app::RandomNumbers&)>;

Position
circle(double angle, app::RandomNumbers&)
{
  return {std::cos(angle), std::sin(angle), 0};
}

Position
wavy(double angle, app::RandomNumbers&)
{
  const double radius = 1 + 0.3 * std::cos(7 * angle) + 0.05 * std::cos(61 * angle);
  return {2 * radius * std::cos(angle),
          radius * std::sin(angle),
          0.3 * std::sin(3 * angle)};
}

Position
jagged(double angle, app::RandomNumbers& random)
{
  const double radius = 1 + 0.05 * (2 * random.uniform() - 1);
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

Position
thick(double angle, app::RandomNumbers& random)
{
  Position position = jagged(angle, random);
  position.z() = 0.05 * (2 * random.uniform() - 1);
  return position;
}

BoundaryCurve
makeCurve(const Course& course, std::size_t count)
{
  app::RandomNumbers random(1);
  BoundaryCurve curve;
  for (std::size_t i = 0; i < count; ++i)
    curve.points.push_back(
        course(2 * M_PI * static_cast<double>(i) / static_cast<double>(count), random));
  curve.normals.assign(count, Position::UnitZ());
  return curve;
}

} // namespace

void
printBoundaryTimes(std::ostream& out)
{
  const std::vector<std::pair<std::string, Course>> courses = {
      {"circle", circle}, {"wavy", wavy}, {"jagged", jagged}, {"jagged, thick", thick}};
  out << "curve               points  farthest s  us/point  integral s\n" << std::fixed;
  for (const auto& [name, course] : courses)
    for (const std::size_t count : {1000, 10000, 100000, 1000000}) {
      const BoundaryCurve curve = makeCurve(course, count);
      const double farthest =
          secondsOf([&] { pcl::repair::farthestPoints(curve.points); });
      const double integral = secondsOf([&] { pcl::repair::boundaryIntegral(curve); });
      out << std::left << std::setw(14) << name << std::right << std::setw(12) << count
          << std::setprecision(4) << std::setw(12) << farthest << std::setprecision(2)
          << std::setw(10) << 1e6 * farthest / static_cast<double>(count)
          << std::setprecision(4) << std::setw(12) << integral << "\n"
          << std::flush;
    }
}

} // namespace bench
