// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of bodies that are thinner than the spacing of their
// points.
#include "chain_fixture.h"
#include "mesh/surface_topology.h"
#include "support/clouds.h"
#include "support/random_source.h"
#include "support/shapes.h"
#include "support/shared_data.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pcl::ccaa::test {
namespace {

struct Wedge {
  double length, width;
  double thick, tip; /**< thickness at its two ends */
};

constexpr Wedge BLADE{4.0, 1.5, 0.5, 0.04};
constexpr Wedge PLATE{3.0, 2.0, 0.06, 0.06};

/** Points on a closed wedge, 0.05 apart, one at random in each square of a grid on its
 * faces. */
Positions
sampled(const Wedge& wedge, std::uint64_t seed)
{
  constexpr double SPACING = 0.05;
  const double length = wedge.length, width = wedge.width;
  const double thick = wedge.thick, tip = wedge.tip;
  RandomSource random(seed);
  Positions points;
  const auto halfAt = [&](double x) {
    return 0.5 * (thick + (tip - thick) * x / length);
  };
  const auto sample = [&](double columns, double rows, const auto& place) {
    for (double i = 0; i + 0.5 < columns; ++i)
      for (double j = 0; j + 0.5 < rows; ++j)
        points.push_back(
            place((i + random.uniform()) / columns, (j + random.uniform()) / rows));
  };
  const double along = length / SPACING, across = width / SPACING;
  for (const double side : {-1.0, 1.0}) {
    sample(along, across, [&](double u, double v) {
      return Position(length * u, width * v, side * halfAt(length * u));
    });
    for (double k = 0; k < along; ++k)
      sample(1.0,
             std::max(1.0, std::floor(2.0 * halfAt(length * k / along) / SPACING)),
             [&](double u, double v) {
               const double x = length * (k + u) / along;
               return Position(
                   x, width * (0.5 + 0.5 * side), halfAt(x) * (2.0 * v - 1.0));
             });
  }
  sample(thick / SPACING, across, [&](double u, double v) {
    return Position(0.0, width * v, thick * (u - 0.5));
  });
  sample(1.0, across, [&](double u, double v) {
    return Position(length, width * v, tip * (u - 0.5));
  });
  return points;
}

SurfaceTopology
reconstructed(const Positions& points, Chain& chain)
{
  chain.setInputCloud(toCloud(points));
  Polygons polygons;
  chain.reconstruct(polygons);
  EXPECT_EQ(polygons.size(), chain.getTriangleLabels().size());
  const Triangles triangles = toTriangles(polygons);
  TriangleAdjacency adjacency;
  adjacency.build(triangles, points.size());
  return topologyOf(triangles, adjacency);
}

void
expectNoTunnels(const Wedge& wedge, const std::vector<std::uint64_t>& seeds)
{
  for (const std::uint64_t seed : seeds) {
    Chain chain;
    const SurfaceTopology topology = reconstructed(sampled(wedge, seed), chain);
    EXPECT_EQ(0, topology.genus) << seed;
    EXPECT_EQ(1U, topology.pieces) << seed;
    EXPECT_EQ(0U, chain.getReport().doubts.handles) << seed;
  }
}

/** Where fans touched at a point and one of them went, a hole was left. */
TEST(Fandisk, IsClosedWhicheverAxisComesFirst)
{
  const std::string path = sharedData("fandisk/fandisk_large.ply");
  SKIP_WITHOUT_DATA(path);
  Shape fandisk;
  ASSERT_TRUE(readShape(path, fandisk));
  for (int turn = 0; turn < 3; ++turn) {
    Chain chain;
    EXPECT_EQ(reconstructed(fandisk.vertices, chain).boundary_loops, 0U) << turn;
    for (Position& point : fandisk.vertices)
      point = Position(point.y(), point.z(), point.x());
  }
}

TEST(ThinBlade, HasNoTunnels) { expectNoTunnels(BLADE, {1, 2, 3}); }

/** The start connects the sides all over. */
TEST(ThinPlate, HasNoTunnels) { expectNoTunnels(PLATE, {1, 2, 3}); }

/** So many thin places are tried in part first, as they could be noise. */
TEST(ThinPlate, HasNoTunnelsWhereItIsLarge)
{
  expectNoTunnels({4.0, 3.0, 0.06, 0.06}, {3});
}

/** Half a spacing and less apart, the sides are one layer of points for any start. */
TEST(ThinPlate, HasNoHandlesThatAreNotInDoubt)
{
  std::size_t wrong = 0, placed = 0;
  for (const double thick : {0.03, 0.01})
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      Chain chain;
      const long genus = reconstructed(sampled({3.0, 2.0, thick, thick}, seed), chain)
                             .genus.value_or(0);
      wrong += genus != 0 ? 1 : 0;
      placed += chain.getReport().doubts.thin_handles.empty() ? 0 : 1;
      EXPECT_EQ(static_cast<std::size_t>(genus), chain.getReport().doubts.handles)
          << thick << " " << seed;
    }
  EXPECT_GT(wrong, 0U);
  EXPECT_EQ(wrong, placed);
}

/** A torus of 125 times five random points. */
Positions
wire(std::uint64_t seed)
{
  constexpr double THICK = 0.04;
  RandomSource random(seed);
  Positions points;
  for (int i = 0; i < 125; ++i)
    for (int j = 0; j < 5; ++j) {
      const double along = 2.0 * M_PI * (i + random.uniform(-0.3, 0.3)) / 125.0;
      const double around = 2.0 * M_PI * (j + random.uniform(-0.3, 0.3)) / 5.0;
      const double radius = 1.0 + THICK * std::cos(around);
      points.emplace_back(
          radius * std::cos(along), radius * std::sin(along), THICK * std::sin(around));
    }
  return points;
}

/** Each has a place that grows anew as two ends, which has a handle less. */
TEST(Wire, IsNotCutToLoseItsHandle)
{
  for (const std::uint64_t seed : {89, 172, 195}) {
    Chain chain;
    EXPECT_EQ(1, reconstructed(wire(seed), chain).genus) << seed;
    EXPECT_EQ(1U, chain.getReport().doubts.handles) << seed;
  }
}

/** Each comes out as one closed piece without a handle. */
TEST(Wire, ThatIsCutThroughIsInDoubt)
{
  for (const std::uint64_t seed : {3, 4, 29, 292}) {
    Chain chain;
    const SurfaceTopology topology = reconstructed(wire(seed), chain);
    EXPECT_TRUE(topology.genus == 1 ||
                !chain.getReport().doubts.touching_pieces.empty())
        << seed;
  }
}

/** Walls that are sampled more coarsely than they are thick. */
TEST(ThinWalls, OfRealModelsHaveTheirHandlesAndNoOpenings)
{
  const std::vector<std::pair<std::string, long>> models = {
      {"skull/skull.ply", 2}, {"cad_daratech/daratech.ply", 7}};
  for (const auto& [file, handles] : models) {
    const std::string path = sharedData(file);
    SKIP_WITHOUT_DATA(path);
    Shape model;
    ASSERT_TRUE(readShape(path, model));
    Chain chain;
    const SurfaceTopology topology = reconstructed(model.vertices, chain);
    EXPECT_EQ(handles, topology.genus) << file;
    EXPECT_EQ(0U, topology.boundary_loops) << file;
  }
}

TEST(Torus, HasAHandleThatIsNotInDoubt)
{
  Chain chain;
  EXPECT_EQ(1, reconstructed(torus(60, 30).vertices, chain).genus);
  EXPECT_EQ(0U, chain.getReport().doubts.handles);
}

/** Of 2000 points each, 0.4 spacings apart. */
Positions
touchingSpheres()
{
  const Shape sphere{fibonacciSphere(2000), {}};
  return joined(sphere, translated(sphere, {2.035, 0.0, 0.0})).vertices;
}

TEST(TouchingSpheres, HaveANeckAtAPointBetweenThem)
{
  const Positions points = touchingSpheres();
  Chain chain;
  reconstructed(points, chain);
  const auto& necks = chain.getReport().doubts.thin_necks;
  ASSERT_EQ(1U, necks.size());
  EXPECT_LT(
      (points[static_cast<std::size_t>(necks[0])] - Position(1.0175, 0, 0)).norm(),
      0.3);
}

/** A slab with a ball on it, so near that nothing tells whether they touch. */
Positions
ballOnSlab(std::uint64_t seed)
{
  constexpr double GAP = 0.02;
  Positions points = sampled({2.0, 2.0, 0.4, 0.4}, seed);
  RandomSource random(seed + 100);
  for (int i = 0; i < 5000; ++i) {
    const double z = random.uniform(-1.0, 1.0), angle = random.uniform(0.0, 2.0 * M_PI);
    const double radius = std::sqrt(1.0 - z * z);
    points.emplace_back(
        1.0 + radius * std::cos(angle), 1.0 + radius * std::sin(angle), 1.2 + GAP + z);
  }
  return points;
}

TEST(ABallOnASlab, IsTwoPiecesOrInDoubtNearlyAlways)
{
  std::size_t glued = 0, told = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Chain chain;
    if (reconstructed(ballOnSlab(seed), chain).pieces == 2)
      continue;
    ++glued;
    const TopologyDoubts& doubts = chain.getReport().doubts;
    told += doubts.handles + doubts.thin_necks.size() > 0 ? 1 : 0;
  }
  EXPECT_GT(glued, 4U);
  EXPECT_LE(glued, told + 1);
}

/** Vertices of the surface are numbered without them. */
TEST(TouchingSpheres, HaveTheirNeckAtTheSamePointBehindPointsThatAreNotFinite)
{
  const Positions points = touchingSpheres();
  Positions more(3, Position::Constant(std::numeric_limits<double>::quiet_NaN()));
  more.insert(more.end(), points.begin(), points.end());
  Chain chain, chain_of_more;
  reconstructed(points, chain);
  reconstructed(more, chain_of_more);
  EXPECT_EQ(chain.getReport().doubts.thin_necks.at(0) + 3,
            chain_of_more.getReport().doubts.thin_necks.at(0));
}

} // namespace
} // namespace pcl::ccaa::test
