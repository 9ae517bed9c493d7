// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a damaged model, its repair and how good it is.
#include "repair_trial.h"

#include <pcl/surface_repair/force_line_hole_repair.h>
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include "closed_models.h"
#include "io/model_io.h"
#include "measuring.h"
#include "mesh/cloud_access.h"
#include "mesh/intersection.h"
#include "mesh/polygon_access.h"
#include "mesh_distance.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace bench {
namespace {

using pcl::ccaa::Triangle;

Positions
positionsOf(const pcl::PCLPointCloud2& cloud)
{
  const auto view = pcl::ccaa::positionView(cloud);
  Positions positions;
  for (std::size_t i = 0; i < view.size(); ++i)
    positions.push_back(view[i]);
  return positions;
}

Triangle
sorted(Triangle triangle)
{
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

} // namespace

pcl::PolygonMesh::Ptr
meshOf(const Shape& shape)
{
  pcl::PointCloud<pcl::PointXYZ> points;
  for (const auto& position : shape.vertices) {
    points.emplace_back();
    points.back().getVector3fMap() = position.cast<float>();
  }
  auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::toPCLPointCloud2(points, mesh->cloud);
  mesh->polygons.resize(shape.triangles.size());
  for (std::size_t t = 0; t < shape.triangles.size(); ++t)
    mesh->polygons[t].vertices.assign(shape.triangles[t].begin(),
                                      shape.triangles[t].end());
  return mesh;
}

RepairTrial
runTrial(const Shape& damaged, const TrialSettings& settings)
{
  pcl::ForceLineHoleRepair repair;
  repair.setInputMesh(meshOf(damaged));
  repair.setParameters(settings.parameters);
  repair.setNumberOfThreads(1);
  if (!settings.free_points.empty())
    repair.setFreePoints(pcl::make_shared<pcl::PCLPointCloud2>(
        meshOf({settings.free_points, {}})->cloud));
  RepairTrial trial;
  std::vector<double> seconds;
  pcl::PolygonMesh output;
  for (std::size_t i = 0; i < settings.repeats; ++i)
    seconds.push_back(secondsOf([&] { repair.process(output); }));
  trial.seconds = median(seconds);
  trial.report = repair.getReport();
  trial.result = {positionsOf(output.cloud), pcl::ccaa::fanTriangles(output.polygons)};
  return trial;
}

Shape
readShape(const std::string& file)
{
  app::Model model;
  const app::Status status = app::readMesh(file, model);
  if (!status.ok())
    throw std::runtime_error(status.message());
  return {positionsOf(model.mesh.cloud), pcl::ccaa::fanTriangles(model.mesh.polygons)};
}

Shape
readShared(const std::string& name)
{
  return readShape(sharedFile(name));
}

std::size_t
countIntersections(const Shape& shape)
{
  pcl::ccaa::RunControl control;
  return pcl::ccaa::findSelfIntersections(shape.triangles, shape.vertices, 1, control)
      .pairs.size();
}

double
diagonalOf(const Shape& shape)
{
  Eigen::AlignedBox3d box;
  for (const auto& position : shape.vertices)
    if (position.allFinite())
      box.extend(position);
  return box.diagonal().norm();
}

Shape
lostPart(const Shape& whole, const Triangles& kept)
{
  std::vector<Triangle> is_kept;
  for (const Triangle& triangle : kept)
    is_kept.push_back(sorted(triangle));
  std::sort(is_kept.begin(), is_kept.end());
  Shape lost{whole.vertices, {}};
  for (const Triangle& triangle : whole.triangles)
    if (!std::binary_search(is_kept.begin(), is_kept.end(), sorted(triangle)))
      lost.triangles.push_back(triangle);
  return lost;
}

double
meanDistance(const Shape& from, const Shape& to, double length)
{
  const MeshDistance distance(to.triangles, to.vertices);
  const double nowhere = std::numeric_limits<double>::infinity();
  return 100.0 *
         measureDeviation(from.triangles, from.vertices, distance, nowhere).mean /
         length;
}

} // namespace bench
