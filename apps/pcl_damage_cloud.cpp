// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that damages a cloud or mesh as in thesis 4.8.
#include "common/cli.h"
#include "common/damage_run.h"
#include "common/interrupt.h"
#include "common/model_io.h"
#include "common/point_columns.h"

#include <algorithm>
#include <iostream>

namespace {

namespace po = boost::program_options;

using Texts = std::vector<std::string>;

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

Places are shares of the bounding box (0.5,0.5,0.5 is its middle), radii are shares of
its diagonal; offset and thickness of a slab are shares of the extent along its normal.)";
  usage.examples =
      R"(  pcl_damage_cloud bunny.ply holes.ply --sphere 0.5,0.5,0.8,0.1
  pcl_damage_cloud bunny.ply islands.ply --slabs 5 --slab-size 0.06 --keep 0.05 \
      --noise 0.3 --seed 7 --removed truth.ply --free-points free.pcd
)";
  return usage;
}

void
addRegionOptions(app::CommandLine& line)
{
  const auto list = [] { return po::value<Texts>()->composing(); };
  const auto count = [] { return po::value<long long>()->default_value(0); };
  auto add = line.addOptions();
  add("sphere", list(), "x,y,z,r: take out a sphere (repeatable)");
  add("slab", list(), "nx,ny,nz,offset,thickness: take out a slab (repeatable)");
  add("absolute", "--sphere and --slab are in the units of the cloud");
  add("spheres", count(), "number of spheres around random points");
  add("sphere-size", app::realValue(0.05), "their radius, 0 to 1");
  add("slabs", count(), "number of slabs at random");
  add("slab-size", app::realValue(0.05), "their thickness, 0 to 1");
  add("patches", count(), "number of connected patches of random shape");
  add("patch-size",
      app::realValue(0.02),
      "points in each patch as a share of all points, 0 to 1");
}

app::CommandLine
makeCommandLine()
{
  app::CommandLine line(usage());
  addRegionOptions(line);
  const auto path = [] { return po::value<std::string>(); };
  auto add = line.addOptions();
  add("keep",
      app::realValue(0),
      "share of the points taken out that stays as free points, 0 to 1");
  add("noise",
      app::realValue(0),
      "deviation of the noise on them, in mean distances between neighbours");
  add("seed", po::value<long long>()->default_value(1), "same seed, same damage");
  add("removed", path(), "write what was taken out to this file");
  add("free-points", path(), "write the free points also to a cloud of their own");
  line.addPositional("INPUT");
  line.addPositional("OUTPUT");
  return line;
}

app::Status
takeNumbers(const app::Arguments& arguments, app::DamageSettings& settings)
{
  constexpr long long many = 1000000;
  app::Status status =
      app::takeCount(arguments, "spheres", 0, many, settings.random_spheres);
  if (status.ok())
    status = app::takeCount(arguments, "slabs", 0, many, settings.random_slabs);
  if (status.ok())
    status = app::takeCount(arguments, "patches", 0, many, settings.random_patches);
  if (status.ok())
    status = app::takeCount(arguments, "seed", 0, 4294967295LL, settings.seed);
  if (status.ok())
    status = app::takeReal(arguments, "sphere-size", 0, 1, settings.sphere_size);
  if (status.ok())
    status = app::takeReal(arguments, "slab-size", 0, 1, settings.slab_size);
  if (status.ok())
    status = app::takeReal(arguments, "patch-size", 0, 1, settings.patch_size);
  if (status.ok())
    status = app::takeReal(arguments, "keep", 0, 1, settings.keep);
  if (status.ok())
    status = app::takeReal(arguments, "noise", 0, 1000, settings.noise);
  return status;
}

app::Status
takeSettings(const app::Arguments& arguments, app::DamageSettings& settings)
{
  settings.input = app::takeText(arguments, "INPUT");
  settings.output = app::takeText(arguments, "OUTPUT");
  settings.removed = app::takeText(arguments, "removed");
  settings.free_points = app::takeText(arguments, "free-points");
  settings.absolute = arguments.count("absolute") != 0;
  settings.quiet = arguments.count("quiet") != 0;
  if (arguments.count("sphere") != 0)
    settings.spheres = arguments["sphere"].as<Texts>();
  if (arguments.count("slab") != 0)
    settings.slabs = arguments["slab"].as<Texts>();
  const app::Status status = takeNumbers(arguments, settings);
  if (!status.ok())
    return status;
  const bool has_region = !settings.spheres.empty() || !settings.slabs.empty() ||
                          settings.random_spheres + settings.random_slabs > 0 ||
                          settings.random_patches > 0;
  return has_region
             ? app::Status()
             : app::Status::error("no region to take out: give --sphere, --slab, "
                                  "--spheres, --slabs or --patches (try --help)");
}

app::Status
checkOutput(const std::string& path)
{
  return app::isCloudOutput(path) ? app::checkCloudOutput(path)
                                  : app::checkMeshOutput(path);
}

app::Status
checkFiles(const app::DamageSettings& settings)
{
  app::Status status = app::checkDifferentFiles(
      {settings.input, settings.output, settings.removed, settings.free_points});
  if (status.ok())
    status = checkOutput(settings.output);
  if (status.ok() && !settings.removed.empty())
    status = checkOutput(settings.removed);
  if (status.ok() && !settings.free_points.empty())
    status = app::checkCloudOutput(settings.free_points);
  return status;
}

app::Status
readInput(const app::DamageSettings& settings, app::Model& model)
{
  const app::Status status = app::readModel(settings.input, model);
  if (!status.ok())
    return status;
  if (model.mesh.polygons.empty() && !app::isCloudOutput(settings.output) &&
      !app::holdsFreePoints(settings.output))
    return app::Status::error("'" + settings.output + "' cannot hold points, and '" +
                              settings.input + "' has no triangles");
  const auto points = app::readPositions(model.mesh.cloud);
  const auto finite =
      std::count_if(points.begin(), points.end(), [](const Eigen::Vector3f& point) {
        return point.allFinite();
      });
  if (finite < 3)
    return app::Status::error("'" + settings.input + "' has only " +
                              std::to_string(finite) +
                              " usable points; at least three are needed");
  return {};
}

void
writePart(const std::string& path,
          const pcl::PolygonMesh& part,
          const app::Viewpoint& viewpoint,
          app::OutputFile& file,
          app::Warnings& warnings)
{
  const bool as_cloud = part.polygons.empty() && app::isCloudOutput(path);
  if (!as_cloud && app::isMeshOutput(path)) {
    app::writeMesh(path, part, {}, file, warnings);
    return;
  }
  if (!part.polygons.empty())
    warnings.push_back("'" + path + "' holds points only, not the triangles");
  app::writeCloud(path, part.cloud, viewpoint, file);
}

app::Status
writeParts(const std::vector<app::DamagePart>& parts, app::Model& model)
{
  std::vector<app::OutputFile> files(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const app::Status status = files[i].open(parts[i].path);
    if (!status.ok())
      return status;
    writePart(parts[i].path, parts[i].mesh, model.viewpoint, files[i], model.warnings);
  }
  for (app::OutputFile& file : files) {
    const app::Status status = file.commit();
    if (!status.ok())
      return status;
  }
  return {};
}

app::Outcome
finish(const app::DamageSettings& settings,
       const app::Damage& damage,
       const app::Model& model)
{
  const auto removed = std::count(damage.removed.begin(), damage.removed.end(), 1);
  const auto kept = std::count(damage.kept.begin(), damage.kept.end(), 1);
  if (!settings.quiet)
    std::cout << settings.output << ": of " << damage.removed.size() << " points "
              << removed << " taken out, " << kept << " of them left as free points\n";
  if (removed == 0)
    return {app::INCOMPLETE,
            "no point lies in the regions: the output is the input unchanged",
            model.warnings};
  return {app::DONE, "", model.warnings};
}

app::Outcome
damageModel(const app::Arguments& arguments)
{
  app::DamageSettings settings;
  app::Model model;
  app::Damage damage;
  app::Status status = takeSettings(arguments, settings);
  if (status.ok())
    status = checkFiles(settings);
  if (status.ok())
    status = readInput(settings, model);
  app::RandomNumbers random(settings.seed);
  if (status.ok())
    status = app::planDamage(settings, model.mesh, random, damage);
  if (!status.ok())
    return app::Outcome::badInput(status);
  const auto parts = app::makeParts(settings, damage, random, model.mesh);
  if (app::interrupted())
    return {app::INTERRUPTED, "stopped by a signal; nothing was written", {}};
  status = writeParts(parts, model);
  return status.ok() ? finish(settings, damage, model) : app::Outcome::badInput(status);
}

} // namespace

int
main(int argc, char** argv)
{
  return app::runApp(makeCommandLine(), argc, argv, damageModel);
}
