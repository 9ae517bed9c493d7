// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: example, a mesh in pieces and with holes becomes whole.
//
// Usage: repair_mesh MESH.ply REPAIRED.ply [TRUST [TRUTH.ply]]
//
// TRUST (k_t, 0 to 1) says how far the points without a triangle are to be believed.
// TRUTH holds points that were taken away: the distance of the repaired mesh to them is
// printed. Exit code 2: something that should be closed was left open.
#include <pcl/console/print.h>
#include <pcl/io/ply_io.h>
#include <pcl/surface_ccaa/block_search.h>
#include <pcl/surface_repair/force_line_hole_repair.h>
#include <pcl/conversions.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

namespace {

//! [holes]
/** \brief One line for each reason to leave holes open, with a place to look at. */
void
printOpenHoles(const pcl::RepairReport& report)
{
  std::map<pcl::OpenReason, std::vector<pcl::RepairedHole>> open;
  for (const pcl::RepairedHole& hole : report.holes)
    if (hole.open != pcl::OpenReason::NONE)
      open[hole.open].push_back(hole);
  for (const auto& [reason, holes] : open)
    std::printf("%zu %s: %s (the first at point %d, %zu edges)\n",
                holes.size(),
                pcl::isShortfall(reason) ? "LEFT OPEN" : "open as it should be",
                pcl::describe(reason),
                int(holes.front().point),
                holes.front().edges);
}
//! [holes]

//! [report]
void
printReport(const pcl::RepairReport& report)
{
  std::printf("%zu islands, %zu loops, %zu free points\n",
              report.islands.size(),
              report.loops.size(),
              report.free_points);
  std::printf("%zu bridges, %zu new triangles, %zu new points\n",
              report.bridges.size(),
              report.new_triangles,
              report.new_vertices);
  printOpenHoles(report);
}
//! [report]

//! [origins]
/** \brief The new triangles alone, for a viewer or for somebody who has to check them.
 */
pcl::PolygonMesh
newTriangles(const pcl::PolygonMesh& repaired, const pcl::RepairReport& report)
{
  pcl::PolygonMesh patches;
  patches.cloud = repaired.cloud;
  for (std::size_t i = 0; i < repaired.polygons.size(); ++i)
    if (report.origins[i] != pcl::TriangleOrigin::INPUT)
      patches.polygons.push_back(repaired.polygons[i]);
  return patches;
}
//! [origins]

//! [error]
/** \brief Root mean square distance of the points \a truth to the nearest vertex of \a
 * mesh that has a triangle, in units of the cloud. */
double
errorOf(const pcl::PolygonMesh& mesh, const pcl::PointCloud<pcl::PointXYZ>& truth)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::fromPCLPointCloud2(mesh.cloud, *cloud);
  const auto vertices = pcl::make_shared<pcl::Indices>();
  for (const pcl::Vertices& triangle : mesh.polygons)
    vertices->insert(
        vertices->end(), triangle.vertices.begin(), triangle.vertices.end());
  std::sort(vertices->begin(), vertices->end());
  vertices->erase(std::unique(vertices->begin(), vertices->end()), vertices->end());

  pcl::search::BlockSearch<pcl::PointXYZ> search;
  search.setInputCloud(cloud, vertices);
  pcl::Indices nearest;
  std::vector<float> sqr_distance;
  double sum = 0;
  for (const pcl::PointXYZ& point : truth) {
    search.nearestKSearch(point, 1, nearest, sqr_distance);
    sum += double(sqr_distance.front());
  }
  return std::sqrt(sum / double(truth.size()));
}
//! [error]

/** \brief Print the error against the points of \a file; false if it has none. */
bool
printError(const pcl::PolygonMesh& repaired, const std::string& file)
{
  pcl::PointCloud<pcl::PointXYZ> truth;
  if (pcl::io::loadPLYFile(file, truth) < 0 || truth.empty()) {
    std::fprintf(stderr, "repair_mesh: no points in %s\n", file.c_str());
    return false;
  }
  std::printf("distance to the truth %.4g\n", errorOf(repaired, truth));
  return true;
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 3 || argc > 5) {
    std::fprintf(stderr,
                 "usage: repair_mesh MESH.ply REPAIRED.ply [TRUST [TRUTH.ply]]\n");
    return 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  if (pcl::io::loadPLYFile(argv[1], *mesh) < 0) {
    std::fprintf(stderr, "repair_mesh: cannot read %s\n", argv[1]);
    return 1;
  }

  //! [repair]
  pcl::ForceLineHoleRepair repair;
  repair.setInputMesh(mesh);
  if (argc > 3)
    repair.setTrust(std::atof(argv[3]));
  pcl::PolygonMesh repaired;
  repair.process(repaired);
  if (repaired.polygons.empty())
    return 1; // the reason has been printed
  //! [repair]
  printReport(repair.getReport());
  const std::string patches = std::string(argv[2]) + ".patches.ply";
  if (pcl::io::savePLYFileBinary(argv[2], repaired) < 0 ||
      pcl::io::savePLYFileBinary(patches, newTriangles(repaired, repair.getReport())) <
          0) {
    std::fprintf(stderr, "repair_mesh: cannot write %s\n", argv[2]);
    return 1;
  }
  if (argc > 4 && !printError(repaired, argv[4]))
    return 1;
  //! [exit code]
  return repair.getReport().complete() ? 0 : 2;
  //! [exit code]
}
