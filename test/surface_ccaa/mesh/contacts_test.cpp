// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closed pieces of a surface that touch others.
#include <gtest/gtest.h>

#include "mesh/contacts.h"
#include "support/shapes.h"

namespace pcl::ccaa::test {
namespace {

/** Edges of these spheres are 0.14 to 0.17 long. */
constexpr int SUBDIVISIONS = 3;

std::size_t
pieceContacts(const Shape& shape)
{
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  return pieceContacts(shape.triangles, adjacency, PointView(shape.vertices), {})
      .size();
}

Shape
spheresApart(double gap)
{
  const Shape sphere = icosphere(SUBDIVISIONS);
  return joined(sphere, translated(sphere, {2.0 + gap, 0.0, 0.0}));
}

TEST(Contacts, PiecesNearerThanTheirPointsLieApartTouch)
{
  EXPECT_EQ(1U, pieceContacts(spheresApart(0.05)));
}

TEST(Contacts, PiecesFartherAwayDoNotThoughTheirBoxesMeet)
{
  EXPECT_EQ(0U, pieceContacts(spheresApart(0.3)));
  EXPECT_EQ(0U, pieceContacts(nestedSpheres(SUBDIVISIONS)));
}

TEST(Contacts, PiecesInARowAreOneLessEach)
{
  EXPECT_EQ(
      2U,
      pieceContacts(joined(spheresApart(0.05),
                           translated(icosphere(SUBDIVISIONS), {4.1, 0.0, 0.0}))));
}

TEST(Contacts, AClosedPieceTouchesAnOpenOne)
{
  EXPECT_EQ(1U, pieceContacts(withoutTriangles(spheresApart(0.05), {0})));
}

TEST(Contacts, OpenPiecesBesideEachOtherAreForTheRepair)
{
  const std::size_t triangles = icosphere(SUBDIVISIONS).triangles.size();
  EXPECT_EQ(0U, pieceContacts(withoutTriangles(spheresApart(0.05), {0, triangles})));
}

TEST(Contacts, OnePieceTouchesNone) { EXPECT_EQ(0U, pieceContacts(torus(40, 20))); }

} // namespace
} // namespace pcl::ccaa::test
