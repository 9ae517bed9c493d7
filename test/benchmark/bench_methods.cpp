// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which method when: ours and others on ten kinds of clouds.
// Nothing passes or fails.
#include <pcl/console/print.h>

#include "free_methods.h"
#include "mesh/mesh_facts.h"
#include "mesh_distance.h"
#include "mesh_row.h"
#include "rivals.h"
#include "run/run_control.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <limits>
#include <set>
#include <string>

namespace bench {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::Positions;
namespace test = pcl::ccaa::test;

/** Share of the points of the cloud that are corners of triangles. */
double
usedShare(const MethodInput& input, const FreeMesh& mesh)
{
  const auto less = [](const Position& a, const Position& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::set<Position, decltype(less)> corners(less);
  for (const pcl::ccaa::Triangle& triangle : mesh.triangles)
    for (const pcl::index_t corner : triangle)
      corners.insert(mesh.positions[static_cast<std::size_t>(corner)]);
  std::size_t used = 0;
  for (const pcl::PointXYZ& point : *input.cloud)
    used += corners.count(point.getVector3fMap().cast<double>());
  return double(used) / double(input.cloud->size());
}

/** Mean distance in spacings of one mesh from another. */
double
meanDistance(const test::Shape& from, const test::Shape& to, double spacing)
{
  if (from.triangles.empty() || to.triangles.empty())
    return std::numeric_limits<double>::quiet_NaN();
  const MeshDistance distance(to.triangles, to.vertices);
  return measureDeviation(from.triangles,
                          from.vertices,
                          distance,
                          std::numeric_limits<double>::infinity())
             .mean /
         spacing;
}

void
printRow(const MethodInput& input, const FreeMethod& method, const FreeMesh& mesh)
{
  pcl::ccaa::RunControl control;
  const pcl::ccaa::MeshFacts facts =
      measureMesh(mesh.triangles, mesh.positions, {true, 2}, control);
  const double spacing = spacingOf(input.cloud);
  const test::Shape made{mesh.positions, mesh.triangles};
  const test::Shape& wanted = input.seen.triangles.empty() ? input.truth : input.seen;
  std::printf("| %s | %.2f | %.1f | %zu | %zu | %s | %zu | %zu | %.2f | %.2f |\n",
              method.name.c_str(),
              mesh.seconds,
              100 * usedShare(input, mesh),
              facts.components,
              facts.boundary_loops.size(),
              facts.genus ? std::to_string(*facts.genus).c_str() : "-",
              facts.non_manifold_edges + facts.misoriented_edges,
              facts.self_intersections.value_or(0),
              meanDistance(made, input.truth, spacing),
              meanDistance(wanted, made, spacing));
  std::fflush(stdout);
}

Positions
positionsOf(const Cloud& cloud)
{
  Positions positions;
  for (const pcl::PointXYZ& point : cloud)
    positions.push_back(point.getVector3fMap().cast<double>());
  return positions;
}

std::string
fileName(std::string name)
{
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

void
run(const std::string& folder)
{
  const std::vector<FreeMethod> methods = freeMethods();
  for (const MethodInput& input : makeMethodInputs()) {
    std::printf("\n## %s: %zu points\n\n", input.name.c_str(), input.cloud->size());
    std::printf(
        "| method | seconds | points used, %% | pieces | loops | handles | faulty "
        "edges | crossings | too much | missing |\n"
        "|---|---|---|---|---|---|---|---|---|---|\n");
    MeshRow row(input.view, positionsOf(*input.cloud));
    for (const FreeMethod& method : methods) {
      const FreeMesh mesh = method.run(input);
      printRow(input, method, mesh);
      row.add(mesh.positions, mesh.triangles);
    }
    row.write(folder + "/" + fileName(input.name) + ".ply");
  }
}

} // namespace
} // namespace bench

int
main(int argc, char** argv)
{
  if (argc != 2 || argv[1][0] == '-') {
    std::printf(
        "usage: bench_methods FOLDER\n\nPrints a table for each of ten clouds, "
        "and writes their meshes side by side into FOLDER.\nToo much and "
        "missing are mean distances in spacings: of the mesh from the true "
        "surface,\nand of what was measured of it from the mesh. One thread.\n");
    return argc == 1 ? 0 : 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  try {
    bench::run(argv[1]);
  }
  catch (const std::exception& problem) {
    std::fprintf(stderr, "bench_methods: %s\n", problem.what());
    return 1;
  }
}
