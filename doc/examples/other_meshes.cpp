// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: example, what is wrong with a mesh of another program.
//
// Usage: other_meshes MESH.ply|MESH.obj FILTERED.ply
//        other_meshes CLOUD.ply|CLOUD.obj FILTERED.ply -gp3 RADIUS [-raw MADE.ply]
//
// Takes out of a mesh what is no correct surface, writes what is left, and prints one
// line for each boundary: what it bounds, how sure that is, its edges and its length.
// With -gp3 the mesh is made first, by PCL's greedy projection triangulation; -raw
// writes what that made.
#include <pcl/console/parse.h>
#include <pcl/console/print.h>
#include <pcl/features/normal_3d.h>
#include <pcl/io/obj_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/surface/gp3.h>
#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/surface_repair/boundary_classifier.h>
#include <pcl/memory.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

bool
readMesh(const std::string& file, pcl::PolygonMesh& mesh)
{
  const bool is_obj = file.size() > 4 && file.substr(file.size() - 4) == ".obj";
  return (is_obj ? pcl::io::loadOBJFile(file, mesh)
                 : pcl::io::loadPLYFile(file, mesh)) >= 0;
}

//! [gp3]
/** \brief PCL's triangulation with the settings of its tutorial; replaces the polygons
 * of \a mesh. */
void
triangulate(double radius, pcl::PolygonMesh& mesh)
{
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>>();
  pcl::fromPCLPointCloud2(mesh.cloud, *points);
  pcl::NormalEstimation<pcl::PointNormal, pcl::PointNormal> normals;
  normals.setInputCloud(points);
  normals.setKSearch(20);
  normals.compute(*points);

  pcl::GreedyProjectionTriangulation<pcl::PointNormal> triangulation;
  triangulation.setInputCloud(points);
  triangulation.setSearchRadius(radius);
  triangulation.setMu(2.5);
  triangulation.setMaximumNearestNeighbors(100);
  triangulation.setMaximumSurfaceAngle(M_PI / 4);
  triangulation.setMinimumAngle(M_PI / 18);
  triangulation.setMaximumAngle(2 * M_PI / 3);
  triangulation.setNormalConsistency(false);
  triangulation.reconstruct(mesh.polygons);
}
//! [gp3]

//! [filter]
/** \brief What of \a mesh is a correct surface. */
pcl::PolygonMesh::Ptr
filtered(const pcl::PolygonMesh::ConstPtr& mesh)
{
  pcl::UmbrellaFilter filter;
  filter.setInputMesh(mesh);
  auto result = pcl::make_shared<pcl::PolygonMesh>();
  filter.process(*result);

  const pcl::UmbrellaReport& report = filter.getReport();
  std::printf("%zu polygons given, %zu triangles left\n",
              report.input_polygons,
              report.output_triangles);
  std::printf("taken out: %zu duplicates, %zu at edges of three or more, %zu where "
              "surfaces touch, %zu in crumbs, %zu twists\n",
              report.duplicate_triangles,
              report.overfull_triangles,
              report.umbrella_triangles,
              report.small_region_triangles,
              report.twist_triangles);
  std::printf("turned round: %zu; points: %zu internal, %zu boundary, %zu free\n",
              report.reversed_triangles,
              report.internal_points,
              report.boundary_points,
              report.free_points);
  return result;
}
//! [filter]

//! [classify]
/** \brief Print what each boundary bounds, the longest first; false after an error. */
bool
printBoundaries(const pcl::PolygonMesh::ConstPtr& mesh)
{
  pcl::BoundaryClassifier classifier;
  classifier.setInputMesh(mesh);
  std::vector<pcl::ClassifiedBoundary> boundaries;
  if (!classifier.classify(boundaries))
    return false; // the reason has been printed
  std::stable_sort(
      boundaries.begin(), boundaries.end(), [](const auto& one, const auto& other) {
        return one.length > other.length;
      });

  std::printf("class         confidence  edges      length  island\n");
  for (const pcl::ClassifiedBoundary& boundary : boundaries)
    std::printf("%-12s  %10.2f  %5zu  %10.4g  %6zu\n",
                pcl::repair::describe(boundary.boundary_class),
                boundary.confidence,
                boundary.vertices.size(),
                boundary.length,
                boundary.island);
  const pcl::repair::IcmCounts& counts = classifier.getReport().counts;
  std::printf("islands: %zu; holes: %zu simple, %zu complex\n",
              counts.islands,
              counts.simple_holes,
              counts.complex_holes);
  return true;
}
//! [classify]

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 3) {
    std::fprintf(stderr,
                 "usage: other_meshes INPUT.ply|INPUT.obj FILTERED.ply "
                 "[-gp3 RADIUS [-raw MADE.ply]]\n");
    return 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  if (!readMesh(argv[1], *mesh)) {
    std::fprintf(stderr, "other_meshes: cannot read %s\n", argv[1]);
    return 1;
  }
  double radius = 0;
  if (pcl::console::parse_argument(argc, argv, "-gp3", radius) >= 0)
    triangulate(radius, *mesh);
  std::string raw;
  if (pcl::console::parse_argument(argc, argv, "-raw", raw) >= 0)
    pcl::io::savePLYFileBinary(raw, *mesh);
  const pcl::PolygonMesh::Ptr correct = filtered(mesh);
  if (pcl::io::savePLYFileBinary(argv[2], *correct) < 0) {
    std::fprintf(stderr, "other_meshes: cannot write %s\n", argv[2]);
    return 1;
  }
  return printBoundaries(correct) ? 0 : 1;
}
