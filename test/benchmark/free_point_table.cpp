// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what sparse free points of lost parts do.
#include "free_point_table.h"

#include "lost_parts.h"
#include "mesh_distance.h"
#include "repair_trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <ostream>
#include <string>

namespace bench {
namespace {

/** Of the samples, in median edges: exact, then as of a scanner, then too noisy. */
constexpr std::array<double, 4> NOISES = {0.0, 0.3, 1.0, 2.0};

/** The vertices that hang together with one, of those where a condition holds. */
template <typename Condition>
std::vector<bool>
partAround(const Shape& whole, std::size_t vertex, const Condition& condition)
{
  std::vector<bool> is_in(whole.vertices.size(), false);
  is_in[vertex] = true;
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (const auto& triangle : whole.triangles) {
      const bool touches =
          std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
            return is_in[static_cast<std::size_t>(corner)];
          });
      for (const pcl::index_t corner : triangle) {
        const auto other = static_cast<std::size_t>(corner);
        if (!touches || is_in[other] || !condition(whole.vertices[other]))
          continue;
        is_in[other] = true;
        has_grown = true;
      }
    }
  }
  return is_in;
}

/** Beyond a share of the way from the lowest to the highest vertex along an axis. */
LostPart
withoutLimb(const Shape& whole, int axis, double from)
{
  std::vector<bool> is_used(whole.vertices.size(), false);
  for (const auto& triangle : whole.triangles)
    for (const pcl::index_t corner : triangle)
      is_used[static_cast<std::size_t>(corner)] = true;
  std::size_t highest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v]) {
      least = std::min(least, whole.vertices[v][axis]);
      if (whole.vertices[v][axis] > whole.vertices[highest][axis] || !is_used[highest])
        highest = v;
    }
  const double limit = least + from * (whole.vertices[highest][axis] - least);
  return without(whole, partAround(whole, highest, [&](const auto& p) {
                   return p[axis] > limit;
                 }));
}

/** \return the 95 % distance of points from a surface */
double
farDistance(const Positions& points, const Shape& surface)
{
  const MeshDistance distance(surface.triangles, surface.vertices);
  std::vector<double> distances;
  for (const auto& point : points)
    distances.push_back(distance(point));
  if (distances.empty())
    return 0.0;
  const auto place = distances.begin() +
                     static_cast<std::ptrdiff_t>(0.95 * double(distances.size() - 1));
  std::nth_element(distances.begin(), place, distances.end());
  return *place;
}

/** \return the root mean square distance of points from a surface */
double
usualDistance(const Positions& points, const Shape& surface)
{
  const MeshDistance distance(surface.triangles, surface.vertices);
  double sum = 0.0;
  for (const auto& point : points)
    sum += std::pow(distance(point), 2);
  return points.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(points.size()));
}

struct FreePointSums {
  std::size_t cases = 0, exact = 0, noisy = 0;
  double without = 0, with = 0, with_noisy = 0; /**< seconds */
};

/** \brief What samples of a lost part do. */
struct FreePointRow {
  std::array<double, NOISES.size()> far{},
      truth{}; /**< edges: of samples, of the lost */
  std::array<double, NOISES.size()> seconds{};
};

FreePointRow
tryFreePoints(const LostPart& part)
{
  FreePointRow row;
  for (std::size_t i = 0; i < NOISES.size(); ++i) {
    TrialSettings settings;
    settings.free_points = freePoints(part, NOISES[i] * part.edge, 1);
    const RepairTrial trial = runTrial(part.left, settings);
    row.far[i] = farDistance(settings.free_points, trial.result) / part.edge;
    row.truth[i] = usualDistance(part.lost_vertices, trial.result) / part.edge;
    row.seconds[i] = trial.seconds;
  }
  return row;
}

void
printFreePointRow(std::ostream& out,
                  const std::string& name,
                  const LostPart& part,
                  FreePointSums& sums)
{
  const double without = runTrial(part.left, {}).seconds;
  const FreePointRow row = tryFreePoints(part);
  ++sums.cases;
  sums.exact += row.far[0] <= 0.15 ? 1 : 0;
  sums.noisy += row.far[1] <= 1.5 * NOISES[1] ? 1 : 0;
  sums.without += without;
  sums.with += row.seconds[0];
  sums.with_noisy += row.seconds[1];
  out << "| " << name << " | " << freePoints(part, 0.0, 1).size() << " | " << std::fixed
      << std::setprecision(3) << row.far[0] << " | " << row.far[1] / NOISES[1] << " | "
      << std::setprecision(2) << row.seconds[0] / without << " | "
      << row.seconds[1] / without;
  for (const double truth : row.truth)
    out << " | " << truth;
  out << " |" << std::endl;
}

} // namespace

void
printFreePointTable(std::ostream& out)
{
  out << "| lost | free points | 95 % distance, edges | with noise, sigma | time | "
         "with noise | truth, edges: exact | noise 0.3 | 1 | 2 "
         "|\n|---|---|---|---|---|---|---|---|---|---|\n";
  FreePointSums sums;
  printFreePointRow(out,
                    "bunny's ears",
                    withoutLimb(readShared("bunny/bun_zipper.ply"), 1, 0.73),
                    sums);
  printFreePointRow(out,
                    "woman's arm",
                    withoutLimb(readShared("woman/human_woman.ply"), 0, 0.61),
                    sums);
  for (const char* file : {"fandisk/fandisk_large.ply",
                           "igea/igea.ply",
                           "rocker_arm/rockerArm.ply",
                           "horse/horse.ply",
                           "armadillo/armadillo.ply"}) {
    const std::string path = file;
    const Shape whole = readShared(path);
    for (const LossKind kind : {LossKind::PATCHES, LossKind::SLABS3, LossKind::BALLS})
      for (const int percent : {5, 15})
        printFreePointRow(out,
                          path.substr(path.find('/') + 1) + ", " + nameOf(kind) + " " +
                              std::to_string(percent) + " %",
                          lose(whole, kind, 0.01 * percent, 1),
                          sums);
  }
  out << "| all: at most 0.15 edges, 1.5 sigma | " << sums.cases << " cases | "
      << sums.exact << " | " << sums.noisy << " | " << std::setprecision(2)
      << sums.with / sums.without << " | " << sums.with_noisy / sums.without << " |\n";
}

} // namespace bench
