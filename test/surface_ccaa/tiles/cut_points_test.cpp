// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points at which a cloud was cut, in ProjectionCompletion.
#include "support/random_source.h"
#include "surface_ccaa/advancing_front/completion_helpers.h"

#include <numeric>

namespace pcl::ccaa::test {
namespace {

IndicesPtr
asIndices(const std::set<index_t>& points)
{
  return std::make_shared<Indices>(points.begin(), points.end());
}

/** A hole of some rings in the middle of a sphere, and its points with those around. */
struct Holed {
  Shape whole = noisyIcosphere(3, 0.01);
  Shape given = withoutPatches(whole, 1, 2, 5);
  std::set<index_t> hole;

  Holed()
  {
    std::set<Triangle> left(given.triangles.begin(), given.triangles.end());
    for (const Triangle& triangle : whole.triangles)
      if (left.count(triangle) == 0)
        hole.insert(triangle.begin(), triangle.end());
  }
};

class CutPoints : public CompletionTest {};

TEST_F(CutPoints, NothingGrowsFromThem)
{
  const Holed holed;
  completion_.setCutPoints(asIndices(holed.hole));
  const Triangles result = complete(holed.given);
  EXPECT_TRUE(sameTriangles(holed.given.triangles, result));
  completion_.setCutPoints(nullptr);
  EXPECT_EQ(completion_.getCutPoints(), nullptr);
  expectClosed(complete(holed.given), holed.whole.vertices, 1, 0);
}

TEST_F(CutPoints, PointsBetweenThemStayFreeAsTheyWere)
{
  // Only the points within the hole, which are free, are cut.
  const Holed holed;
  const auto used = usedPoints(holed.given.triangles);
  std::set<index_t> free;
  for (const index_t point : holed.hole)
    if (used.count(point) == 0)
      free.insert(point);
  ASSERT_FALSE(free.empty());
  completion_.setCutPoints(asIndices(free));
  const Triangles result = complete(holed.given);
  EXPECT_TRUE(keepsGiven(holed.given.triangles, result));
  EXPECT_TRUE(isIcadm(result, holed.whole.vertices.size()));
}

TEST_F(CutPoints, OtherPlacesAreCompletedAsWithoutThem)
{
  const Shape whole = noisyIcosphere(4, 0.004);
  const auto inHole = [](const Position& p, double side) {
    return (p - side * Position::UnitZ()).norm() < 0.25;
  };
  Shape given = whole;
  given.triangles.clear();
  std::set<index_t> north;
  for (const Triangle& triangle : whole.triangles) {
    const auto touches = [&](double side) {
      return std::any_of(triangle.begin(), triangle.end(), [&](index_t i) {
        return inHole(whole.vertices[std::size_t(i)], side);
      });
    };
    if (touches(1.0))
      north.insert(triangle.begin(), triangle.end());
    else if (!touches(-1.0))
      given.triangles.push_back(triangle);
  }
  const Triangles uncut = complete(given);
  completion_.setCutPoints(asIndices(north));
  const Triangles cut = complete(given);
  Triangles expected;
  for (const Triangle& t : uncut)
    if (std::any_of(t.begin(), t.end(), [&](index_t i) { return north.count(i) == 0; }))
      expected.push_back(t);
  EXPECT_TRUE(sameTriangles(expected, cut));
}

TEST_F(CutPoints, NoneAreTheSameAsNull)
{
  const Shape given = withoutRandomTriangles(noisyIcosphere(3, 0.01), 0.2, 3);
  const Triangles expected = complete(given);
  completion_.setCutPoints(std::make_shared<Indices>());
  EXPECT_EQ(expected, complete(given));
}

TEST_F(CutPoints, AnIndexOutsideOfTheCloudIsAnError)
{
  const Holed holed;
  completion_.setInputCloud(toCloud(holed.given.vertices));
  completion_.setPartialMesh(std::make_shared<PolygonMesh>(toPolygonMesh(holed.given)));
  for (const index_t outside : {index_t(-1), index_t(holed.given.vertices.size())}) {
    completion_.setCutPoints(std::make_shared<Indices>(1, outside));
    expectError(std::to_string(outside));
  }
}

} // namespace
} // namespace pcl::ccaa::test
