// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of ends of a surface that face each other.
#include <gtest/gtest.h>

#include "mesh/facing_ends.h"
#include "mesh/sharp_edges.h"
#include "support/completion_shapes.h"
#include "support/shapes.h"

#include <cmath>
#include <cstddef>

namespace pcl::ccaa::test {
namespace {

constexpr int RINGS = 60, AROUND = 5;
constexpr double THICK = 0.09;

/** A closed tube along a circle but for some rings of vertices, with a vertex in the
 * middle of each end. */
Shape
bentWire(int missing)
{
  const int left = RINGS - missing;
  Shape wire;
  const auto place = [](int i, int j, double thick) {
    const double u = 2.0 * M_PI * i / RINGS, v = 2.0 * M_PI * j / AROUND;
    const double radius = 1.0 + thick * std::cos(v);
    return Position(radius * std::cos(u), radius * std::sin(u), thick * std::sin(v));
  };
  const auto at = [&](int i, int j) { return AROUND * i + j % AROUND; };
  for (int i = 0; i < left; ++i)
    for (int j = 0; j < AROUND; ++j)
      wire.vertices.push_back(place(i, j, THICK));
  wire.vertices.push_back(place(0, 0, 0.0));
  wire.vertices.push_back(place(left - 1, 0, 0.0));
  for (int j = 0; j < AROUND; ++j) {
    for (int i = 0; i + 1 < left; ++i) {
      wire.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      wire.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    wire.triangles.push_back({at(0, j), at(0, j + 1), at(left, 0)});
    wire.triangles.push_back({at(left - 1, j + 1), at(left - 1, j), at(left, 1)});
  }
  return wire;
}

std::vector<Contact>
facingEnds(const Shape& shape)
{
  const TriangleAdjacency adjacency = adjacencyOf(shape);
  const PointView points(shape.vertices);
  return facingEnds(findSharpEdges(shape.triangles, adjacency, points, {}).convex,
                    shape.triangles,
                    adjacency,
                    points);
}

TEST(FacingEnds, OfAWireThatIsCutThroughAreToldOnce)
{
  const std::vector<Contact> ends = facingEnds(bentWire(0));
  ASSERT_EQ(1U, ends.size());
  const int half = AROUND * RINGS / 2;
  const auto isFirst = [&](pcl::index_t v) { return v < half || v == AROUND * RINGS; };
  EXPECT_NE(isFirst(ends[0][0]), isFirst(ends[0][1]));
}

TEST(FacingEnds, FartherApartThanTheirPointsAreTwo)
{
  EXPECT_EQ(0U, facingEnds(bentWire(2)).size());
}

TEST(FacingEnds, SideBySideDoNotFaceEachOther)
{
  const Shape wire = bentWire(RINGS / 2);
  EXPECT_EQ(0U, facingEnds(joined(wire, translated(wire, {0, 0, 2.2 * THICK}))).size());
}

TEST(FacingEnds, OfAClosedRingOrASphereAreNone)
{
  EXPECT_EQ(0U, facingEnds(torus(RINGS, AROUND, 1.0, THICK)).size());
  EXPECT_EQ(0U, facingEnds(icosphere(0)).size());
  EXPECT_EQ(0U, facingEnds(icosphere(1)).size());
}

TEST(FacingEnds, OfNothingAreNone) { EXPECT_EQ(0U, facingEnds(Shape()).size()); }

} // namespace
} // namespace pcl::ccaa::test
