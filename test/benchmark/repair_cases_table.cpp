// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how many repairs come out right.
#include "repair_cases_table.h"

#include "mesh/mesh_facts.h"
#include "mesh/surface_topology.h"
#include "repair_trial.h"
#include "support/completion_shapes.h"

#include <iomanip>
#include <map>
#include <ostream>
#include <string>

namespace bench {
namespace {

using namespace pcl::ccaa::test;

/** \brief What is wrong with the mesh that came out whatever was to be closed; empty if
 * nothing is. */
std::string
whatGotWorse(const DamagedModel& model, const RepairTrial& trial)
{
  const Shape& result = trial.result;
  if (result.triangles.empty())
    return "no result";
  if (trial.report.origins.size() != result.triangles.size())
    return "report of another mesh";
  std::size_t given = 0;
  for (const pcl::TriangleOrigin origin : trial.report.origins)
    given += origin == pcl::TriangleOrigin::INPUT ? 1 : 0;
  if (given != model.wound.size())
    return "triangles lost";
  pcl::ccaa::RunControl control;
  pcl::ccaa::MeshFactsOptions options;
  options.self_intersections = false;
  const auto facts =
      pcl::ccaa::measureMesh(result.triangles, result.vertices, options, control);
  if (facts.invalid_triangles + facts.non_manifold_edges + facts.non_manifold_vertices >
      0)
    return "no manifold";
  if (facts.orientable && facts.misoriented_edges > 0)
    return "wound in two ways";
  if (!lostPart({{}, model.wound}, result.triangles).triangles.empty())
    return "triangles lost";
  const Shape before = roundedToFloat(model.damaged);
  if (countIntersections(result) > countIntersections(before))
    return "runs through itself";
  return "";
}

/** \brief The first thing that is wrong, empty if it came out right. */
std::string
whatIsWrong(const DamagedModel& model, const RepairTrial& trial)
{
  const std::string worse = whatGotWorse(model, trial);
  if (!worse.empty())
    return worse;
  const Topology found = topologyOf(trial.result.triangles);
  if (found.components != model.whole.components)
    return "components";
  if (found.borders != model.whole.borders)
    return "borders";
  if (found.characteristic != model.whole.characteristic)
    return "characteristic";
  const bool one_sided = trial.report.islands[0].one_sided;
  if (!one_sided && countMissing(model.wound, trial.result.triangles) > 0)
    return "inside out";
  return "";
}

TrialSettings
settingsFor(const DamagedModel& model)
{
  TrialSettings settings;
  settings.free_points = model.free_points;
  return settings;
}

} // namespace

void
printRepairCases(std::ostream& out, std::uint64_t seeds)
{
  std::size_t right = 0;
  std::size_t all = 0;
  std::map<std::string, std::map<std::string, std::size_t>> wrong;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed)
    for (const RepairCase& tried : allRepairCases(seed)) {
      const DamagedModel model = tried.make();
      const std::string problem =
          whatIsWrong(model, runTrial(model.damaged, settingsFor(model)));
      ++all;
      if (problem.empty())
        ++right;
      else
        ++wrong[tried.name][problem];
    }
  out << "cases that come out right: " << right << " of " << all << " (" << std::fixed
      << std::setprecision(1)
      << 100.0 * static_cast<double>(right) / static_cast<double>(all) << " %), "
      << seeds << " seeds\n";
  for (const auto& [name, problems] : wrong)
    for (const auto& [problem, count] : problems)
      out << "  " << std::left << std::setw(32) << name << std::right << std::setw(4)
          << count << "  " << problem << "\n";
}

void
printRepairFuzz(std::ostream& out, std::uint64_t seeds)
{
  std::map<std::string, std::size_t> problems;
  std::size_t shortfalls = 0;
  std::size_t holes = 0;
  double slowest = 0.0;
  std::uint64_t slowest_seed = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const DamagedModel model = randomlyDamaged(seed);
    if (model.wound.empty())
      continue;
    TrialSettings settings = settingsFor(model);
    if (seed % 4 == 0)
      settings.parameters.survey.field.mode = pcl::repair::FieldMode::FULL;
    settings.parameters.refine = seed % 5 != 0;
    const RepairTrial trial = runTrial(model.damaged, settings);
    const std::string problem = whatGotWorse(model, trial);
    if (!problem.empty()) {
      ++problems[problem];
      out << "  seed " << seed << ": " << problem << std::endl;
    }
    shortfalls += trial.report.shortfalls;
    holes += trial.report.holes.size();
    if (trial.seconds > slowest) {
      slowest = trial.seconds;
      slowest_seed = seed;
    }
  }
  out << "random damage, " << seeds << " seeds: ";
  for (const auto& [problem, count] : problems)
    out << count << " x " << problem << ", ";
  out << shortfalls << " of " << holes << " boundaries left open; slowest seed "
      << slowest_seed << " with " << std::fixed << std::setprecision(2) << slowest
      << " s\n";
}

} // namespace bench
