// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that damages a cloud or mesh as in thesis 4.8.
#include "cli/cli.h"
#include "cli/file_names.h"
#include "cli/run_facts.h"
#include "damage/damage_run.h"
#include "io/interrupt.h"
#include "io/model_io.h"
#include "io/output_folder.h"
#include "io/point_columns.h"
#include "io/position_check.h"
#include "io/wording.h"
#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>

namespace {

app::Usage
usage()
{
  app::Usage usage;
  usage.program = "pcl_damage_cloud";
  usage.synopsis = "INPUT OUTPUT [options]";
  usage.summary =
      R"(Takes regions out of a cloud or mesh, to have something to repair of which the truth
is known. A share of the points taken out can be left in as free points, with noise,
like the sparse samples of a region in the scanner's shade. All other points stay as
they are, in order and with all fields; triangles at a removed point go.

INPUT    )" +
      std::string(app::cloud_endings) + R"(
OUTPUT   )" +
      app::mesh_output_endings + " .pcd .xyz" + R"(
'-' stands for standard input (any of these formats, told by the first bytes) and
standard output (PLY, or PCD where there are no triangles, unless --format is given).

Places are shares of the bounding box (0.5,0.5,0.5 is its middle), radii are shares of
its diagonal; offset and thickness of a slab are shares of the extent along its normal.)";
  usage.examples =
      R"(  pcl_damage_cloud bunny.ply holes.ply --sphere 0.5,0.5,0.8,0.1
  pcl_damage_cloud bunny.ply islands.ply --slabs 5 --slab-size 0.06 --keep 0.05 \
      --noise 0.3 --seed 7 --removed truth.ply --free-points free.pcd
  pcl_damage_cloud bunny.ply - --patches 3 | pcl_repair_holes - repaired.ply
)";
  return usage;
}

void
addRegionOptions(app::OptionGroup& options, app::DamageSettings& settings)
{
  constexpr long long many = 1000000;
  options.texts("sphere", settings.spheres, "x,y,z,r: take out a sphere (repeatable)");
  options.texts("slab",
                settings.slabs,
                "nx,ny,nz,offset,thickness: take out a slab (repeatable)");
  options.flag("absolute",
               settings.absolute,
               "--sphere and --slab are in the units of the cloud");
  options.count("spheres",
                settings.random_spheres,
                0,
                many,
                "number of spheres around random points");
  options.real("sphere-size", settings.sphere_size, 0, 1, "their radius, 0 to 1");
  options.count("slabs", settings.random_slabs, 0, many, "number of slabs at random");
  options.real("slab-size", settings.slab_size, 0, 1, "their thickness, 0 to 1");
  options.count("patches",
                settings.random_patches,
                0,
                many,
                "number of connected patches of random shape");
  options.real("patch-size",
               settings.patch_size,
               0,
               1,
               "points in each patch as a share of all points, 0 to 1");
}

bool
usesStandardOutput(const app::DamageSettings& settings)
{
  return app::isStandardStream(settings.output) ||
         app::isStandardStream(settings.removed) ||
         app::isStandardStream(settings.free_points);
}

app::Status
checkRegions(const app::DamageSettings& settings)
{
  const bool has_region = !settings.spheres.empty() || !settings.slabs.empty() ||
                          settings.random_spheres + settings.random_slabs > 0 ||
                          settings.random_patches > 0;
  return has_region
             ? app::Status()
             : app::Status::error("no region to take out: give --sphere, --slab, "
                                  "--spheres, --slabs or --patches (try --help)");
}

void
addOptions(app::CommandLine& line, app::DamageSettings& settings)
{
  app::OptionGroup& options = line.options();
  addRegionOptions(options, settings);
  options.real("keep",
               settings.keep,
               0,
               1,
               "share of the points taken out that stays as free points, 0 to 1");
  options.real("noise",
               settings.noise,
               0,
               1000,
               "deviation of the noise on them, in mean distances between neighbours");
  options.count("seed", settings.seed, 0, 4294967295LL, "same seed, same damage");
  options.text("removed", settings.removed, "write what was taken out to this file");
  options.text("free-points",
               settings.free_points,
               "write the free points also to a cloud of their own");
  options.text(
      "report", settings.report, "write figures about the run to this JSON file");
  app::addFormatOption(line,
                       "ply, vtk, obj, off, stl, pcd or xyz",
                       settings.format,
                       [&settings] { return usesStandardOutput(settings); });
  line.positional("INPUT", settings.input);
  line.positional("OUTPUT", settings.output);
  line.then([&settings] { return checkRegions(settings); });
}

app::Status
checkOutput(const app::Target& target)
{
  return app::isCloudOutput(target) ? app::checkCloudOutput(target)
                                    : app::checkMeshOutput(target);
}

void
checkFiles(const app::DamageSettings& settings)
{
  const auto target = [&](const std::string& path) {
    return app::makeTarget(path, settings.format);
  };
  app::require(app::checkDifferentFiles(
      {settings.input},
      {settings.output, settings.removed, settings.free_points, settings.report}));
  app::require(checkOutput(target(settings.output)));
  if (!settings.removed.empty())
    app::require(checkOutput(target(settings.removed)));
  if (!settings.free_points.empty())
    app::require(app::checkCloudOutput(target(settings.free_points)));
  if (!settings.report.empty())
    app::require(app::OutputFile::check(settings.report));
}

void
readInput(const app::DamageSettings& settings, app::Model& model)
{
  app::require(app::readModel(settings.input, model));
  const app::Target target = app::makeTarget(settings.output, settings.format);
  if (model.mesh.polygons.empty() && !app::holdsFreePoints(target))
    throw app::Failure(app::nameForPeople(settings.output, "standard output") +
                       " cannot hold points, and " +
                       app::nameForPeople(settings.input) + " has no triangles");
  const auto points = app::readPositions(model.mesh.cloud);
  const auto finite =
      std::count_if(points.begin(), points.end(), [](const Eigen::Vector3f& point) {
        return point.allFinite();
      });
  if (finite < 3)
    throw app::Failure(app::nameForPeople(settings.input) + " has only " +
                       std::to_string(finite) +
                       " usable; at least three points are needed");
  for (const std::string& output : {settings.output, settings.removed})
    if (!output.empty())
      app::require(
          app::checkCoordinates(app::makeTarget(output, settings.format), model));
  app::noteShift(model);
}

/** Without a name to tell the format, a cloud becomes PCD, which keeps most of it. */
app::Target
targetOf(const app::DamagePart& part, app::FileFormat format)
{
  if (format == app::FileFormat::UNKNOWN && part.mesh.polygons.empty())
    format = app::FileFormat::PCD;
  return app::makeTarget(part.path, format);
}

void
writePart(const app::Target& target,
          const pcl::PolygonMesh& part,
          app::Model& model,
          app::OutputFile& file)
{
  const bool as_cloud = part.polygons.empty() && app::isCloudOutput(target);
  const app::FileExtras extras{{}, model.viewpoint, model.remarks};
  if (!as_cloud && app::isMeshOutput(target)) {
    app::writeMesh(target, part, extras, file, model.warnings);
    return;
  }
  if (!part.polygons.empty())
    model.warnings.push_back(app::nameForPeople(target.path, "standard output") +
                             " holds points only, not the triangles");
  app::writeCloud(target, part.cloud, extras, file);
}

/** \brief What was done, for all who want to know. */
struct Result {
  std::ptrdiff_t removed = 0;
  std::ptrdiff_t kept = 0;
  double seconds = 0;
  app::Outcome outcome;
};

Result
judge(const app::Damage& damage, double seconds)
{
  Result result;
  result.removed = std::count(damage.removed.begin(), damage.removed.end(), 1);
  result.kept = std::count(damage.kept.begin(), damage.kept.end(), 1);
  result.seconds = seconds;
  if (result.removed == 0)
    result.outcome = {app::INCOMPLETE,
                      "no point lies in the regions: the output is the input unchanged",
                      {}};
  return result;
}

nlohmann::json
describe(const app::DamageSettings& settings,
         const app::Damage& damage,
         const app::Model& model,
         const Result& result)
{
  nlohmann::json report = {{"points", damage.removed.size()},
                           {"removed_points", result.removed},
                           {"free_points", result.kept},
                           {"noise", damage.deviation},
                           {"seed", settings.seed},
                           {"warnings", model.warnings}};
  app::addRunFacts({"pcl_damage_cloud",
                    settings.input,
                    settings.output,
                    result.outcome.code,
                    result.seconds,
                    model.remarks,
                    model.shift},
                   report);
  return report;
}

void
writeFiles(const app::DamageSettings& settings,
           const app::Damage& damage,
           const std::vector<app::DamagePart>& parts,
           const Result& result,
           app::Model& model)
{
  app::OutputFolder files;
  for (const app::DamagePart& part : parts)
    writePart(targetOf(part, settings.format),
              part.mesh,
              model,
              files.addElsewhere(part.path));
  if (!settings.report.empty())
    app::writeReport(describe(settings, damage, model, result),
                     files.addElsewhere(settings.report));
  app::require(files.commit());
}

std::ostream&
people(const app::DamageSettings& settings)
{
  return app::peopleStream(
      {settings.output, settings.removed, settings.free_points, settings.report});
}

void
sumUp(const app::DamageSettings& settings,
      const app::Damage& damage,
      const Result& result)
{
  people(settings) << app::summaryName(settings.output) << ": of "
                   << app::plural(damage.removed.size(), "point") << " "
                   << result.removed << " taken out, " << result.kept
                   << " of them left as free\n";
}

app::Outcome
damageModel(app::DamageSettings& settings)
{
  app::Model model;
  app::Damage damage;
  checkFiles(settings);
  readInput(settings, model);
  settings.shift = model.shift;
  app::RandomNumbers random(settings.seed);
  app::Stopwatch watch;
  app::require(app::planDamage(settings, model.mesh, random, damage));
  const auto parts = app::makeParts(settings, damage, random, model.mesh);
  Result result = judge(damage, watch.lap());
  if (app::interrupted())
    return {app::INTERRUPTED, app::stopped_by_signal, {}};
  writeFiles(settings, damage, parts, result, model);
  if (!settings.quiet)
    sumUp(settings, damage, result);
  result.outcome.notes = model.warnings;
  result.outcome.verdict = {
      app::plural(static_cast<std::size_t>(result.removed), "point") + " taken out",
      &people(settings)};
  return result.outcome;
}

} // namespace

int
main(int argc, char** argv)
{
  app::DamageSettings settings;
  app::CommandLine line(usage(), settings.quiet);
  addOptions(line, settings);
  return app::runApp(line, argc, argv, [&] { return damageModel(settings); });
}
