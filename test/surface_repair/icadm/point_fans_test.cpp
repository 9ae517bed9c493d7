// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of taking apart fans that touch in one point.

#include <gtest/gtest.h>

#include "icadm/point_fans.h"
#include "read_shapes.h"

#include <algorithm>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::pointTriangles;
using test::read;

PointFans
separated(const Shape& shape)
{
  ccaa::TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  return separateFans(shape.triangles, adjacency);
}

/** The triangles with each new vertex as the one that it was. */
ccaa::Triangles
overPlaces(const PointFans& fans, const Shape& shape)
{
  ccaa::Triangles triangles = fans.triangles;
  for (ccaa::Triangle& triangle : triangles)
    for (pcl::index_t& corner : triangle) {
      const auto place = static_cast<std::size_t>(corner);
      if (place >= shape.vertices.size())
        corner = fans.vertices[place - shape.vertices.size()];
    }
  return triangles;
}

/** Single triangles that share vertex 0 only. */
Shape
trianglesAtAPoint(int count)
{
  Shape shape;
  shape.vertices.emplace_back(0.0, 0.0, 0.0);
  for (int k = 0; k < count; ++k) {
    const auto first = static_cast<pcl::index_t>(shape.vertices.size());
    shape.vertices.emplace_back(1.0, 0.0, 2.0 * k);
    shape.vertices.emplace_back(0.0, 1.0, 2.0 * k);
    shape.triangles.push_back({0, first, first + 1});
  }
  return shape;
}

/** Squares of a chess board of one colour: all inner corners are touched by two. */
Shape
chessBoard(int squares)
{
  Shape board = grid(squares + 1, squares + 1);
  board.triangles.clear();
  const pcl::index_t row = squares + 1;
  for (pcl::index_t y = 0; y < squares; ++y)
    for (pcl::index_t x = y % 2; x < squares; x += 2) {
      const pcl::index_t corner = y * row + x;
      board.triangles.push_back({corner, corner + 1, corner + row});
      board.triangles.push_back({corner + 1, corner + row + 1, corner + row});
    }
  return board;
}

std::vector<Shape>
touchingShapes()
{
  return {bowTie(),
          twoFansAtApex(),
          trianglesAtAPoint(5),
          chessBoard(6),
          shuffled(chessBoard(6), 3)};
}

TEST(PointFans, AManifoldStaysAsItIs)
{
  for (const Shape& shape : {icosphere(2), grid(5, 5), cylinder(8, 3)}) {
    const PointFans fans = separated(shape);
    EXPECT_EQ(shape.triangles, fans.triangles);
    EXPECT_TRUE(fans.vertices.empty());
  }
}

TEST(PointFans, BecomeAnIcadm)
{
  for (const Shape& shape : touchingShapes()) {
    const PointFans fans = separated(shape);
    EXPECT_TRUE(isIcadm(fans.triangles, shape.vertices.size() + fans.vertices.size()));
  }
}

TEST(PointFans, TrianglesAreTheSameOverPlaces)
{
  for (const Shape& shape : touchingShapes())
    EXPECT_EQ(shape.triangles, overPlaces(separated(shape), shape));
}

TEST(PointFans, TheFanWithTheLowestTriangleKeepsTheVertex)
{
  const PointFans fans = separated(bowTie());
  EXPECT_EQ(bowTie().triangles[0], fans.triangles[0]);
  EXPECT_EQ((std::vector<pcl::index_t>{0}), fans.vertices);
}

TEST(PointFans, ClosedFansStayWhole)
{
  const PointFans fans = separated(twoFansAtApex());
  EXPECT_EQ(1U, fans.vertices.size());
  EXPECT_EQ(2U, countComponents(fans.triangles));
}

TEST(PointFans, EveryFurtherFanAtAPointGetsAVertex)
{
  for (const int count : {2, 3, 7}) {
    const PointFans fans = separated(trianglesAtAPoint(count));
    EXPECT_EQ(std::vector<pcl::index_t>(static_cast<std::size_t>(count) - 1, 0),
              fans.vertices);
  }
}

TEST(PointFans, TwoAtEachCornerOfAChessBoardGetOneMore)
{
  EXPECT_EQ(25U, separated(chessBoard(6)).vertices.size()); // 5 * 5 inner corners
}

TEST(PointFans, IslandsStayTheSame)
{
  for (const Shape& shape : touchingShapes())
    EXPECT_EQ(countComponents(shape.triangles),
              countComponents(separated(shape).triangles));
}

TEST(ReadingOfTouchingFans, TakesEveryTriangleAsItIs)
{
  for (const Shape& shape : touchingShapes())
    EXPECT_EQ(shape.triangles, pointTriangles(read(shape).model));
}

TEST(ReadingOfTouchingFans, CountsThem)
{
  const ReadModel found = read(trianglesAtAPoint(4));
  EXPECT_EQ(3U, found.report.separated_fans);
}

TEST(ReadingOfTouchingFans, GivesAllVerticesOfAPointItsPlace)
{
  const IncompleteModel model = read(trianglesAtAPoint(4)).model;
  ASSERT_EQ(12U, model.positions.size());
  EXPECT_EQ(4,
            std::count(model.point_of_vertex.begin(), model.point_of_vertex.end(), 0));
  for (std::size_t v = 0; v < model.positions.size(); ++v) {
    if (model.point_of_vertex[v] == 0) {
      EXPECT_EQ(Position(0.0, 0.0, 0.0), model.positions[v]);
    }
  }
}

TEST(ReadingOfTouchingFans, PutsTheirVerticesAfterAllOthers)
{
  const IncompleteModel model = read(trianglesAtAPoint(4)).model;
  for (std::size_t v = model.positions.size() - 3; v < model.positions.size(); ++v)
    EXPECT_EQ(0, model.point_of_vertex[v]);
}

} // namespace
} // namespace pcl::repair
