// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how often damaged models get their topology back.
#include "topology_table.h"

#include "boundary/extraction.h"
#include "closed_models.h"
#include "damage/random_numbers.h"
#include "lost_parts.h"
#include "measuring.h"
#include "mesh/mesh_facts.h"
#include "mesh_distance.h"
#include "repair_trial.h"
#include "rival_hole_filling.h"
#include "rivals.h"
#include "support/mesh_topology.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <utility>

namespace bench {
namespace {

using namespace pcl::ccaa::test;

/** Of the lost vertices. */
constexpr double FREE_SHARE = 0.05;
/** In median edges. */
constexpr double NOISE = 0.3;
/** The same, where the distance of what was lost is measured. */
constexpr std::array<double, 4> TRUTH_NOISES = {0.0, 0.3, 1.0, 2.0};

constexpr std::array<LossKind, 4> KINDS = {
    LossKind::PATCHES, LossKind::BALLS, LossKind::SLABS3, LossKind::SLABS6};
constexpr std::array<int, 3> PERCENTS = {5, 15, 40};

/** Some of the lost vertices. \param[in] noise of a coordinate, units of the shape */
Positions
freePoints(const LostPart& part, double noise, std::uint64_t seed)
{
  app::RandomNumbers random(seed);
  Positions points;
  for (const auto& position : part.lost_vertices)
    if (random.uniform() < FREE_SHARE)
      points.push_back(position + noise * pcl::ccaa::Position(random.normal(),
                                                              random.normal(),
                                                              random.normal()));
  return points;
}

bool
isRight(const Triangles& triangles, const Positions& positions, const Shape& whole)
{
  pcl::ccaa::RunControl control;
  pcl::ccaa::MeshFactsOptions options;
  options.self_intersections = false;
  const auto facts = pcl::ccaa::measureMesh(triangles, positions, options, control);
  if (triangles.empty() ||
      facts.invalid_triangles + facts.non_manifold_edges + facts.non_manifold_vertices >
          0)
    return false;
  const Topology found = topologyOf(triangles);
  return found.components == 1 && found.borders == 0 &&
         found.characteristic == topologyOf(whole.triangles).characteristic;
}

bool
frontIsRight(const LostPart& part, const Shape& whole)
{
  Cloud cloud;
  for (const auto& p : part.left.vertices)
    cloud.emplace_back(static_cast<float>(p.x()),
                       static_cast<float>(p.y()),
                       static_cast<float>(p.z()));
  return isRight(advancingFront(cloud).triangles, part.left.vertices, whole);
}

/** The rival's fill of a loop; none of one that touches itself, which it does not take.
 */
Triangles
fillOf(const Positions& positions, const std::vector<pcl::index_t>& loop)
{
  std::set<std::array<double, 3>> places;
  for (const pcl::index_t vertex : loop) {
    const auto& p = positions[static_cast<std::size_t>(vertex)];
    places.insert({p.x(), p.y(), p.z()});
  }
  if (loop.size() < 3 || places.size() < loop.size())
    return {};
  if (loop.size() == 3)
    return {{loop[0], loop[2], loop[1]}};
  return triangulateHole(positions, loop).triangles;
}

/** Each loop by itself. */
bool
loopsAreRight(const LostPart& part, const Shape& whole)
{
  const auto model = pcl::repair::test::modelOf(part.left);
  Triangles all = model.triangles;
  for (const auto& loop : pcl::repair::extractBoundaries(model)) {
    const Triangles filling = fillOf(model.positions, loop.vertices);
    all.insert(all.end(), filling.begin(), filling.end());
  }
  return isRight(all, model.positions, whole);
}

struct Counts {
  std::size_t cases = 0, fair = 0;
  std::size_t right = 0, silent = 0, fair_right = 0;
  std::size_t free_right = 0, free_silent = 0;
  std::size_t front = 0, loops = 0;

  void
  add(const Counts& other)
  {
    for (const auto member : {&Counts::cases,
                              &Counts::fair,
                              &Counts::right,
                              &Counts::silent,
                              &Counts::fair_right,
                              &Counts::free_right,
                              &Counts::free_silent,
                              &Counts::front,
                              &Counts::loops})
      this->*member += other.*member;
  }
};

Counts
tryCase(const Shape& whole, const LostPart& part, bool may_be_fair, std::uint64_t seed)
{
  Counts counts;
  counts.cases = 1;
  counts.fair = may_be_fair && !hasLostHandle(part) ? 1 : 0;
  const auto repairs = [&](const Positions& points, bool& is_silent) {
    TrialSettings settings;
    settings.free_points = points;
    const RepairTrial trial = runTrial(part.left, settings);
    const bool is_right = isRight(trial.result.triangles, trial.result.vertices, whole);
    is_silent = !is_right && trial.report.complete();
    return is_right;
  };
  bool is_silent = false;
  counts.right = repairs({}, is_silent) ? 1 : 0;
  counts.silent = is_silent ? 1 : 0;
  counts.fair_right = counts.right * counts.fair;
  counts.free_right = repairs(freePoints(part, 0.0, seed), is_silent) ? 1 : 0;
  counts.free_silent = is_silent ? 1 : 0;
  counts.front = frontIsRight(part, whole) ? 1 : 0;
  counts.loops = loopsAreRight(part, whole) ? 1 : 0;
  return counts;
}

void
printRow(std::ostream& out, const std::string& name, const Counts& counts)
{
  out << "| " << name << " | " << counts.right << " of " << counts.cases << " | "
      << counts.silent << " | " << counts.fair_right << " of " << counts.fair << " | "
      << counts.free_right << " | " << counts.free_silent << " | " << counts.front
      << " | " << counts.loops << " |" << std::endl;
}

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

/** How far the lost vertices are from the surface, with samples of so much noise. */
void
printTruth(std::ostream& out, const LostPart& part)
{
  for (const double noise : TRUTH_NOISES) {
    TrialSettings settings;
    settings.free_points = freePoints(part, noise * part.edge, 1);
    const Shape result = runTrial(part.left, settings).result;
    out << " | " << usualDistance(part.lost_vertices, result) / part.edge;
  }
}

void
printFreePointRow(std::ostream& out,
                  const std::string& name,
                  const LostPart& part,
                  FreePointSums& sums)
{
  TrialSettings settings;
  const double without = runTrial(part.left, settings).seconds;
  std::array<double, 2> far{};
  std::array<double, 2> seconds{};
  for (const std::size_t noisy : {0U, 1U}) {
    settings.free_points = freePoints(part, noisy == 1 ? NOISE * part.edge : 0.0, 1);
    const RepairTrial trial = runTrial(part.left, settings);
    seconds[noisy] = trial.seconds;
    far[noisy] = farDistance(settings.free_points, trial.result) / part.edge;
  }
  ++sums.cases;
  sums.exact += far[0] <= 0.15 ? 1 : 0;
  sums.noisy += far[1] <= 1.5 * NOISE ? 1 : 0;
  sums.without += without;
  sums.with += seconds[0];
  sums.with_noisy += seconds[1];
  out << "| " << name << " | " << settings.free_points.size() << " | " << std::fixed
      << std::setprecision(3) << far[0] << " | " << far[1] / NOISE << " | "
      << std::setprecision(2) << seconds[0] / without << " | " << seconds[1] / without;
  printTruth(out, part);
  out << " |" << std::endl;
}

} // namespace

void
printTopologyTable(std::ostream& out, std::uint64_t seeds)
{
  std::map<std::pair<LossKind, int>, Counts> rows;
  std::map<std::string, Counts> models;
  Counts all;
  for (const std::string& file : closedFiles()) {
    const Shape whole = readShared(file);
    for (std::uint64_t seed = 1; seed <= seeds; ++seed)
      for (const LossKind kind : KINDS)
        for (const int percent : PERCENTS) {
          const LostPart part = lose(whole, kind, 0.01 * percent, seed);
          const Counts counts = tryCase(whole, part, percent <= 15, seed);
          rows[{kind, percent}].add(counts);
          models[file].add(counts);
          all.add(counts);
        }
  }
  out << "| lost | right | silent | fair and right | with free points | silent | "
         "advancing front | each loop |\n|---|---|---|---|---|---|---|---|\n";
  for (const auto& [row, counts] : rows)
    printRow(out,
             std::string(nameOf(row.first)) + " " + std::to_string(row.second) + " %",
             counts);
  for (const auto& [file, counts] : models)
    printRow(out, file.substr(file.find('/') + 1), counts);
  printRow(out, "all", all);
}

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
