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

namespace {

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

struct Settings {
  std::string mesh;
  std::string report;
  bool self_intersections = true;
  unsigned int threads = 0;
  bool quiet = false;
};

void
addOptions(app::CommandLine& line, Settings& settings)
{
  app::OptionGroup& options = line.options();
  options.text("report",
               settings.report,
               "write the facts to this JSON file, or to standard output (-)");
  options.flag("no-self-intersections",
               settings.self_intersections,
               "do not look for triangles that cross each other, which takes longest",
               false);
  options.count("threads", settings.threads, 0, 1024, "number of threads, 0 = all");
  line.positional("MESH", settings.mesh);
}

void
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
  app::require(file.open(settings.report));
  app::writeReport(report, file);
  app::require(file.commit());
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
measure(const Settings& settings)
{
  app::require(app::checkDifferentFiles({settings.mesh}, {settings.report}));
  if (!settings.report.empty())
    app::require(app::OutputFile::check(settings.report));
  app::Model model;
  app::require(app::readMesh(settings.mesh, model));
  app::noteShift(model);
  app::ProgressBar bar(settings.quiet);
  pcl::ccaa::RunControl control(bar.callback());
  pcl::ccaa::MeshFactsOptions options;
  options.self_intersections = settings.self_intersections;
  options.threads = pcl::ccaa::resolveThreads(settings.threads);
  app::Stopwatch watch;
  const pcl::ccaa::MeshFacts facts = pcl::ccaa::measureMesh(
      pcl::ccaa::fanTriangles(model.mesh.polygons),
      pcl::ccaa::positionView(model.mesh.cloud).relativeTo(model.shift.offset()),
      options,
      control);
  if (facts.cancelled)
    return {app::INTERRUPTED, app::stopped_by_signal, {}};
  const double seconds = watch.lap();
  if (!settings.report.empty())
    saveReport(settings, facts, seconds, model);
  bar.clear();
  std::ostream& people = app::peopleStream({settings.report});
  if (!settings.quiet)
    people << app::summaryName(settings.mesh, "standard input") << ": "
           << app::summarizeFacts(facts) << '\n'
           << app::tabulateFacts(facts);
  return {
      app::DONE, "", model.warnings, {app::tellSurface(surfaceFacts(facts)), &people}};
}

} // namespace

int
main(int argc, char** argv)
{
  Settings settings;
  app::CommandLine line(usage(), settings.quiet);
  addOptions(line, settings);
  return app::runApp(line, argc, argv, [&] { return measure(settings); });
}
