// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how often damaged models get their topology back.
#include "topology_table.h"

#include "boundary/extraction.h"
#include "closed_models.h"
#include "lost_parts.h"
#include "measuring.h"
#include "mesh/mesh_facts.h"
#include "repair_trial.h"
#include "rival_hole_filling.h"
#include "rivals.h"
#include "support/mesh_topology.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <array>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <utility>

namespace bench {
namespace {

using namespace pcl::ccaa::test;

constexpr std::array<LossKind, 4> KINDS = {
    LossKind::PATCHES, LossKind::BALLS, LossKind::SLABS3, LossKind::SLABS6};
constexpr std::array<int, 3> PERCENTS = {5, 15, 40};

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

} // namespace bench
