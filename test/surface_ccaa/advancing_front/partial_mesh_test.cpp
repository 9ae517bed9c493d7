// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what ProjectionCompletion makes of partial meshes.
#include "completion_helpers.h"

#include <functional>
#include <limits>

namespace pcl::ccaa::test {
namespace {

/** A correct surface and what is known of it. */
struct Surface {
  const char* name;
  std::function<Shape()> shape;
  std::size_t components;
  long genus;
  std::size_t loops;
};

const Surface SURFACES[] = {
    {"Sphere", [] { return icosphere(3); }, 1, 0, 0},
    {"Torus", [] { return torus(48, 20); }, 1, 1, 0},
    {"Cube", [] { return cube(10); }, 1, 0, 0},
    {"NestedSpheres", [] { return nestedSpheres(3); }, 2, 0, 0},
    {"NoisySphere", [] { return noisyIcosphere(3, 0.01); }, 1, 0, 0},
    {"ThinPlateWithRim", [] { return box(14, 14, 2); }, 1, 0, 0},
    {"ThinPlate", [] { return thinPlate(16, 16, 5.0); }, 2, 0, 2},
    {"Terrain", [] { return terrain(28, 28); }, 1, 0, 1},
};

/** A way to lose triangles. */
struct Loss {
  const char* name;
  std::function<Shape(const Shape&, std::uint64_t)> apply;
};

const Loss LOSSES[] = {
    {"FewTriangles",
     [](const Shape& shape, std::uint64_t seed) {
       return withoutRandomTriangles(shape, 0.03, seed);
     }},
    {"ManyTriangles",
     [](const Shape& shape, std::uint64_t seed) {
       return withoutRandomTriangles(shape, 0.2, seed);
     }},
    {"Patches",
     [](const Shape& shape, std::uint64_t seed) {
       return withoutPatches(shape, 6, 1, seed);
     }},
    {"WidePatches",
     [](const Shape& shape, std::uint64_t seed) {
       return withoutPatches(shape, 3, 3, seed);
     }},
};

using Case = std::tuple<Surface, Loss>;

class PartialMeshOf : public CompletionTest,
                      public ::testing::WithParamInterface<Case> {
protected:
  static constexpr std::uint64_t SEEDS = 3;

  static Shape
  partial(std::uint64_t seed)
  {
    const auto& [surface, loss] = GetParam();
    return filteredToIcadm(loss.apply(roundedToFloat(surface.shape()), seed));
  }

  static std::size_t
  shortestLoop(const MeshFacts& facts)
  {
    std::size_t shortest = std::numeric_limits<std::size_t>::max();
    for (const BoundaryLoopFacts& loop : facts.boundary_loops)
      shortest = std::min(shortest, loop.edges);
    return shortest;
  }

  static void
  expectWhole(const Triangles& triangles, const Positions& points)
  {
    const Surface& surface = std::get<0>(GetParam());
    if (surface.loops == 0) {
      expectClosed(triangles, points, surface.components, surface.genus);
      return;
    }
    const MeshFacts facts = expectSound(triangles, points);
    EXPECT_EQ(facts.components, surface.components);
    EXPECT_EQ(facts.boundary_loops.size(), surface.loops)
        << "shortest " << shortestLoop(facts) << " edges";
    EXPECT_EQ(facts.free_vertices, 0u);
  }
};

TEST_P(PartialMeshOf, KeepsEveryGivenTriangleInOrder)
{
  for (std::uint64_t seed = 0; seed < SEEDS; ++seed) {
    SCOPED_TRACE(seed);
    const Shape given = partial(seed);
    EXPECT_TRUE(keepsGiven(given.triangles, complete(given)));
  }
}

TEST_P(PartialMeshOf, BecomesWholeAgain)
{
  for (std::uint64_t seed = 0; seed < SEEDS; ++seed) {
    SCOPED_TRACE(seed);
    const Shape given = partial(seed);
    expectWhole(complete(given), given.vertices);
  }
}

TEST_P(PartialMeshOf, BecomesWholeWithEverySecondIslandTurnedOver)
{
  for (std::uint64_t seed = 0; seed < SEEDS; ++seed) {
    SCOPED_TRACE(seed);
    Shape given = partial(seed);
    given.triangles = withEverySecondPieceReversed(given.triangles);
    const Triangles triangles = complete(given);
    EXPECT_TRUE(keepsGiven(given.triangles, triangles));
    expectWhole(triangles, given.vertices);
  }
}

TEST_P(PartialMeshOf, IsAlsoCompletedWhenGivenTrianglesMayBeReplaced)
{
  completion_.setKeepGiven(false);
  for (std::uint64_t seed = 0; seed < SEEDS; ++seed) {
    SCOPED_TRACE(seed);
    const Shape given = partial(seed);
    const Triangles triangles = complete(given);
    expectWhole(triangles, given.vertices);
    const std::vector<index_t>* kept = completion_.keptTriangles();
    ASSERT_NE(kept, nullptr);
    EXPECT_TRUE(std::is_sorted(kept->begin(), kept->end(), std::less_equal<>()));
    Triangles begin;
    for (const index_t t : *kept)
      begin.push_back(given.triangles.at(std::size_t(t)));
    EXPECT_TRUE(keepsGiven(begin, triangles));
    EXPECT_EQ(completion_.getReport().kept_triangles, kept->size());
  }
}

INSTANTIATE_TEST_SUITE_P(Completion,
                         PartialMeshOf,
                         ::testing::Combine(::testing::ValuesIn(SURFACES),
                                            ::testing::ValuesIn(LOSSES)),
                         [](const auto& one) {
                           return std::string(std::get<0>(one.param).name) +
                                  std::get<1>(one.param).name;
                         });

using PartialMeshes = CompletionTest;

/** A sphere whose cap above a height is not sampled. */
Shape
withoutCap(const Shape& shape, double height)
{
  Shape open;
  std::vector<index_t> number(shape.vertices.size(), -1);
  for (std::size_t v = 0; v < shape.vertices.size(); ++v)
    if (shape.vertices[v].z() < height) {
      number[v] = static_cast<index_t>(open.vertices.size());
      open.vertices.push_back(shape.vertices[v]);
    }
  for (Triangle t : shape.triangles) {
    for (index_t& corner : t)
      corner = number[std::size_t(corner)];
    if (*std::min_element(t.begin(), t.end()) >= 0)
      open.triangles.push_back(t);
  }
  return open;
}

TEST_F(PartialMeshes, WithAHoleMuchWiderThanTheSpacingStayOpen)
{
  const Shape given = filteredToIcadm(withoutCap(icosphere(4), 0.8));
  const Triangles triangles = complete(given);
  EXPECT_TRUE(keepsGiven(given.triangles, triangles));
  const MeshFacts facts = expectSound(triangles, given.vertices);
  ASSERT_EQ(facts.boundary_loops.size(), 1u);
  EXPECT_EQ(facts.euler_characteristic, 1);
}

TEST_F(PartialMeshes, ThatAreWholeStayAsTheyAre)
{
  const Shape given = icosphere(3);
  EXPECT_EQ(complete(given), given.triangles);
}

TEST_F(PartialMeshes, ThatAreWoundInwardAreTurnedOver)
{
  Shape given = icosphere(3);
  const Triangles outward = given.triangles;
  given.triangles = reversed(given.triangles);
  EXPECT_TRUE(sameTriangles(outward, complete(given)));
}

TEST_F(PartialMeshes, WithASinglePointInAHoleUseIt)
{
  const Shape given = withoutPatches(icosphere(3), 1, 0, 3);
  const Triangles triangles = complete(given);
  expectClosed(triangles, given.vertices, 1, 0);
}

TEST_F(PartialMeshes, WithAGapOfOneTriangleGetIt)
{
  const Shape whole = icosphere(3);
  EXPECT_TRUE(sameTriangles(whole.triangles, complete(withoutTriangles(whole, {77}))));
}

/** A floor with a hole in the middle, through which a wall goes. */
Shape
floorWithWall()
{
  Shape floor = translated(grid(15, 15), {-7.0, -7.0, 0.0});
  std::vector<std::size_t> removed;
  for (std::size_t t = 0; t < floor.triangles.size(); ++t)
    for (const index_t corner : floor.triangles[t])
      if (floor.vertices[std::size_t(corner)].norm() < 1.1) {
        removed.push_back(t);
        break;
      }
  floor = withoutTriangles(floor, removed);
  for (Position& vertex : floor.vertices)
    if (vertex.norm() < 1.1)
      vertex.z() = -40.0; // out of the way
  Shape wall = translated(grid(12, 12), {-5.5, -5.5, 0.0});
  for (Position& vertex : wall.vertices)
    vertex = Position(0.05, 0.1 * vertex.x(), vertex.y());
  return joined(floor, wall);
}

TEST_F(PartialMeshes, AreNotCrossedByNewTriangles)
{
  const Shape given = floorWithWall();
  const Triangles triangles = complete(given);
  EXPECT_TRUE(keepsGiven(given.triangles, triangles));
  expectSound(triangles, given.vertices);
}

TEST_F(PartialMeshes, WithTrianglesMuchLongerThanTheSpacingAreNotCrossed)
{
  // a long closed needle through the hole of a fine floor
  const Shape floor = translated(grid(41, 41), {-20.0, -20.0, 0.0});
  std::vector<std::size_t> removed;
  for (std::size_t t = 0; t < floor.triangles.size(); ++t)
    for (const index_t corner : floor.triangles[t])
      if (floor.vertices[std::size_t(corner)].norm() < 0.5) {
        removed.push_back(t);
        break;
      }
  const Shape needle{{{0.3, 0.2, -70}, {0.4, 0.2, -70}, {0.3, 0.3, 70}, {0.2, 0.2, 70}},
                     tetrahedron().triangles};
  Shape given = joined(withoutTriangles(floor, removed), needle);
  given.vertices[840].z() = -70.0; // the middle, which would cover the hole
  const Triangles triangles = complete(given);
  EXPECT_TRUE(keepsGiven(given.triangles, triangles));
  EXPECT_EQ(*factsOf(given.triangles, given.vertices).self_intersections, 0u);
  EXPECT_EQ(*factsOf(triangles, given.vertices).self_intersections, 0u);
}

TEST_F(PartialMeshes, WithoutPolygonsAreAReconstruction)
{
  const Positions points = bumpySphere(800);
  const Triangles expected = reconstruct(points);
  EXPECT_EQ(complete({points, {}}), expected);
}

TEST_F(PartialMeshes, WithoutACloudOfTheirOwnAreTaken)
{
  const Shape given = withoutPatches(icosphere(2), 1, 0, 1);
  auto mesh = std::make_shared<PolygonMesh>();
  mesh->polygons = toPolygons(given.triangles);
  completion_.setInputCloud(toCloud(given.vertices));
  completion_.setPartialMesh(mesh);
  EXPECT_TRUE(keepsGiven(given.triangles, run()));
}

TEST_F(PartialMeshes, KeepTrianglesOfPointsThatAreNotAmongTheIndices)
{
  const Shape given = withoutPatches(icosphere(3), 2, 1, 7);
  completion_.setIndices(std::make_shared<Indices>(Indices{0, 1, 2, 3}));
  EXPECT_TRUE(keepsGiven(given.triangles, complete(given)));
}

TEST_F(PartialMeshes, GetNoNewTrianglesOnFreePointsThatAreNotAmongTheIndices)
{
  const Shape given = withoutPatches(icosphere(3), 1, 1, 7);
  const std::set<index_t> used = usedPoints(given.triangles);
  completion_.setIndices(std::make_shared<Indices>(used.begin(), used.end()));
  EXPECT_EQ(usedPoints(complete(given)), used);
}

TEST_F(PartialMeshes, AreCountedInTheReport)
{
  const Shape given = withoutPatches(icosphere(3), 1, 1, 7);
  const Triangles triangles = complete(given);
  const CompletionReport& report = completion_.getReport();
  EXPECT_EQ(report.given_triangles, given.triangles.size());
  EXPECT_EQ(report.kept_triangles, given.triangles.size());
  EXPECT_EQ(report.new_triangles, triangles.size() - given.triangles.size());
  EXPECT_EQ(report.free_points, given.vertices.size() - usedPoints(triangles).size());
  EXPECT_FALSE(report.cancelled);
}

TEST_F(PartialMeshes, ThatAreKeptWholeReportNoSelection)
{
  complete(withoutPatches(icosphere(2), 1, 0, 7));
  EXPECT_EQ(completion_.keptTriangles(), nullptr);
}

} // namespace
} // namespace pcl::ccaa::test
