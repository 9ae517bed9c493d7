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

namespace app {
namespace {

Usage
usage()
{
  Usage usage;
  usage.program = "pcl_damage_cloud";
  usage.synopsis = "INPUT OUTPUT [options]";
  usage.summary =
      R"(Takes regions out of a cloud or mesh, to have something to repair of which the truth
is known. A share of the points taken out can be left in as free points, with noise,
like the sparse samples of a region in the scanner's shade. All other points stay as
they are, in order and with all fields; triangles at a removed point go.

INPUT    )" +
      std::string(cloud_endings) + R"(
OUTPUT   )" +
      mesh_output_endings + " .pcd .xyz" + R"(
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
addRegionOptions(OptionGroup& options, DamageSettings& settings)
{
  constexpr long long many = 1000000;
  options.texts("sphere", settings.spheres)("x,y,z,r: take out a sphere (repeatable)",
                                            "for a hole at a known place");
  options.texts("slab", settings.slabs)(
      "nx,ny,nz,offset,thickness: take out a slab (repeatable)",
      "for a cut at a known place");
  options.flag("absolute",
               settings.absolute)("--sphere and --slab are in the units of the cloud",
                                  "where the place was measured, not guessed");
  options.count("spheres", settings.random_spheres, 0, many)(
      "number of spheres around random points", "for round holes");
  options.real("sphere-size", settings.sphere_size, 0, 1)(
      "their radius, 0 to 1", "to test up to which size a repair is good");
  options.count("slabs", settings.random_slabs, 0, many)("number of slabs at random",
                                                         "to cut a model into islands");
  options.real("slab-size", settings.slab_size, 0, 1)(
      "their thickness, 0 to 1", "to test up to which gap islands are joined");
  options.count("patches", settings.random_patches, 0, many)(
      "number of connected patches of random shape", "for ragged holes, as scans have");
  options.real("patch-size", settings.patch_size, 0, 1)(
      "points in each patch as a share of all points, 0 to 1",
      "to test up to which size a repair is good");
}

bool
usesStandardOutput(const DamageSettings& settings)
{
  return isStandardStream(settings.output) || isStandardStream(settings.removed) ||
         isStandardStream(settings.free_points);
}

void
checkRegions(const DamageSettings& settings)
{
  const bool has_region = !settings.spheres.empty() || !settings.slabs.empty() ||
                          settings.random_spheres + settings.random_slabs > 0 ||
                          settings.random_patches > 0;
  if (!has_region)
    throw Failure("no region to take out: give --sphere, --slab, --spheres, --slabs or "
                  "--patches (try --help)");
}

void
addOptions(CommandLine& line, DamageSettings& settings)
{
  OptionGroup& options = line.options();
  addRegionOptions(options, settings);
  options.real("keep", settings.keep, 0, 1)(
      "share of the points taken out that stays as free points, 0 to 1",
      "to test what sparse samples are worth");
  options.real("noise", settings.noise, 0, 1000)(
      "deviation of the noise on them, in mean distances between neighbours",
      "to test how much noise they may have");
  options.count("seed", settings.seed, 0, 4294967295LL)(
      "same seed, same damage", "to repeat a test on other damage");
  options.text("removed", settings.removed)("write what was taken out to this file",
                                            "to measure a repair against the truth");
  options.text("free-points", settings.free_points)(
      "write the free points also to a cloud of their own",
      "to hand them to --free-points of a repair");
  options.text("report",
               settings.report)("write figures about the run to this JSON file",
                                "where a program goes on with the figures");
  addFormatOption(line,
                  "ply, vtk, obj, off, stl, pcd or xyz",
                  settings.format,
                  [&settings] { return usesStandardOutput(settings); });
  line.positional("INPUT", settings.input);
  line.positional("OUTPUT", settings.output);
  line.then([&settings] { return checkRegions(settings); });
}

void
checkOutput(const Target& target)
{
  require(isCloudOutput(target) ? checkCloudOutput(target) : checkMeshOutput(target));
}

void
checkFiles(const DamageSettings& settings)
{
  const auto target = [&](const std::string& path) {
    return makeTarget(path, settings.format);
  };
  checkDifferentFiles(
      {settings.input},
      {settings.output, settings.removed, settings.free_points, settings.report});
  checkOutput(target(settings.output));
  if (!settings.removed.empty())
    checkOutput(target(settings.removed));
  if (!settings.free_points.empty())
    require(checkCloudOutput(target(settings.free_points)));
  if (!settings.report.empty())
    require(OutputFile::check(settings.report));
}

void
readInput(const DamageSettings& settings, Model& model)
{
  require(readModel(settings.input, model));
  const Target target = makeTarget(settings.output, settings.format);
  if (model.mesh.polygons.empty() && !holdsFreePoints(target))
    throw Failure(nameForPeople(settings.output, "standard output") +
                  " cannot hold points, and " + nameForPeople(settings.input) +
                  " has no triangles");
  const auto points = readPositions(model.mesh.cloud);
  const auto finite =
      std::count_if(points.begin(), points.end(), [](const Eigen::Vector3f& point) {
        return point.allFinite();
      });
  if (finite < 3)
    throw Failure(nameForPeople(settings.input) + " has only " +
                  std::to_string(finite) + " usable; at least three points are needed");
  for (const std::string& output : {settings.output, settings.removed})
    if (!output.empty())
      checkCoordinates(makeTarget(output, settings.format), model);
  noteShift(model);
}

/** Without a name to tell the format, a cloud becomes PCD, which keeps most of it. */
Target
targetOf(const DamagePart& part, FileFormat format)
{
  if (format == FileFormat::UNKNOWN && part.mesh.polygons.empty())
    format = FileFormat::PCD;
  return makeTarget(part.path, format);
}

void
writePart(const Target& target,
          const pcl::PolygonMesh& part,
          Model& model,
          OutputFile& file)
{
  const bool as_cloud = part.polygons.empty() && isCloudOutput(target);
  const FileExtras extras{{}, model.viewpoint, model.remarks};
  if (!as_cloud && isMeshOutput(target)) {
    writeMesh(target, part, extras, file, model.warnings);
    return;
  }
  if (!part.polygons.empty())
    model.warnings.push_back(nameForPeople(target.path, "standard output") +
                             " holds points only, not the triangles");
  writeCloud(target, part.cloud, extras, file);
}

/** \brief What was done, for all who want to know. */
struct Result {
  std::ptrdiff_t removed = 0;
  std::ptrdiff_t kept = 0;
  double seconds = 0;
  Outcome outcome;
};

Result
judge(const Damage& damage, double seconds)
{
  Result result;
  result.removed = std::count(damage.removed.begin(), damage.removed.end(), 1);
  result.kept = std::count(damage.kept.begin(), damage.kept.end(), 1);
  result.seconds = seconds;
  if (result.removed == 0)
    result.outcome = {INCOMPLETE,
                      "no point lies in the regions: the output is the input unchanged",
                      {}};
  return result;
}

nlohmann::json
describe(const DamageSettings& settings,
         const Damage& damage,
         const Model& model,
         const Result& result)
{
  nlohmann::json report = {{"points", damage.removed.size()},
                           {"removed_points", result.removed},
                           {"free_points", result.kept},
                           {"noise", damage.deviation},
                           {"seed", settings.seed},
                           {"warnings", model.warnings}};
  addRunFacts({"pcl_damage_cloud",
               settings.input,
               settings.output,
               result.outcome.code,
               result.seconds},
              model,
              report);
  return report;
}

void
writeFiles(const DamageSettings& settings,
           const Damage& damage,
           const std::vector<DamagePart>& parts,
           const Result& result,
           Model& model)
{
  OutputFolder files;
  for (const DamagePart& part : parts)
    writePart(targetOf(part, settings.format),
              part.mesh,
              model,
              files.addElsewhere(part.path));
  if (!settings.report.empty())
    writeReport(describe(settings, damage, model, result),
                files.addElsewhere(settings.report));
  require(files.commit());
}

std::ostream&
people(const DamageSettings& settings)
{
  return peopleStream(
      {settings.output, settings.removed, settings.free_points, settings.report});
}

void
sumUp(const DamageSettings& settings, const Damage& damage, const Result& result)
{
  people(settings) << summaryName(settings.output) << ": of "
                   << plural(damage.removed.size(), "point") << " " << result.removed
                   << " taken out, " << result.kept << " of them left as free\n";
}

Outcome
damageModel(DamageSettings& settings)
{
  Model model;
  Damage damage;
  checkFiles(settings);
  readInput(settings, model);
  settings.shift = model.shift;
  RandomNumbers random(settings.seed);
  Stopwatch watch;
  planDamage(settings, model.mesh, random, damage);
  const auto parts = makeParts(settings, damage, random, model.mesh);
  Result result = judge(damage, watch.lap());
  if (interrupted())
    return {INTERRUPTED, stopped_by_signal, {}};
  writeFiles(settings, damage, parts, result, model);
  if (!settings.quiet)
    sumUp(settings, damage, result);
  result.outcome.notes = model.warnings;
  result.outcome.verdict = {plural(static_cast<std::size_t>(result.removed), "point") +
                                " taken out",
                            &people(settings)};
  return result.outcome;
}

} // namespace
} // namespace app

int
main(int argc, char** argv)
{
  app::DamageSettings settings;
  app::CommandLine line(app::usage(), settings.quiet);
  app::addOptions(line, settings);
  return app::runApp(line, argc, argv, [&] { return app::damageModel(settings); });
}
