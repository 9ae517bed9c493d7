// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that turns a point cloud into a correct mesh.
#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/point_types.h>

#include "common/cli.h"
#include "common/model_io.h"
#include "common/position_check.h"
#include "common/reconstruct_report.h"
#include "common/reconstruct_run.h"
#include <nlohmann/json.hpp>

#include <cmath>
#include <iostream>

namespace {

namespace po = boost::program_options;

app::Usage
usage()
{
  app::Usage usage;
  usage.program = "pcl_ccaa_reconstruct";
  usage.synopsis = "INPUT_CLOUD OUTPUT_MESH [options]";
  usage.summary =
      R"(Connects the points of a cloud with triangles. Needs no normals and no settings. The
mesh keeps all points of the cloud, in order and with all fields (colours, normals,
intensity, ...); points no triangle could be trusted with stay without triangles.

INPUT_CLOUD   )" +
      std::string(app::cloud_endings) + R"(; of a mesh only the points are read
OUTPUT_MESH   )" +
      app::mesh_output_endings + "; .ply keeps most";
  usage.examples = R"(  pcl_ccaa_reconstruct bunny.pcd bunny.ply
  pcl_ccaa_reconstruct scan.xyz scan.ply --threads 4 --report scan.json
)";
  return usage;
}

app::CommandLine
makeCommandLine()
{
  const pcl::GreedyStart<pcl::PointXYZ> start;
  const pcl::UmbrellaFilter filter;
  const auto neighbors = static_cast<long long>(start.getNumberOfNeighbors());
  const auto internal = static_cast<long long>(filter.getMinimumInternalPoints());
  const auto degrees = [](double angle) {
    return std::round(angle * 18000 / M_PI) / 100;
  };
  const double angle = degrees(start.getMinimumAngle());
  const double certified_angle = degrees(start.getCertifiedMinimumAngle());
  const auto text = [] { return po::value<std::string>(); };
  const auto count = [](long long n) {
    return po::value<long long>()->default_value(n);
  };
  app::CommandLine line(usage());
  auto add = line.addOptions();
  add("until",
      text()->default_value("filter"),
      "last stage: start (raw triangles, some of them wrong, wound in any way) or "
      "filter (correct triangles only)");
  add("threads",
      count(0),
      "number of threads, 0 = all; the result is the same for any");
  add("report", text(), "write figures about the run to this JSON file");
  add("search",
      text()->default_value("fast"),
      "neighbour search: fast, or kdtree (PCL's own)");
  add("neighbors", count(neighbors), "neighbours looked at for each point, 3 to 64");
  add("min-angle",
      app::realValue(angle),
      "smallest angle between two edges at a point, in degrees, 0 to 60");
  add("certified-angle",
      app::realValue(certified_angle),
      "the same for edges that no other point speaks against, in degrees, 0 to 60");
  add("max-length",
      app::realValue(start.getLengthFactor()),
      "longest edge as a multiple of the spacing around it, 1 or more");
  add("plain",
      po::bool_switch(),
      "shortest edges first and --min-angle alone, without asking for each edge "
      "whether "
      "other points speak against it; faults and holes are more");
  add("min-region",
      count(internal),
      "regions with fewer inner points than this are removed; 0 keeps all");
  line.addPositional("INPUT_CLOUD");
  line.addPositional("OUTPUT_MESH");
  return line;
}

app::Status
checkChoices(const app::ReconstructSettings& settings)
{
  if (settings.until == "base")
    return app::Status::error(
        "--until base: this version has only the stages start and filter");
  if (settings.until != "start" && settings.until != "filter")
    return app::Status::error("--until must be start or filter, not '" +
                              settings.until + "'");
  if (settings.search != "fast" && settings.search != "kdtree")
    return app::Status::error("--search must be fast or kdtree, not '" +
                              settings.search + "'");
  return {};
}

app::Status
takeSettings(const app::Arguments& arguments, app::ReconstructSettings& settings)
{
  settings.input = app::takeText(arguments, "INPUT_CLOUD");
  settings.output = app::takeText(arguments, "OUTPUT_MESH");
  settings.report = app::takeText(arguments, "report");
  settings.until = app::takeText(arguments, "until");
  settings.search = app::takeText(arguments, "search");
  settings.plain = arguments["plain"].as<bool>();
  settings.quiet = arguments.count("quiet") != 0;
  app::Status status = checkChoices(settings);
  if (status.ok())
    status = app::takeCount(arguments, "threads", 0, 1024, settings.threads);
  if (status.ok())
    status = app::takeCount(arguments, "neighbors", 3, 64, settings.neighbors);
  if (status.ok())
    status = app::takeCount(
        arguments, "min-region", 0, 1000000000, settings.minimum_internal_points);
  if (status.ok())
    status = app::takeReal(arguments, "min-angle", 0, 60, settings.minimum_angle);
  if (status.ok())
    status = app::takeReal(
        arguments, "certified-angle", 0, 60, settings.certified_minimum_angle);
  if (status.ok())
    status = app::takeReal(arguments, "max-length", 1, 1e6, settings.length_factor);
  return status;
}

/** All that can be known to fail before the work begins. */
app::Status
checkFiles(const app::ReconstructSettings& settings)
{
  app::Status status =
      app::checkDifferentFiles({settings.input, settings.output, settings.report});
  if (status.ok())
    status = app::checkMeshOutput(settings.output);
  if (status.ok() && !settings.report.empty())
    status = app::OutputFile::check(settings.report);
  return status;
}

app::Status
readInput(const app::ReconstructSettings& settings, app::ReconstructResult& result)
{
  app::Status status = app::readCloud(settings.input, result.model);
  if (!status.ok())
    return status;
  const std::size_t usable = app::countUsablePoints(result.model.mesh.cloud, 3);
  if (usable < 3)
    return app::Status::error("'" + settings.input + "' has only " +
                              std::to_string(usable) +
                              " usable points (finite, at different places); at least "
                              "three are needed");
  return {};
}

app::Status
writeOutputs(const app::ReconstructSettings& settings,
             const app::ReconstructResult& result,
             app::Warnings& warnings)
{
  app::OutputFile mesh;
  app::OutputFile report;
  app::Status status = mesh.open(settings.output);
  if (status.ok())
    app::writeMesh(settings.output, result.model.mesh, {}, mesh, warnings);
  if (status.ok() && !settings.report.empty()) {
    status = report.open(settings.report);
    if (status.ok())
      app::writeReport(app::describeRun(settings, result, warnings), report);
  }
  if (status.ok())
    status = mesh.commit();
  if (status.ok() && !settings.report.empty())
    status = report.commit();
  return status;
}

app::Outcome
judge(const app::ReconstructResult& result)
{
  if (result.model.mesh.polygons.empty())
    return {
        app::INCOMPLETE,
        "no triangle could be made that is sure to be right (too few points, or all "
        "on a line?); the output holds the points alone",
        result.model.warnings};
  if (result.filter.one_sided_components > 0)
    return {
        app::INCOMPLETE,
        std::to_string(result.filter.one_sided_components) +
            " regions are one-sided (like a Moebius band) and could not be oriented",
        result.model.warnings};
  return {app::DONE, "", result.model.warnings};
}

app::Outcome
reconstruct(const app::Arguments& arguments)
{
  app::ReconstructSettings settings;
  app::ReconstructResult result;
  app::Status status = takeSettings(arguments, settings);
  if (status.ok())
    status = checkFiles(settings);
  app::ProgressBar bar(settings.quiet);
  bar.show("reading", 0);
  if (status.ok())
    status = readInput(settings, result);
  if (!status.ok())
    return app::Outcome::badInput(status);
  result.memory_before = app::currentMemoryBytes();
  if (bar.show("start", 0))
    app::runStart(settings, bar, result);
  if (settings.until == "filter" && bar.show("filter", 0))
    app::runFilter(settings, bar, result);
  if (!bar.show("writing", 0))
    return {app::INTERRUPTED, "stopped by a signal; nothing was written", {}};
  result.used_points = app::countUsedPoints(result.model.mesh);
  if (result.start.skipped_points > 0)
    result.model.warnings.push_back(
        std::to_string(result.start.skipped_points) +
        " points have coordinates that are not finite; they stay without triangles");
  status = writeOutputs(settings, result, result.model.warnings);
  if (!status.ok())
    return app::Outcome::badInput(status);
  bar.clear();
  if (!settings.quiet)
    std::cout << app::summarizeRun(settings, result) << std::endl;
  return judge(result);
}

} // namespace

int
main(int argc, char** argv)
{
  return app::runApp(makeCommandLine(), argc, argv, reconstruct);
}
