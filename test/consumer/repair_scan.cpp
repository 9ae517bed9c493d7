// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a user's program from a cloud with a gap to a whole mesh.
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_repair/force_line_hole_repair.h>
#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <cstdio>

namespace {

/** \brief A sphere of radius 1 that was not seen from above. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
scanSphere()
{
  constexpr int points = 2000;
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  const double golden_angle = M_PI * (3.0 - std::sqrt(5.0));
  for (int i = 0; i < points; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / points;
    if (z > 0.95)
      continue;
    const double radius = std::sqrt(1.0 - z * z);
    cloud->emplace_back(static_cast<float>(radius * std::cos(golden_angle * i)),
                        static_cast<float>(radius * std::sin(golden_angle * i)),
                        static_cast<float>(z));
  }
  return cloud;
}

} // namespace

int
main()
{
  pcl::ConsecutiveReconstruction<pcl::PointXYZ> reconstruction;
  reconstruction.setInputCloud(scanSphere());
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  reconstruction.reconstruct(*mesh);

  pcl::ForceLineHoleRepair repair;
  repair.setInputMesh(mesh);
  pcl::PolygonMesh whole;
  repair.process(whole);
  std::printf(
      "triangles: %zu, repaired %zu\n", mesh->polygons.size(), whole.polygons.size());
  const bool closed = whole.polygons.size() > mesh->polygons.size();
  return !mesh->polygons.empty() && closed && repair.getReport().complete() ? 0 : 1;
}
