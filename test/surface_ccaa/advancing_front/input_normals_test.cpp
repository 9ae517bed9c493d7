// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the sides that normals of the input tell.

#include <gtest/gtest.h>

#include "completion_helpers.h"

namespace pcl::ccaa::test {
namespace {

using InputNormals = CompletionTest;

/** With outward normals; `side` -1 turns them inward. */
PointCloud<PointNormal>::Ptr
withNormals(const Shape& shape, float side)
{
  auto cloud = std::make_shared<PointCloud<PointNormal>>();
  for (const Position& vertex : shape.vertices) {
    const Eigen::Vector3f p = vertex.cast<float>(), n = side * p.normalized();
    cloud->emplace_back(p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
  }
  return cloud;
}

Triangles
completeWithNormals(const Shape& given, const PointCloud<PointNormal>::Ptr& cloud)
{
  ProjectionCompletion<PointNormal> completion;
  completion.setNumberOfThreads(1);
  completion.setInputCloud(cloud);
  completion.setPartialMesh(std::make_shared<PolygonMesh>(toPolygonMesh(given)));
  std::vector<Vertices> polygons;
  completion.reconstruct(polygons);
  return toTriangles(polygons);
}

/** Two caps of a sphere, one of them turned over; the belt between them is free. */
Shape
twoCaps()
{
  Shape caps = noisyIcosphere(3, 0.005);
  std::vector<std::size_t> belt;
  for (std::size_t t = 0; t < caps.triangles.size(); ++t)
    for (const index_t corner : caps.triangles[t])
      if (std::abs(caps.vertices[std::size_t(corner)].z()) < 0.3) {
        belt.push_back(t);
        break;
      }
  caps = withoutTriangles(caps, belt);
  caps.triangles = withEverySecondPieceReversed(caps.triangles);
  return caps;
}

TEST_F(InputNormals, TurnIslandsOutward)
{
  const Shape given = twoCaps();
  const Triangles triangles = completeWithNormals(given, withNormals(given, 1.0f));
  EXPECT_TRUE(keepsGiven(given.triangles, triangles));
  expectClosed(triangles, given.vertices, 1, 0);
}

TEST_F(InputNormals, ThatPointInwardWin)
{
  const Shape given = twoCaps();
  const Triangles triangles = completeWithNormals(given, withNormals(given, -1.0f));
  EXPECT_TRUE(keepsGiven(given.triangles, triangles));
  expectClosed(reversed(triangles), given.vertices, 1, 0);
}

TEST_F(InputNormals, TellTheSideOfAReconstruction)
{
  const Shape ground = terrain(20, 20);
  for (const float side : {1.0f, -1.0f}) {
    auto cloud = withNormals(ground, 0.0f);
    for (PointNormal& point : *cloud)
      point.normal_z = side;
    const Triangles triangles = completeWithNormals({ground.vertices, {}}, cloud);
    EXPECT_GE(triangles.size(), ground.triangles.size());
    for (const Triangle& t : triangles) {
      const Position& a = ground.vertices[std::size_t(t[0])];
      const Position normal = (ground.vertices[std::size_t(t[1])] - a)
                                  .cross(ground.vertices[std::size_t(t[2])] - a);
      ASSERT_GE(normal.z() * double(side), 0.0); // 0: upright along the border
    }
  }
}

TEST_F(InputNormals, ThatAreMissingInPlacesDoNoHarm)
{
  const Shape given = twoCaps();
  auto cloud = withNormals(given, 2.5f);
  for (std::size_t i = 0; i < cloud->size(); i += 3) {
    const float bad = i % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : 0.0f;
    (*cloud)[i].normal_x = (*cloud)[i].normal_y = (*cloud)[i].normal_z = bad;
  }
  expectClosed(completeWithNormals(given, cloud), given.vertices, 1, 0);
}

TEST_F(InputNormals, ThatAreAllMissingAreNotAsked)
{
  const Shape given = filteredToIcadm(twoCaps()); // winds both outward
  expectClosed(
      completeWithNormals(given, withNormals(given, 0.0f)), given.vertices, 1, 0);
}

} // namespace
} // namespace pcl::ccaa::test
