// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of bodies that are thinner than the spacing of their
// points.
#include "chain_fixture.h"
#include "mesh/surface_topology.h"
#include "support/random_source.h"

namespace pcl {
namespace ccaa {
namespace test {
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

void
expectNoTunnels(const Wedge& wedge)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Positions points = sampled(wedge, seed);
    Chain chain;
    chain.setInputCloud(toCloud(points));
    Polygons polygons;
    chain.reconstruct(polygons);
    const Triangles triangles = toTriangles(polygons);
    TriangleAdjacency adjacency;
    adjacency.build(triangles, points.size());
    const SurfaceTopology topology = topologyOf(triangles, adjacency);
    EXPECT_EQ(0, topology.genus) << seed;
    EXPECT_EQ(1U, topology.pieces) << seed;
    EXPECT_EQ(polygons.size(), chain.getTriangleLabels().size()) << seed;
  }
}

TEST(ThinBlade, HasNoTunnels) { expectNoTunnels(BLADE); }

/** The start connects the sides all over. */
TEST(ThinPlate, HasNoTunnels) { expectNoTunnels(PLATE); }

} // namespace
} // namespace test
} // namespace ccaa
} // namespace pcl
