// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the umbrella filter promises for any input.
#include "filter_helpers.h"
#include "umbrella/chain_case.h"
#include "umbrella/edge_repair.h"

namespace pcl::ccaa::test {
namespace {

/** \brief Soups from sparse to so dense that every edge is overfull. */
std::vector<Shape>
soups()
{
  std::vector<Shape> all;
  for (unsigned int seed = 0; seed < 200; ++seed)
    all.push_back(
        randomSoup(5 + static_cast<int>(seed % 40), 2 + (seed * 7) % 120, 1000 + seed));
  for (unsigned int seed = 0; seed < 20; ++seed) {
    all.push_back(damaged(icosphere(2), 0.02 + 0.02 * seed, seed));
    all.push_back(damaged(grid(12, 9), 0.02 + 0.02 * seed, seed));
  }
  return all;
}

TEST(UmbrellaInvariants, AnyInputBecomesAnIcadm)
{
  for (const auto& soup : soups())
    for (const std::size_t minimum : {0u, 1u, 10u})
      expectCertified(soup, filtered(soup, minimum));
}

TEST(UmbrellaInvariants, FilteringTwiceChangesNothing)
{
  for (const auto& soup : soups())
    for (const std::size_t minimum : {0u, 3u}) {
      const auto once = filtered(soup, minimum);
      const auto twice = filtered({soup.vertices, once.triangles}, minimum);
      ASSERT_EQ(once.triangles, twice.triangles);
      ASSERT_EQ(once.roles, twice.roles);
      ASSERT_EQ(twice.report.overfull_triangles + twice.report.umbrella_triangles +
                    twice.report.small_region_triangles,
                0u);
    }
}

TEST(UmbrellaInvariants, NumberingOfPointsAndPolygonsDoesNotMatter)
{
  for (const auto& soup : soups()) {
    const auto expected = filtered(soup, 1);
    const auto other = shuffled(soup, 77);
    const auto result = filtered(other, 1);
    const auto centres = [](const Shape& shape, const Triangles& triangles) {
      std::vector<std::array<double, 3>> list;
      for (const auto& triangle : triangles) {
        Position low = shape.vertices[static_cast<std::size_t>(triangle[0])],
                 high = low;
        for (const auto corner : triangle) {
          low = low.cwiseMin(shape.vertices[static_cast<std::size_t>(corner)]);
          high = high.cwiseMax(shape.vertices[static_cast<std::size_t>(corner)]);
        }
        const Position centre = low + high;
        list.push_back({centre.x(), centre.y(), centre.z()});
      }
      std::sort(list.begin(), list.end());
      return list;
    };
    ASSERT_EQ(centres(soup, expected.triangles), centres(other, result.triangles));
  }
}

TEST(UmbrellaInvariants, ThreadsDoNotMatter)
{
  for (const auto& shape : {damaged(torus(200, 150), 0.05, 3),
                            randomSoup(20000, 60000, 4),
                            shuffled(damaged(terrain(150, 150), 0.2, 5), 6)}) {
    const auto expected = filtered(shape, 10, 1);
    expectCertified(shape, expected);
    for (const unsigned threads : {2u, 7u}) {
      const auto result = filtered(shape, 10, threads);
      ASSERT_EQ(expected.triangles, result.triangles);
      ASSERT_EQ(expected.roles, result.roles);
      EXPECT_EQ(expected.report.umbrella_triangles, result.report.umbrella_triangles);
    }
  }
}

/** \brief A cone around a vertex: a second closed chain there. */
void
addCone(Shape& shape, pcl::index_t apex)
{
  const auto first = static_cast<pcl::index_t>(shape.vertices.size());
  const Position at = shape.vertices[static_cast<std::size_t>(apex)];
  shape.vertices.insert(shape.vertices.end(),
                        {at + Position(0.2, 0.0, 1.0),
                         at + Position(-0.1, 0.2, 1.0),
                         at + Position(-0.1, -0.2, 1.0)});
  for (pcl::index_t i = 0; i < 3; ++i)
    shape.triangles.push_back({apex, first + i, first + (i + 1) % 3});
}

TEST(UmbrellaInvariants, DeletionReachesPointsThatWereSoundBefore)
{
  // row 5 takes all triangles left and right of vertex 40, the middle of the grid,
  // which leaves two open chains of one triangle there: row 3 for a point of row 1
  auto shape = grid(9, 9);
  const auto untouched = filtered(shape);
  EXPECT_EQ(untouched.roles[40], PointRole::INTERNAL);
  addCone(shape, 39);
  addCone(shape, 41);
  const auto result = filtered(shape);
  expectCertified(shape, result);
  EXPECT_EQ(result.roles[39], PointRole::FREE);
  EXPECT_EQ(result.roles[41], PointRole::FREE);
  EXPECT_EQ(result.roles[40], PointRole::BOUNDARY);
  EXPECT_EQ(result.report.umbrella_triangles, 2u * (6u + 3u) + 1u);
}

/** \brief The table applied to everything again and again, without any bookkeeping. */
Triangles
plainUmbrella(Triangles triangles, const Positions& positions)
{
  for (bool changed = true; changed;) {
    TriangleAdjacency adjacency;
    adjacency.build(triangles, positions.size());
    AliveFlags alive(triangles.size(), 1);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const auto vertex = static_cast<pcl::index_t>(i);
      PointChains chains;
      chains.find(triangles, adjacency, vertex);
      const auto survivor = survivingChain(chains, triangles, positions, vertex);
      for (std::size_t place = 0; place < chains.chains().size(); ++place)
        for (std::size_t k = 0; k < chains.chains()[place].size; ++k)
          if (survivor != place)
            alive[static_cast<std::size_t>(
                chains.triangles()[chains.chains()[place].first + k])] = 0;
    }
    Triangles kept;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      if (alive[i] != 0)
        kept.push_back(triangles[i]);
    changed = kept.size() != triangles.size();
    triangles = kept;
  }
  return triangles;
}

TEST(UmbrellaInvariants, AgreesWithThePlainWay)
{
  for (const auto& soup : soups()) {
    TriangleAdjacency adjacency;
    adjacency.build(soup.triangles, soup.vertices.size());
    AliveFlags alive(soup.triangles.size(), 1);
    repairNonManifoldEdges(soup.triangles, adjacency, soup.vertices, {}, alive);
    Triangles repaired;
    for (std::size_t i = 0; i < alive.size(); ++i)
      if (alive[i] != 0)
        repaired.push_back(soup.triangles[i]);
    const auto expected = plainUmbrella(repaired, soup.vertices);
    UmbrellaFilter filter;
    filter.setMinimumInternalPoints(0);
    filter.setConsistentOrientation(false);
    ASSERT_TRUE(sameUnorientedTriangles(expected, filterWith(filter, soup).triangles));
  }
}

} // namespace
} // namespace pcl::ccaa::test
