// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how much of a scene from one side faces the sensor.
#include "sides_table.h"

#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_repair/force_line_hole_repair.h>
#include <pcl/conversions.h>

#include "input_clouds.h"
#include "mesh/cloud_access.h"
#include "support/single_view.h"

#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <map>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bench {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::Positions;
using pcl::ccaa::test::SingleView;

/** A file of the shared data, and where its sensor stood in its frame. */
struct Scene {
  const char* file;
  Position sensor;
  double cell = 0.0; /**< in radians: of each such cell the nearest point; 0: all */
};

std::vector<Scene>
realScenes()
{
  const Position origin = Position::Zero();
  const Position scanner(0.0, 0.1, 1.0); // of the Bunny: far away along z
  return {{"rs1_scene/rs1_normals.ply", origin},
          {"range_maps/lato000.ply", origin},
          {"range_maps/lato180.ply", origin},
          {"rgbd_room/fragment_002.ply", origin, 0.006},
          {"pcl_scenes/milk.ply", origin},
          {"pcl_scenes/table_scene_lms400.ply", origin, 0.008},
          {"bunny_scans/bun000.ply", scanner},
          {"bunny_scans/bun045.ply", scanner},
          {"bunny_scans/bun090.ply", scanner},
          {"bunny_scans/bun180.ply", scanner}};
}

/** A cloud fused from many frames, or noisier than its spacing, as one view from the
 * origin: the nearest point of each cell. */
Cloud::Ptr
nearestOfCells(const Cloud& cloud, double cell)
{
  std::map<std::pair<long, long>, pcl::PointXYZ> nearest;
  for (const pcl::PointXYZ& point : cloud) {
    const float depth = std::abs(point.z);
    const auto place = std::make_pair(std::lround(double(point.x / depth) / cell),
                                      std::lround(double(point.y / depth) / cell));
    const auto found = nearest.emplace(place, point).first;
    if (point.getVector3fMap().norm() < found->second.getVector3fMap().norm())
      found->second = point;
  }
  const auto view = std::make_shared<Cloud>();
  for (const auto& [place, point] : nearest)
    view->push_back(point);
  return view;
}

/** Triangles and the share that faces the sensor, in percent. */
void
printStage(const pcl::PolygonMesh& mesh, const Position& sensor, std::ostream& out)
{
  const Positions points =
      pcl::ccaa::copyPositions(pcl::ccaa::positionView(mesh.cloud)).positions;
  out << std::setw(9) << mesh.polygons.size() << std::setw(8) << std::fixed
      << std::setprecision(2)
      << 100.0 * pcl::ccaa::test::facingShare(mesh.polygons, points, sensor)
      << std::flush;
}

void
printScene(const std::string& name,
           const Cloud::Ptr& cloud,
           const Position& sensor,
           std::ostream& out)
{
  out << std::left << std::setw(28) << name << std::right << std::setw(8)
      << cloud->size();
  cloud->sensor_origin_.head<3>() = sensor.cast<float>();
  pcl::ConsecutiveReconstruction<pcl::PointXYZ> chain;
  chain.setInputCloud(cloud);
  const auto base = chain.getBaseAlgorithm();
  const auto mesh = std::make_shared<pcl::PolygonMesh>();
  for (const bool is_whole : {false, true}) {
    chain.setBaseAlgorithm(is_whole ? base : nullptr);
    chain.reconstruct(*mesh);
    printStage(*mesh, sensor, out);
  }
  pcl::ForceLineHoleRepair repair;
  repair.setInputMesh(mesh);
  repair.setViewpoint(sensor);
  pcl::PolygonMesh repaired;
  repair.process(repaired);
  printStage(repaired, sensor, out);
  out << "  " << describe(chain.getSideTally()) << std::endl;
}

} // namespace

void
printSides(std::ostream& out, std::uint64_t seeds)
{
  out << "Scenes from one side: triangles, and % of them that face the sensor\n"
      << "scene                         points   filter       %     base       %   "
         "repair       %  outer side by\n";
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const SingleView view = pcl::ccaa::test::singleView(seed);
    printScene(
        "generated " + std::to_string(seed), cloudOf(view.points), view.sensor, out);
  }
  const char* const folder = std::getenv("PSR_SHARED_DATA");
  const std::string data = folder != nullptr ? folder : PSR_SHARED_DATA_DIR;
  for (const Scene& scene : realScenes())
    try {
      const Cloud::Ptr cloud = makeCloud(data + "/" + scene.file);
      printScene(shortName(scene.file),
                 scene.cell > 0.0 ? nearestOfCells(*cloud, scene.cell) : cloud,
                 scene.sensor,
                 out);
    }
    catch (const std::runtime_error& problem) {
      out << problem.what() << "\n";
    }
}

} // namespace bench
