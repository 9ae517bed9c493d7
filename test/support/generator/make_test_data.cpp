// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes the inputs kept under test/data.
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include "support/clouds.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <iostream>
#include <string>

namespace {

using namespace pcl::ccaa::test;
using pcl::ccaa::Position;
using pcl::ccaa::Positions;

bool
writeCloud(const std::string& path, const Positions& points)
{
  return pcl::io::savePCDFileBinary(path, *toCloud(points)) == 0;
}

/** \brief Two separate spheres, of different spacing. */
Positions
twoSpheres()
{
  Positions points = fibonacciSphere(900);
  const Positions second = shifted(fibonacciSphere(600, 0.4), {2.5, 0.0, 0.0});
  points.insert(points.end(), second.begin(), second.end());
  return points;
}

/** \brief A terrain as an organised cloud with some points missing. */
bool
writeOrganised(const std::string& path)
{
  const int columns = 40, rows = 30;
  auto cloud = toCloud(withNonFinite(terrain(columns, rows).vertices, 60));
  cloud->width = columns;
  cloud->height = rows;
  return pcl::io::savePCDFileBinary(path, *cloud) == 0;
}

/** \brief A sphere with outward normals, colours and curvature. */
bool
writeManyFields(const std::string& path)
{
  pcl::PointCloud<pcl::PointXYZRGBNormal> cloud;
  for (const Position& position : fibonacciSphere(800)) {
    pcl::PointXYZRGBNormal point;
    point.getVector3fMap() = position.cast<float>();
    point.getNormalVector3fMap() = position.cast<float>();
    point.curvature = 1.0f;
    point.r = static_cast<std::uint8_t>(127.0 + 127.0 * position.x());
    point.g = static_cast<std::uint8_t>(127.0 + 127.0 * position.y());
    point.b = static_cast<std::uint8_t>(127.0 + 127.0 * position.z());
    cloud.push_back(point);
  }
  return pcl::io::savePCDFileBinary(path, cloud) == 0;
}

/** \brief A torus with a third sheet on an edge, a bow-tie, a duplicate and mixed
 * windings. */
bool
writeFaultyMesh(const std::string& path)
{
  Shape shape = withoutTriangles(torus(40, 20), {100, 101, 102, 103, 180, 181});
  shape.vertices.push_back({1.6, 0.0, 0.0});
  const auto tip = static_cast<pcl::index_t>(shape.vertices.size() - 1);
  shape.triangles.push_back({0, 1, tip});
  shape.triangles.push_back(shape.triangles[500]);
  shape.triangles = randomlyReversed(shape.triangles, 7);
  return pcl::io::savePLYFileBinary(path, toPolygonMesh(shape)) == 0;
}

bool
writeAll(const std::string& folder)
{
  const Positions line = {{0, 0, 0}, {1, 1, 2}, {2, 2, 4}, {3, 3, 6}, {4, 4, 8}};
  const Positions sphere = fibonacciSphere(1500);
  return writeCloud(folder + "/sphere.pcd", sphere) &&
         writeCloud(folder + "/noisy_sphere.pcd", noisySphere(1500, 0.004)) &&
         writeCloud(folder + "/bumpy_sphere.pcd", bumpySphere(3000)) &&
         writeCloud(folder + "/torus.pcd", torusCloud(3000)) &&
         writeCloud(folder + "/cube.pcd", cubeCloud(16)) &&
         writeCloud(folder + "/cylinder.pcd", cylinderCloud(1500)) &&
         writeCloud(folder + "/thin_plate.pcd", thinPlateCloud(30, 0.2)) &&
         writeCloud(folder + "/terrain.pcd", terrainCloud(40)) &&
         writeCloud(folder + "/duplicates.pcd",
                    withDuplicates(fibonacciSphere(400), 5)) &&
         writeCloud(folder + "/non_finite.pcd", withNonFinite(sphere, 150)) &&
         writeCloud(folder + "/far_away.pcd",
                    shifted(scaled(sphere, 50.0), {5e4, 2e5, 250})) &&
         writeCloud(folder + "/two_spheres.pcd", twoSpheres()) &&
         writeCloud(folder + "/collinear.pcd", line) &&
         writeCloud(folder + "/identical.pcd", Positions(50, Position(1, 2, 3))) &&
         writeCloud(folder + "/empty.pcd", {}) &&
         writeOrganised(folder + "/organised.pcd") &&
         writeManyFields(folder + "/many_fields.pcd") &&
         writeFaultyMesh(folder + "/faulty_torus.ply");
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: make_test_data FOLDER\n";
    return 1;
  }
  if (writeAll(argv[1]))
    return 0;
  std::cerr << "cannot write to " << argv[1] << "\n";
  return 1;
}
