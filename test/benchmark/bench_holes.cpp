// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: filling of holes, ours and others', on seven damaged
// meshes. Nothing passes or fails.
#include <pcl/console/print.h>

#include "boundary/extraction.h"
#include "hole_inputs.h"
#include "mesh/corners.h"
#include "mesh/mesh_facts.h"
#include "mesh_row.h"
#include "repair_trial.h"
#include "rival_hole_filling.h"
#include "rival_vtk_filling.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

namespace bench {
namespace {

bool
touchesItself(const Positions& positions, const std::vector<pcl::index_t>& loop)
{
  std::set<std::array<double, 3>> places;
  for (const pcl::index_t vertex : loop) {
    const auto& p = positions[static_cast<std::size_t>(vertex)];
    places.insert({p.x(), p.y(), p.z()});
  }
  return places.size() < loop.size();
}

/** Each loop by itself, as CGAL closes it. */
Shape
fillByCgal(const Shape& damaged)
{
  const auto model = pcl::repair::test::modelOf(damaged);
  Shape filled{model.positions, model.triangles};
  for (const auto& loop : pcl::repair::extractBoundaries(model)) {
    if (touchesItself(filled.vertices, loop.vertices))
      continue;
    // Ours run along the triangles that are there, the rival's along those to come.
    const HoleFilling filling =
        refineAndFairHole(filled.triangles,
                          filled.vertices,
                          {loop.vertices.rbegin(), loop.vertices.rend()});
    filled.vertices.insert(
        filled.vertices.end(), filling.added.begin(), filling.added.end());
    filled.triangles.insert(
        filled.triangles.end(), filling.triangles.begin(), filling.triangles.end());
  }
  return filled;
}

void
printRow(const HoleInput& input, const std::string& method, const Shape& mesh)
{
  pcl::ccaa::RunControl control;
  const pcl::ccaa::MeshFacts facts =
      measureMesh(mesh.triangles, mesh.vertices, {true, 2}, control);
  const double edge = pcl::ccaa::meanEdge(
      input.truth.triangles, input.truth.triangles.size(), input.truth.vertices);
  std::printf("| %s | %zu | %zu | %s | %zu | %zu | %.3f | %.3f |\n",
              method.c_str(),
              facts.components,
              facts.boundary_loops.size(),
              facts.genus ? std::to_string(*facts.genus).c_str() : "-",
              facts.non_manifold_edges + facts.misoriented_edges,
              facts.self_intersections.value_or(0),
              meanDistance(mesh, input.truth, edge) / 100.0,
              meanDistance(input.truth, mesh, edge) / 100.0);
  std::fflush(stdout);
}

/** What other programs made of FOLDER/NAME.ply is FOLDER/NAME.PROGRAM.ply. */
void
compare(const std::string& folder, const std::string& program)
{
  for (const HoleInput& input : makeHoleInputs()) {
    std::string file = folder + "/" + input.name;
    std::replace(file.begin() + std::ptrdiff_t(folder.size()), file.end(), ' ', '_');
    std::printf("\n## %s: %zu triangles\n\n"
                "| method | pieces | loops | handles | faulty edges | crossings | too "
                "much | missing |\n|---|---|---|---|---|---|---|---|\n",
                input.name.c_str(),
                input.damaged.triangles.size());
    MeshRow row(input.view, input.damaged.vertices, input.damaged.triangles);
    const auto add = [&](const std::string& method, const Shape& mesh) {
      printRow(input, method, mesh);
      row.add(mesh.vertices, mesh.triangles);
    };
    printRow(input, "as it is", input.damaged);
    add("ours", runTrial(input.damaged, {}).result);
    if (hasHoleFilling())
      add("CGAL, each loop", fillByCgal(input.damaged));
    const Shape by_vtk = fillByVtk(input.damaged);
    if (!by_vtk.triangles.empty())
      add("VTK", by_vtk);
    const std::string others = file + "." + program + ".ply";
    if (!program.empty() && std::ifstream(others))
      add(program, readShape(others));
    row.write(file + ".row.ply");
  }
}

void
writeInputs(const std::string& folder)
{
  for (const HoleInput& input : makeHoleInputs()) {
    std::string name = input.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    MeshRow(
        pcl::ccaa::Position::UnitZ(), input.damaged.vertices, input.damaged.triangles)
        .write(folder + "/" + name + ".ply");
  }
}

} // namespace
} // namespace bench

int
main(int argc, char** argv)
{
  const std::string mode = argc > 1 ? argv[1] : "";
  if (argc < 3 || (mode != "write" && mode != "compare")) {
    std::printf("usage: bench_holes write FOLDER\n"
                "       bench_holes compare FOLDER [PROGRAM]\n\n"
                "write: seven damaged meshes, for other programs.\n"
                "compare: a table for each, and the results side by side into FOLDER; "
                "of PROGRAM what it made\nof NAME.ply, as NAME.PROGRAM.ply. Too much "
                "and missing are mean distances in edges: of the\nmesh from the true "
                "surface, and of this from the mesh.\n");
    return argc == 1 ? 0 : 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  try {
    if (mode == "write")
      bench::writeInputs(argv[2]);
    else
      bench::compare(argv[2], argc > 3 ? argv[3] : "");
  }
  catch (const std::exception& problem) {
    std::fprintf(stderr, "bench_holes: %s\n", problem.what());
    return 1;
  }
}
