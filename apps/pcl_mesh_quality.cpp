// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that tells all there is to know about a mesh.
#include "cli/cli.h"
#include "cli/progress.h"
#include "cli/run_facts.h"
#include "io/model_io.h"
#include "io/position_check.h"
#include "mesh/cloud_access.h"
#include "mesh/polygon_access.h"
#include "report/quality_report.h"
#include "report/verdict.h"
#include "run/threads.h"
#include <nlohmann/json.hpp>

#include <ostream>

namespace {

namespace po = boost::program_options;

app::Usage
usage()
{
  app::Usage usage;
  usage.program = "pcl_mesh_quality";
  usage.synopsis = "MESH [options]";
  usage.summary =
      R"(Tells whether a mesh is sound: points used, components, boundary loops, edges and points
that are not manifold, winding, genus, degenerate and self-intersecting triangles, angles.
Polygons with more than three corners are looked at as fans of triangles. The exit code
does not judge: it is 0 for a sound and for a broken mesh.

MESH   )" +
      std::string(app::mesh_endings) + "; '-' reads standard input";
  usage.examples = R"(  pcl_mesh_quality bunny.ply
  pcl_mesh_quality bunny.ply --quiet --report bunny.json
  pcl_repair_holes bunny.ply - | pcl_mesh_quality - --report -
)";
  return usage;
}

app::CommandLine
makeCommandLine()
{
  app::CommandLine line(usage());
  auto add = line.addOptions();
  add("report",
      po::value<std::string>(),
      "write the facts to this JSON file, or to standard output (-)");
  add("no-self-intersections",
      "do not look for triangles that cross each other, which takes longest");
  add("threads",
      po::value<long long>()->default_value(0),
      "number of threads, 0 = all");
  line.addPositional("MESH");
  return line;
}

struct Settings {
  std::string mesh;
  std::string report;
  pcl::ccaa::MeshFactsOptions options;
  bool quiet = false;
};

app::Status
takeSettings(const app::Arguments& arguments, Settings& settings)
{
  settings.mesh = app::takeText(arguments, "MESH");
  settings.report = app::takeText(arguments, "report");
  settings.quiet = arguments.count("quiet") != 0;
  settings.options.self_intersections = arguments.count("no-self-intersections") == 0;
  unsigned int threads = 0;
  app::Status status = app::takeCount(arguments, "threads", 0, 1024, threads);
  settings.options.threads = pcl::ccaa::resolveThreads(threads);
  if (status.ok())
    status = app::checkDifferentFiles({settings.mesh}, {settings.report});
  if (status.ok() && !settings.report.empty())
    status = app::OutputFile::check(settings.report);
  return status;
}

app::Status
saveReport(const Settings& settings,
           const pcl::ccaa::MeshFacts& facts,
           double seconds,
           const app::Model& model)
{
  nlohmann::json report = app::describeFacts(facts);
  app::addRunFacts({"pcl_mesh_quality",
                    settings.mesh,
                    "",
                    app::DONE,
                    seconds,
                    model.remarks,
                    model.shift},
                   report);
  report["polygons"] = model.mesh.polygons.size();
  report["warnings"] = model.warnings;
  app::OutputFile file;
  const app::Status status = file.open(settings.report);
  if (!status.ok())
    return status;
  app::writeReport(report, file);
  return file.commit();
}

app::SurfaceFacts
surfaceFacts(const pcl::ccaa::MeshFacts& mesh)
{
  app::SurfaceFacts facts;
  facts.has_triangles = mesh.triangles > 0;
  facts.open = mesh.boundary_loops.size();
  facts.faults = mesh.non_manifold_edges + mesh.non_manifold_vertices +
                 mesh.misoriented_edges + mesh.degenerate_triangles +
                 mesh.invalid_triangles + mesh.non_finite_triangles +
                 mesh.self_intersections.value_or(0);
  facts.pieces = mesh.components;
  return facts;
}

app::Outcome
measure(const app::Arguments& arguments)
{
  Settings settings;
  app::Model model;
  app::Status status = takeSettings(arguments, settings);
  if (status.ok())
    status = app::readMesh(settings.mesh, model);
  if (!status.ok())
    return app::Outcome::badInput(status);
  app::noteShift(model);
  app::ProgressBar bar(settings.quiet);
  pcl::ccaa::RunControl control(bar.callback());
  app::Stopwatch watch;
  const pcl::ccaa::MeshFacts facts = pcl::ccaa::measureMesh(
      pcl::ccaa::fanTriangles(model.mesh.polygons),
      pcl::ccaa::positionView(model.mesh.cloud).relativeTo(model.shift.offset()),
      settings.options,
      control);
  if (facts.cancelled)
    return {app::INTERRUPTED, app::stopped_by_signal, {}};
  const double seconds = watch.lap();
  if (!settings.report.empty())
    status = saveReport(settings, facts, seconds, model);
  if (!status.ok())
    return app::Outcome::badInput(status);
  bar.clear();
  std::ostream& people = app::peopleStream({settings.report});
  if (!settings.quiet)
    people << (app::isStandardStream(settings.mesh) ? "standard input" : settings.mesh)
           << ": " << app::summarizeFacts(facts) << '\n'
           << app::tabulateFacts(facts);
  return {
      app::DONE, "", model.warnings, {app::tellSurface(surfaceFacts(facts)), &people}};
}

} // namespace

int
main(int argc, char** argv)
{
  return app::runApp(makeCommandLine(), argc, argv, measure);
}
