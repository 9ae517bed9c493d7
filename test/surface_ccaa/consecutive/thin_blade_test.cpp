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

/** Points on a closed wedge, one at random in each square of a grid on its faces: 4
 * long, 1.5 wide, 0.5 thick at one end and 0.04 at the other, with points 0.05 apart.
 */
Positions
wedge(std::uint64_t seed)
{
  constexpr double LENGTH = 4.0, WIDTH = 1.5, THICK = 0.5, TIP = 0.04, SPACING = 0.05;
  RandomSource random(seed);
  Positions points;
  const auto halfAt = [](double x) {
    return 0.5 * (THICK + (TIP - THICK) * x / LENGTH);
  };
  const auto sample = [&](double columns, double rows, const auto& place) {
    for (double i = 0; i + 0.5 < columns; ++i)
      for (double j = 0; j + 0.5 < rows; ++j)
        points.push_back(
            place((i + random.uniform()) / columns, (j + random.uniform()) / rows));
  };
  const double along = LENGTH / SPACING, across = WIDTH / SPACING;
  for (const double side : {-1.0, 1.0}) {
    sample(along, across, [&](double u, double v) {
      return Position(LENGTH * u, WIDTH * v, side * halfAt(LENGTH * u));
    });
    for (double k = 0; k < along; ++k)
      sample(1.0,
             std::max(1.0, std::floor(2.0 * halfAt(LENGTH * k / along) / SPACING)),
             [&](double u, double v) {
               const double x = LENGTH * (k + u) / along;
               return Position(
                   x, WIDTH * (0.5 + 0.5 * side), halfAt(x) * (2.0 * v - 1.0));
             });
  }
  sample(THICK / SPACING, across, [&](double u, double v) {
    return Position(0.0, WIDTH * v, THICK * (u - 0.5));
  });
  sample(1.0, across, [&](double u, double v) {
    return Position(LENGTH, WIDTH * v, TIP * (u - 0.5));
  });
  return points;
}

TEST(ThinBlade, HasNoTunnels)
{
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Positions points = wedge(seed);
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

} // namespace
} // namespace test
} // namespace ccaa
} // namespace pcl
