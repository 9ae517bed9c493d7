// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: methods whose meshes may have points of their own.
#include "free_methods.h"

#include <pcl/features/impl/normal_3d.hpp>
#include <pcl/search/kdtree.h>
#include <pcl/surface/concave_hull.h>
#include <pcl/surface/poisson.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_repair/force_line_hole_repair.h>
#include <pcl/conversions.h>

#include "clean/clean_cloud.h"
#include "measuring.h"
#include "mesh/cloud_access.h"
#include "mesh/polygon_access.h"
#include "rivals.h"

#include <limits>

namespace bench {
namespace {

using pcl::ccaa::Position;

FreeMesh
toFreeMesh(const pcl::PolygonMesh& mesh)
{
  FreeMesh result;
  result.positions =
      pcl::ccaa::copyPositions(pcl::ccaa::positionView(mesh.cloud)).positions;
  result.triangles = pcl::ccaa::fanTriangles(mesh.polygons);
  return result;
}

FreeMesh
timed(const std::function<void(pcl::PolygonMesh&)>& make)
{
  pcl::PolygonMesh mesh;
  const double seconds = secondsOf([&] { make(mesh); });
  FreeMesh result = toFreeMesh(mesh);
  result.seconds = seconds;
  return result;
}

pcl::ccaa::SideHints
hintsOf(const MethodInput& input)
{
  pcl::ccaa::SideHints hints;
  hints.viewpoint = input.sensor;
  return hints;
}

void
reconstruct(const MethodInput& input, const Cloud::Ptr& cloud, pcl::PolygonMesh& mesh)
{
  pcl::ConsecutiveReconstruction<pcl::PointXYZ> chain;
  chain.setInputCloud(cloud);
  chain.setNumberOfThreads(1);
  chain.setSideHints(hintsOf(input));
  chain.reconstruct(mesh);
}

Cloud::Ptr
cleaned(const Cloud& cloud)
{
  app::Model model;
  pcl::toPCLPointCloud2(cloud, model.mesh.cloud);
  app::cleanCloud(
      {}, 1, [](double) { return true; }, model);
  Cloud::Ptr result(new Cloud);
  pcl::fromPCLPointCloud2(model.mesh.cloud, *result);
  return result;
}

void
reconstructAndRepair(const MethodInput& input, pcl::PolygonMesh& whole)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  reconstruct(input, input.cloud, *mesh);
  pcl::ForceLineHoleRepair repair;
  repair.setInputMesh(mesh);
  repair.setNumberOfThreads(1);
  pcl::repair::RepairParameters parameters;
  parameters.survey.orientation.sides = hintsOf(input);
  repair.setParameters(parameters);
  repair.process(whole);
}

/** The nearest corner of the truth tells the side. */
void
turnOutward(const pcl::ccaa::test::Shape& truth,
            pcl::PointCloud<pcl::PointNormal>& points)
{
  Cloud::Ptr corners = cloudOf(truth.vertices);
  pcl::ccaa::Positions outward(truth.vertices.size(), Position::Zero());
  for (const pcl::ccaa::Triangle& t : truth.triangles) {
    const auto at = [&](std::size_t k) {
      return truth.vertices[static_cast<std::size_t>(t[k])];
    };
    for (const pcl::index_t corner : t)
      outward[static_cast<std::size_t>(corner)] += (at(1) - at(0)).cross(at(2) - at(0));
  }
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(corners);
  pcl::Indices near;
  std::vector<float> sqr_distances;
  for (pcl::PointNormal& point : points) {
    tree.nearestKSearch({point.x, point.y, point.z}, 1, near, sqr_distances);
    const auto corner = static_cast<std::size_t>(near.front());
    if (point.getNormalVector3fMap().cast<double>().dot(outward[corner]) < 0)
      point.getNormalVector3fMap() *= -1;
  }
}

pcl::PointCloud<pcl::PointNormal>::Ptr
withNormals(const MethodInput& input)
{
  pcl::PointCloud<pcl::PointNormal>::Ptr points(new pcl::PointCloud<pcl::PointNormal>);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::PointNormal> estimation;
  estimation.setInputCloud(input.cloud);
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setKSearch(12);
  estimation.compute(*points);
  for (std::size_t i = 0; i < points->size(); ++i)
    (*points)[i].getVector3fMap() = (*input.cloud)[i].getVector3fMap();
  turnOutward(input.truth, *points);
  return points;
}

void
poisson(const MethodInput& input, pcl::PolygonMesh& mesh)
{
  pcl::Poisson<pcl::PointNormal> poisson;
  poisson.setDepth(7);
  poisson.setInputCloud(withNormals(input));
  poisson.reconstruct(mesh);
}

void
alphaShape(const MethodInput& input, pcl::PolygonMesh& mesh)
{
  pcl::ConcaveHull<pcl::PointXYZ> hull;
  hull.setInputCloud(input.cloud);
  hull.setAlpha(1.5 * spacingOf(input.cloud));
  hull.reconstruct(mesh);
}

/** What interpolates has the points of the cloud. */
FreeMesh
ofCloud(const Cloud& cloud, Reconstruction made)
{
  FreeMesh result;
  for (const pcl::PointXYZ& point : cloud)
    result.positions.push_back(point.getVector3fMap().cast<double>());
  result.triangles = std::move(made.triangles);
  result.seconds = made.seconds;
  return result;
}

} // namespace

std::vector<FreeMethod>
freeMethods()
{
  using Mesh = pcl::PolygonMesh;
  using In = const MethodInput&;
  std::vector<FreeMethod> methods = {
      {"ours",
       [](In in) { return timed([&](Mesh& m) { reconstruct(in, in.cloud, m); }); }},
      {"ours, repaired",
       [](In in) { return timed([&](Mesh& m) { reconstructAndRepair(in, m); }); }},
      {"ours, cleaned first",
       [](In in) {
         return timed([&](Mesh& m) { reconstruct(in, cleaned(*in.cloud), m); });
       }},
      {"PCL Poisson", [](In in) { return timed([&](Mesh& m) { poisson(in, m); }); }},
      {"PCL greedy projection",
       [](In in) { return ofCloud(*in.cloud, rivalsFor(in.cloud).front().run()); }},
      {"PCL alpha shape",
       [](In in) { return timed([&](Mesh& m) { alphaShape(in, m); }); }}};
  if (hasAdvancingFront())
    methods.push_back({"CGAL advancing front", [](In in) {
                         return ofCloud(*in.cloud, advancingFront(*in.cloud));
                       }});
  if (hasScaleSpace())
    methods.push_back({"CGAL scale space", [](In in) {
                         return ofCloud(*in.cloud, scaleSpace(*in.cloud));
                       }});
  if (hasBallPivoting())
    methods.push_back({"Open3D ball pivoting", [](In in) {
                         return ofCloud(*in.cloud,
                                        ballPivoting(*in.cloud, spacingOf(in.cloud)));
                       }});
  return methods;
}

} // namespace bench
