// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: example, a mesh of a scan that keeps all of its fields.
//
// Usage: scan_to_mesh SCAN.pcd|SCAN.ply MESH.ply
//
// Prints what became of the points and says so where some of them have no triangle.
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/conversions.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using Reconstruction = pcl::ConsecutiveReconstruction<pcl::PointXYZ>;

//! [read]
/** \brief All fields of the file, whatever they are; false if it cannot be read. */
bool
readScan(const std::string& file, pcl::PCLPointCloud2& scan)
{
  const bool is_pcd = file.size() > 4 && file.substr(file.size() - 4) == ".pcd";
  return (is_pcd ? pcl::io::loadPCDFile(file, scan)
                 : pcl::io::loadPLYFile(file, scan)) >= 0;
}
//! [read]

//! [report]
void
printReport(const Reconstruction& reconstruction, const pcl::PolygonMesh& mesh)
{
  const pcl::ConsecutiveReport& report = reconstruction.getReport();
  std::printf("%zu of %zu points without a triangle, %zu not finite\n",
              report.free_points,
              report.points,
              report.skipped_points);
  std::printf("k %.4f, internal %.4f after the filter\n",
              report.connectedShare(),
              report.internalShare());
  for (const pcl::ChainStageReport& stage : report.stages)
    std::printf("%-6s %zu triangles\n", stage.name.c_str(), stage.triangles);
  std::printf("%zu triangles in all\n", mesh.polygons.size());
}
//! [report]

//! [reconstruct]
/** \brief A mesh of all usable points; without polygons after an error. */
pcl::PolygonMesh
reconstruct(const pcl::PCLPointCloud2& scan)
{
  const auto positions = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::fromPCLPointCloud2(scan, *positions);

  Reconstruction reconstruction;
  reconstruction.setInputCloud(positions);
  pcl::PolygonMesh mesh;
  reconstruction.reconstruct(mesh);
  printReport(reconstruction, mesh);

  // Triangles name points by their place in the cloud, and that has not changed: the
  // scan with all its fields takes the place of the bare positions.
  mesh.cloud = scan;
  return mesh;
}
//! [reconstruct]

//! [free points]
/** \brief The points of the mesh without a triangle. */
pcl::Indices
freePoints(const pcl::PolygonMesh& mesh)
{
  std::vector<bool> used(mesh.cloud.width * mesh.cloud.height, false);
  for (const pcl::Vertices& triangle : mesh.polygons)
    for (const auto corner : triangle.vertices)
      used[std::size_t(corner)] = true;
  pcl::Indices free;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i])
      free.push_back(pcl::index_t(i));
  return free;
}
//! [free points]

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 3) {
    std::fprintf(stderr, "usage: scan_to_mesh SCAN.pcd|SCAN.ply MESH.ply\n");
    return 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  pcl::PCLPointCloud2 scan;
  if (!readScan(argv[1], scan)) {
    std::fprintf(stderr, "scan_to_mesh: cannot read %s\n", argv[1]);
    return 1;
  }
  const pcl::PolygonMesh mesh = reconstruct(scan);
  if (mesh.polygons.empty())
    return 1; // the reason has been printed
  if (pcl::io::savePLYFileBinary(argv[2], mesh) < 0) {
    std::fprintf(stderr, "scan_to_mesh: cannot write %s\n", argv[2]);
    return 1;
  }
  std::printf("%s: %zu triangles, %zu free points\n",
              argv[2],
              mesh.polygons.size(),
              freePoints(mesh).size());
}
