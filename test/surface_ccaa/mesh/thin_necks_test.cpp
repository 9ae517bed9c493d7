// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: rings of a few edges between two parts of a surface.
#include <gtest/gtest.h>

#include "mesh/corners.h"
#include "mesh/thin_necks.h"
#include "support/completion_shapes.h"
#include "support/shapes.h"

#include <algorithm>

namespace pcl::ccaa::test {
namespace {

/** Their vertices. */
std::vector<pcl::index_t>
necksOf(const Shape& shape, int threads = 1)
{
  const TriangleAdjacency adjacency = adjacencyOf(shape);
  const LoopContext context{threads, nullptr, "", 64};
  std::vector<pcl::index_t> vertices;
  for (const ThinNeck& neck :
       thinNecks(shape.triangles, adjacency, PointView(shape.vertices), context))
    vertices.push_back(neck.vertex);
  return vertices;
}

TEST(ThinNecks, ARingBetweenTwoSpheresIsOne)
{
  EXPECT_EQ(1U, necksOf(spheresJoinedByTube(0.1, 1)).size());
}

TEST(ThinNecks, EachIsToldOnce)
{
  const Shape pair = spheresJoinedByTube(0.1, 1);
  EXPECT_EQ(2U, necksOf(joined(pair, translated(pair, {0.0, 5.0, 0.0}))).size());
}

TEST(ThinNecks, ALongTubeIsNone)
{
  EXPECT_TRUE(necksOf(spheresJoinedByTube(2.0, 12)).empty());
}

/** A shape with a tube of six triangles between two of its faces. */
Shape
withHandle(Shape shape, std::size_t one, std::size_t other)
{
  const auto [a, b, c] = shape.triangles[one];
  const auto [d, e, f] = shape.triangles[other];
  shape.triangles[one] = {b, a, d};
  shape.triangles[other] = {b, d, f};
  for (const Triangle& triangle :
       {Triangle{c, b, f}, Triangle{c, f, e}, Triangle{a, c, e}, Triangle{a, e, d}})
    shape.triangles.push_back(triangle);
  return shape;
}

/** The face whose middle is nearest to a place. */
std::size_t
faceAt(const Shape& shape, const Position& place)
{
  const auto squaredDistance = [&](const Triangle& t) {
    const Corners c = cornersOf(t, PointView(shape.vertices));
    return ((c[0] + c[1] + c[2]) / 3.0 - place).squaredNorm();
  };
  return static_cast<std::size_t>(
      std::min_element(shape.triangles.begin(),
                       shape.triangles.end(),
                       [&](const Triangle& a, const Triangle& b) {
                         return squaredDistance(a) < squaredDistance(b);
                       }) -
      shape.triangles.begin());
}

std::vector<ThinNeck>
placesOf(const Shape& shape)
{
  return thinNecks(
      shape.triangles, adjacencyOf(shape), PointView(shape.vertices), LoopContext{});
}

TEST(ThinNecks, TellAHandleOfSixTrianglesAndAllThatIsOnIt)
{
  const Shape ball = icosphere(4);
  const std::size_t one = faceAt(ball, {1.0, 0.0, 0.0}),
                    other = faceAt(ball, {0.95, 0.3, 0.0});
  const std::vector<ThinNeck> found = placesOf(withHandle(ball, one, other));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_handle);
  for (const std::size_t face : {one, other})
    for (const pcl::index_t corner : ball.triangles[face])
      EXPECT_EQ(std::count(found[0].around.begin(), found[0].around.end(), corner), 1);
}

TEST(ThinNecks, TellASmallHandleBesideABoundary)
{
  Shape ball = icosphere(4);
  const std::size_t hole = faceAt(ball, {0.98, 0.15, 0.1});
  ball.triangles.erase(ball.triangles.begin() + std::ptrdiff_t(hole));
  const auto found = placesOf(
      withHandle(ball, faceAt(ball, {1.0, 0.0, 0.0}), faceAt(ball, {0.95, 0.3, 0.0})));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_handle);
}

/** Its other end is too far away to tell that it is no neck between two bodies. */
TEST(ThinNecks, TellAThinHandleBetweenFarPlacesAsANeck)
{
  const Shape ball = icosphere(4);
  const auto found = placesOf(
      withHandle(ball, faceAt(ball, {1.0, 0.0, 0.0}), faceAt(ball, {-1.0, 0.0, 0.0})));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].is_handle);
}

TEST(ThinNecks, BodiesWithoutANeckHaveNone)
{
  EXPECT_TRUE(necksOf(icosphere(3)).empty());
  EXPECT_TRUE(necksOf(torus(40, 20)).empty());
  EXPECT_TRUE(necksOf(torus(60, 6)).empty());
}

TEST(ThinNecks, ARingWithAnOpeningIsOne)
{
  Shape pair = spheresJoinedByTube(0.1, 1);
  const auto at_neck = std::find_if(
      pair.triangles.begin(), pair.triangles.end(), [&](const Triangle& triangle) {
        const auto half = static_cast<pcl::index_t>(pair.vertices.size() / 2);
        return triangle[0] < half && triangle[1] >= half;
      });
  ASSERT_NE(pair.triangles.end(), at_neck);
  pair.triangles.erase(at_neck);
  EXPECT_EQ(1U, necksOf(pair).size());
}

TEST(ThinNecks, ARingOfWhichOnlyAStripIsLeftIsOne)
{
  Shape pair = spheresJoinedByTube(0.1, 1);
  std::vector<std::size_t> removed;
  for (std::size_t t = 0; t < pair.triangles.size(); ++t) {
    const auto half = static_cast<pcl::index_t>(pair.vertices.size() / 2);
    const Triangle& triangle = pair.triangles[t];
    if ((triangle[0] < half) != (triangle[1] < half) ||
        (triangle[0] < half) != (triangle[2] < half))
      removed.push_back(t);
  }
  removed.resize(removed.size() - 4);
  EXPECT_EQ(1U, necksOf(withoutTriangles(pair, removed)).size());
}

TEST(ThinNecks, NothingIsToldBesideABoundaryThatLeadsFarther)
{
  const Shape pair = spheresJoinedByTube(0.1, 1);
  std::vector<std::size_t> removed;
  for (std::size_t t = 0; t < pair.triangles.size(); ++t)
    if (pair.vertices[static_cast<std::size_t>(pair.triangles[t][0])].z() < 0.0)
      removed.push_back(t);
  EXPECT_TRUE(necksOf(withoutTriangles(pair, removed)).empty());
}

TEST(ThinNecks, AreTheSameForAnyNumberOfThreads)
{
  const Shape pair = spheresJoinedByTube(0.1, 1);
  EXPECT_EQ(necksOf(pair), necksOf(pair, 4));
}

} // namespace
} // namespace pcl::ccaa::test
