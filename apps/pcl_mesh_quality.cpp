// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: program that tells all there is to know about a mesh.
#include "cli/cli.h"
#include "cli/file_names.h"
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

namespace app {
namespace {

Usage
usage()
{
  Usage usage;
  usage.program = "pcl_mesh_quality";
  usage.synopsis = "MESH [options]";
  usage.summary =
      R"(Tells whether a mesh is sound: points used, components, boundary loops, edges and points
that are not manifold, winding, genus, degenerate and self-intersecting triangles, angles.
Polygons with more than three corners are looked at as fans of triangles. The exit code
does not judge: it is 0 for a sound and for a broken mesh.

MESH   )" +
      std::string(mesh_endings) + "; '-' reads standard input";
  usage.examples = R"(  pcl_mesh_quality bunny.ply
  pcl_mesh_quality bunny.ply --quiet --report bunny.json
  pcl_repair_holes bunny.ply - | pcl_mesh_quality - --report -
)";
  return usage;
}

struct Settings {
  std::string mesh;
  std::string report;
  bool self_intersections = true;
  unsigned int threads = 0;
  bool quiet = false;
};

void
addOptions(CommandLine& line, Settings& settings)
{
  OptionGroup& options = line.options();
  options.text("report", settings.report)(
      "write the facts to this JSON file, or to standard output (-)",
      "where a program goes on with the figures");
  options.flag("no-self-intersections", settings.self_intersections, false)(
      "do not look for triangles that cross each other, which takes longest",
      "for a quick look at a large mesh");
  options.count("threads", settings.threads, 0, 1024)("number of threads, 0 = all",
                                                      "to leave processors to others");
  line.positional("MESH", settings.mesh);
}

void
saveReport(const Settings& settings,
           const pcl::ccaa::MeshFacts& facts,
           double seconds,
           const Model& model)
{
  nlohmann::json report = describeFacts(facts);
  addRunFacts({"pcl_mesh_quality", settings.mesh, "", DONE, seconds}, model, report);
  report["polygons"] = model.mesh.polygons.size();
  report["warnings"] = model.warnings;
  OutputFile file;
  require(file.open(settings.report));
  writeReport(report, file);
  require(file.commit());
}

SurfaceFacts
surfaceFacts(const pcl::ccaa::MeshFacts& mesh)
{
  SurfaceFacts facts;
  facts.has_triangles = mesh.triangles > 0;
  facts.open = mesh.boundary_loops.size();
  facts.faults = mesh.non_manifold_edges + mesh.non_manifold_vertices +
                 mesh.misoriented_edges + mesh.degenerate_triangles +
                 mesh.invalid_triangles + mesh.non_finite_triangles +
                 mesh.self_intersections.value_or(0);
  facts.pieces = mesh.components;
  return facts;
}

Outcome
measure(const Settings& settings)
{
  checkDifferentFiles({settings.mesh}, {settings.report});
  if (!settings.report.empty())
    require(OutputFile::check(settings.report));
  Model model;
  require(readMesh(settings.mesh, model));
  noteShift(model);
  ProgressBar bar(settings.quiet);
  pcl::ccaa::RunControl control(bar.callback());
  pcl::ccaa::MeshFactsOptions options;
  options.self_intersections = settings.self_intersections;
  options.threads = pcl::ccaa::resolveThreads(settings.threads);
  Stopwatch watch;
  const pcl::ccaa::MeshFacts facts = pcl::ccaa::measureMesh(
      pcl::ccaa::fanTriangles(model.mesh.polygons),
      pcl::ccaa::positionView(model.mesh.cloud).relativeTo(model.shift.offset()),
      options,
      control);
  if (facts.cancelled)
    return {INTERRUPTED, stopped_by_signal, {}};
  const double seconds = watch.lap();
  if (!settings.report.empty())
    saveReport(settings, facts, seconds, model);
  bar.clear();
  std::ostream& people = peopleStream({settings.report});
  if (!settings.quiet)
    people << summaryName(settings.mesh, "standard input") << ": "
           << summarizeFacts(facts) << '\n'
           << tabulateFacts(facts);
  return {DONE, "", model.warnings, {tellSurface(surfaceFacts(facts)), &people}};
}

} // namespace
} // namespace app

int
main(int argc, char** argv)
{
  app::Settings settings;
  app::CommandLine line(app::usage(), settings.quiet);
  app::addOptions(line, settings);
  return app::runApp(line, argc, argv, [&] { return app::measure(settings); });
}
