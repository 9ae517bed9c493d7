// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of points that are strewn around a surface.

#include <gtest/gtest.h>

#include "advancing_front/scattered_points.h"
#include "open_shapes.h"
#include "support/clouds.h"
#include "support/mesh_asserts.h"

namespace pcl::ccaa::test {
namespace {

/** A sphere and points strewn around it. */
Positions
withStrewnPoints(std::size_t count)
{
  Positions points = fibonacciSphere(800);
  RandomSource random(6);
  while (points.size() < 800 + count) {
    const Position p(
        random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
    if (std::abs(p.norm() - 1.0) > 0.7)
      points.push_back(p);
  }
  return points;
}

TEST(ScatteredPoints, AreThoseStrewnAroundASurface)
{
  const OpenSurface open = openPoints(withStrewnPoints(60));
  const std::vector<std::uint8_t> scattered = findScatteredPoints(open, 0.0);
  EXPECT_EQ(std::count(scattered.begin(), scattered.begin() + 800, 1), 0);
  EXPECT_GE(std::count(scattered.begin() + 800, scattered.end(), 1), 50);
}

TEST(ScatteredPoints, AreNoneOnASurface)
{
  for (const Positions& points :
       {fibonacciSphere(800), torusCloud(800), terrainCloud(25), cubeCloud(10)}) {
    const OpenSurface open = openPoints(points);
    const std::vector<std::uint8_t> scattered = findScatteredPoints(open, 0.0);
    EXPECT_EQ(std::count(scattered.begin(), scattered.end(), 1), 0);
  }
}

TEST(ScatteredPoints, AreNoneThatHaveTriangles)
{
  Shape shape{withStrewnPoints(60), {}};
  std::set<index_t> used;
  for (index_t v = 800; v + 2 < 860; v += 3) {
    shape.triangles.push_back({v, v + 1, v + 2});
    used.insert({v, v + 1, v + 2});
  }
  std::vector<index_t> vertices;
  const OpenSurface open = openSurfaceOf(shape, vertices);
  const std::vector<std::uint8_t> scattered = findScatteredPoints(open, 0.05);
  for (std::size_t i = 0; i < scattered.size(); ++i)
    if (used.count(vertices[i]) != 0) {
      EXPECT_EQ(scattered[i], 0);
    }
}

TEST(ScatteredPoints, DependOnTheUsualSpacing)
{
  const OpenSurface open = openPoints(randomPositions(300, 2));
  const std::vector<std::uint8_t> all = findScatteredPoints(open, 0.01);
  const std::vector<std::uint8_t> none = findScatteredPoints(open, 10.0);
  EXPECT_EQ(std::count(all.begin(), all.end(), 1), 300);
  EXPECT_EQ(std::count(none.begin(), none.end(), 1), 0);
}

TEST(NeighborhoodThickness, IsZeroInAPlaneAndLargeInSpace)
{
  EXPECT_NEAR(neighborhoodThickness(openPoints(grid(9, 9).vertices), 40), 0.0, 1e-12);
  Positions points = randomPositions(400, 5);
  points.emplace_back(0, 0, 0);
  EXPECT_GT(neighborhoodThickness(openPoints(points), 400), 0.15);
}

} // namespace
} // namespace pcl::ccaa::test
