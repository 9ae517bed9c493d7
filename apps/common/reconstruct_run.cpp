// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the stages of pcl_ccaa_reconstruct.
#include "reconstruct_run.h"

#include <pcl/search/kdtree.h>
#include <pcl/surface_ccaa/greedy_start.h>
#include <pcl/surface_ccaa/search/block_search.h>
#include <pcl/point_types.h>

#include "cloud_assembler.h"
#include "point_columns.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr
toPositionsOnly(const Model& model)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  const auto positions = readPositions(model.mesh.cloud);
  cloud->resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    (*cloud)[i].getVector3fMap() = positions[i];
  cloud->is_dense = model.mesh.cloud.is_dense;
  cloud->sensor_orientation_ = model.viewpoint.orientation;
  cloud->sensor_origin_.head<3>() = model.viewpoint.position;
  return cloud;
}

pcl::search::Search<pcl::PointXYZ>::Ptr
makeSearch(const ReconstructSettings& settings)
{
  if (settings.search == "kdtree")
    return std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  auto search = std::make_shared<pcl::search::BlockSearch<pcl::PointXYZ>>();
  search->setNumberOfThreads(settings.threads);
  return search;
}

/** What the filter looks at: positions, normals and the place of the sensor, which
 * PCL's meshes can carry only as fields of each point. */
pcl::PCLPointCloud2
cloudForFilter(const Model& model)
{
  const pcl::PCLPointCloud2& cloud = model.mesh.cloud;
  if (!model.viewpoint.known || findField(cloud, "vp_x"))
    return cloud;
  std::vector<float> positions;
  FieldArray normals{"normal", pcl::PCLPointField::FLOAT32, 3, {}};
  std::vector<FieldArray> sensor(3, {"vp_x", pcl::PCLPointField::FLOAT32, 1, {}});
  sensor[1].name = "vp_y";
  sensor[2].name = "vp_z";
  std::size_t offset = 0;
  const bool has_normals = findNormal(cloud, offset);
  std::size_t point_index = 0;
  for (const Eigen::Vector3f& position : readPositions(cloud)) {
    const std::uint8_t* const point = pointAt(cloud, point_index++);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions.push_back(position[static_cast<int>(axis)]);
      sensor[axis].append(model.viewpoint.position[static_cast<int>(axis)]);
      if (has_normals)
        normals.append(loadScalar<float>(point + offset + 4 * axis, false));
    }
  }
  pcl::PCLPointCloud2 result;
  const bool good =
      assembleCloud(positions, {normals, sensor[0], sensor[1], sensor[2]}, result).ok();
  return good ? result : cloud;
}

} // namespace

void
runStart(const ReconstructSettings& settings,
         ProgressBar& bar,
         ReconstructResult& result)
{
  pcl::GreedyStart<pcl::PointXYZ> start;
  start.setInputCloud(toPositionsOnly(result.model));
  start.setSearchMethod(makeSearch(settings));
  start.setNumberOfNeighbors(settings.neighbors);
  start.setMinimumAngle(settings.minimum_angle * M_PI / 180);
  start.setCertifiedMinimumAngle(settings.certified_minimum_angle * M_PI / 180);
  start.setLengthFactor(settings.length_factor);
  start.setUseCertificates(!settings.plain);
  start.setNumberOfThreads(settings.threads);
  start.setProgressCallback(bar.callback());
  Stopwatch watch;
  start.reconstruct(result.model.mesh.polygons);
  const double seconds = watch.lap();
  result.start = start.getReport();
  const double greedy = std::min(result.start.greedy_seconds, seconds);
  result.stages.emplace_back("search", seconds - greedy);
  result.stages.emplace_back("start", greedy);
}

void
runFilter(const ReconstructSettings& settings,
          ProgressBar& bar,
          ReconstructResult& result)
{
  auto mesh = std::make_shared<pcl::PolygonMesh>();
  mesh->polygons = std::move(result.model.mesh.polygons);
  pcl::PCLPointCloud2 whole_cloud;
  if (result.model.viewpoint.known) {
    mesh->cloud = cloudForFilter(result.model);
    whole_cloud = std::move(result.model.mesh.cloud);
  }
  else
    mesh->cloud = std::move(result.model.mesh.cloud);
  result.model.mesh = pcl::PolygonMesh();
  pcl::UmbrellaFilter filter;
  filter.setInputMesh(mesh);
  filter.setMinimumInternalPoints(settings.minimum_internal_points);
  filter.setNumberOfThreads(settings.threads);
  filter.setProgressCallback(bar.callback());
  Stopwatch watch;
  filter.process(result.model.mesh);
  result.stages.emplace_back("filter", watch.lap());
  result.filter = filter.getReport();
  result.filtered = true;
  // Byte for byte what was read, whatever the classes on the way made of it.
  result.model.mesh.cloud =
      std::move(result.model.viewpoint.known ? whole_cloud : mesh->cloud);
}

std::size_t
countUsedPoints(const pcl::PolygonMesh& mesh)
{
  std::vector<bool> used(pointCount(mesh.cloud), false);
  for (const pcl::Vertices& polygon : mesh.polygons)
    for (const pcl::index_t corner : polygon.vertices)
      used[static_cast<std::size_t>(corner)] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), true));
}

} // namespace app
