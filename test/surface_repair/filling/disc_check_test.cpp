// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the check that triangles are a disc.

#include <gtest/gtest.h>

#include "filling/disc_check.h"
#include "support/shapes.h"

namespace pcl::repair {
namespace {

TEST(DiscCheck, OneTriangleIsADisc) { EXPECT_TRUE(isDisc({{2, 1, 0}}, 3, 3)); }

TEST(DiscCheck, BorderMustBeRunThroughBackwards)
{
  EXPECT_FALSE(isDisc({{0, 1, 2}}, 3, 3));
}

TEST(DiscCheck, TwoTrianglesOfAQuadAreADisc)
{
  EXPECT_TRUE(isDisc({{2, 1, 0}, {3, 2, 0}}, 4, 4));
}

TEST(DiscCheck, EveryEdgeOfThePolygonNeedsItsTriangle)
{
  EXPECT_FALSE(isDisc({{2, 1, 0}}, 4, 4));
}

TEST(DiscCheck, VerticesMustBeUsed) { EXPECT_FALSE(isDisc({{2, 1, 0}}, 3, 4)); }

TEST(DiscCheck, CornersMustBeInRange)
{
  EXPECT_FALSE(isDisc({{2, 1, 7}}, 3, 3));
  EXPECT_FALSE(isDisc({{2, 1, -1}}, 3, 3));
  EXPECT_FALSE(isDisc({{2, 1, 1}}, 3, 3));
}

TEST(DiscCheck, ClosedShapeBesideTheDiscIsTooMuch)
{
  // A torus does not change the characteristic: only the connection tells.
  Triangles triangles = ccaa::test::torus(5, 5).triangles;
  for (Triangle& t : triangles)
    for (pcl::index_t& corner : t)
      corner += 3;
  triangles.push_back({2, 1, 0});
  EXPECT_FALSE(isDisc(triangles, 3, 28));
}

TEST(DiscCheck, HandleIsNoDisc)
{
  Triangles triangles = ccaa::test::torus(5, 5).triangles;
  const Triangle gone = triangles.back();
  triangles.pop_back();
  // Renumber so that the border is 0, 1, 2: the torus without a triangle has that one
  // against its direction.
  std::vector<pcl::index_t> number(25, -1);
  for (pcl::index_t i = 0; i < 3; ++i)
    number[static_cast<std::size_t>(gone[static_cast<std::size_t>(i)])] = i;
  pcl::index_t next = 3;
  for (pcl::index_t& n : number)
    n = n < 0 ? next++ : n;
  for (Triangle& t : triangles)
    for (pcl::index_t& corner : t)
      corner = number[static_cast<std::size_t>(corner)];
  EXPECT_FALSE(isDisc(triangles, 3, 25));
}

TEST(DiscCheck, EdgeWithThreeTrianglesIsRefused)
{
  EXPECT_FALSE(isDisc({{2, 1, 0}, {3, 2, 0}, {0, 2, 3}}, 4, 4));
}

TEST(DiscCheck, PinchedVertexIsRefused)
{
  // Two fans of three triangles at vertex 6, one polygon of six edges around both.
  EXPECT_FALSE(
      isDisc({{1, 0, 6}, {2, 1, 6}, {0, 2, 6}, {4, 3, 6}, {5, 4, 6}, {3, 5, 6}}, 6, 7));
}

} // namespace
} // namespace pcl::repair
