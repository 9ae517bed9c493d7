// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of bringing a mesh to condition C3.4-1.
#include "filter_helpers.h"

#include <cmath>

namespace pcl::ccaa::test {
namespace {

/** \brief Triangles on the edge 0-1 along z, at the given angles around it (degrees).
 */
Shape
book(const std::vector<double>& angles)
{
  Shape shape{{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, {}};
  for (const double angle : angles) {
    const double radians = angle * M_PI / 180.0;
    shape.triangles.push_back({0, 1, static_cast<pcl::index_t>(shape.vertices.size())});
    shape.vertices.emplace_back(std::cos(radians), std::sin(radians), 0.5);
  }
  return shape;
}

TEST(EdgeRepair, KeepsTheFlattestPair)
{
  const auto shape = book({0.0, 70.0, 175.0});
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_TRUE(sameUnorientedTriangles({{0, 1, 2}, {0, 1, 4}}, result.triangles));
  EXPECT_EQ(result.report.overfull_edges, 1u);
  EXPECT_EQ(result.report.overfull_triangles, 1u);
}

TEST(EdgeRepair, DropsAllWhereNothingTellsThePairs)
{
  for (const auto& angles : {std::vector<double>{0.0, 120.0, 240.0},
                             std::vector<double>{0.0, 90.0, 180.0, 270.0}}) {
    const auto shape = book(angles);
    const auto result = filtered(shape);
    expectCertified(shape, result);
    EXPECT_TRUE(result.triangles.empty());
    EXPECT_EQ(result.report.overfull_triangles, angles.size());
  }
}

TEST(EdgeRepair, PrefersTheSurfaceToALooseFin)
{
  auto shape = icosphere(2);
  const Triangle first = shape.triangles[0];
  shape.triangles.push_back(
      {first[0], first[1], static_cast<pcl::index_t>(shape.vertices.size())});
  shape.vertices.push_back(2.0 * shape.vertices[static_cast<std::size_t>(first[0])]);
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_EQ(result.report.overfull_triangles, 1u);
  EXPECT_EQ(result.report.free_points, 1u);
  EXPECT_EQ(result.triangles.size(), shape.triangles.size() - 1);
}

TEST(EdgeRepair, PrefersUnfoldedPairsToWellSupportedOnes)
{
  // a fold at the rim of a sheet: both folded triangles have neighbours, but lie on
  // each other
  auto shape = book({0.0, 10.0, 180.0});
  shape.triangles.push_back({0, 2, 5});
  shape.triangles.push_back({0, 3, 5});
  shape.triangles.push_back({1, 2, 6});
  shape.triangles.push_back({1, 3, 6});
  shape.vertices.emplace_back(1.0, 0.1, -1.0);
  shape.vertices.emplace_back(1.0, 0.1, 2.0);
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_TRUE(isSubsetOf({{0, 1, 4}}, result.triangles));
}

TEST(EdgeRepair, CountsDuplicatesApartFromOverfullEdges)
{
  auto shape = icosphere(1);
  const Triangle first = shape.triangles[0];
  shape.triangles.push_back({first[2], first[1], first[0]});
  shape.triangles.push_back({first[1], first[2], first[0]});
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_EQ(result.report.duplicate_triangles, 2u);
  EXPECT_EQ(result.report.overfull_edges, 0u);
  EXPECT_EQ(result.report.overfull_triangles, 0u);
  EXPECT_EQ(result.triangles.size(), 80u);
}

TEST(EdgeRepair, FindsALonelyTriangleThatIsThereTwice)
{
  Shape shape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_EQ(result.triangles.size(), 1u);
  EXPECT_EQ(result.report.duplicate_triangles, 1u);
  EXPECT_EQ(result.roles[0], PointRole::BOUNDARY);
}

TEST(EdgeRepair, SurvivesTrianglesWithoutArea)
{
  auto shape = book({0.0, 100.0, 180.0});
  shape.triangles.push_back({0, 1, 5});
  shape.triangles.push_back({0, 1, 6});
  shape.vertices.emplace_back(0.0, 0.0, 3.0);
  shape.vertices.emplace_back(0.0, 0.0, 0.0);
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_TRUE(sameUnorientedTriangles({{0, 1, 2}, {0, 1, 4}}, result.triangles));
}

TEST(EdgeRepair, EndsQuicklyOnAnEdgeWithVeryManyTriangles)
{
  std::vector<double> angles(20000);
  for (std::size_t i = 0; i < angles.size(); ++i)
    angles[i] = static_cast<double>(i) * 0.017;
  const auto shape = book(angles);
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_TRUE(result.triangles.empty());
}

TEST(EdgeRepair, DoesNotDependOnNumbering)
{
  auto shape = grid(8, 8);
  for (pcl::index_t i = 0; i < 5; ++i) {
    shape.triangles.push_back({9 * i + 9, 9 * i + 10, 64 + i});
    shape.vertices.emplace_back(i + 1.5, i + 1.7, 0.3 * i);
  }
  const auto expected = filtered(shape);
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const auto other = shuffled(shape, seed);
    const auto result = filtered(other);
    expectCertified(other, result);
    EXPECT_EQ(result.triangles.size(), expected.triangles.size());
  }
}

} // namespace
} // namespace pcl::ccaa::test
