// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: example, which boundaries of a mesh are holes.
//
// Usage: boundary_classes MESH.ply
//
// Prints one line for each boundary loop: what it bounds, how sure that is, its edges
// and its length.
#include <pcl/console/print.h>
#include <pcl/io/ply_io.h>
#include <pcl/surface_repair/boundary_classifier.h>
#include <pcl/memory.h>

#include <cstdio>
#include <vector>

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::fprintf(stderr, "usage: boundary_classes MESH.ply\n");
    return 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  if (pcl::io::loadPLYFile(argv[1], *mesh) < 0) {
    std::fprintf(stderr, "boundary_classes: cannot read %s\n", argv[1]);
    return 1;
  }

  pcl::BoundaryClassifier classifier;
  classifier.setInputMesh(mesh);
  std::vector<pcl::ClassifiedBoundary> boundaries;
  if (!classifier.classify(boundaries))
    return 1; // the reason has been printed

  std::printf("class         confidence  edges      length  island\n");
  for (const pcl::ClassifiedBoundary& boundary : boundaries)
    std::printf("%-12s  %10.2f  %5zu  %10.4g  %6zu\n",
                pcl::repair::describe(boundary.boundary_class),
                boundary.confidence,
                boundary.vertices.size(),
                boundary.length,
                boundary.island);
  const pcl::BoundaryReport& report = classifier.getReport();
  std::printf("%zu islands, %zu simple and %zu complex holes\n",
              report.counts.islands,
              report.counts.simple_holes,
              report.counts.complex_holes);
}
