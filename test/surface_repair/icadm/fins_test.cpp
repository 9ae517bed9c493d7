// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of telling fins from islands between gaps.

#include <gtest/gtest.h>

#include "icadm/fins.h"
#include "read_shapes.h"

#include <algorithm>
#include <vector>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::read;

/** Triangles of the islands that are fins, by island. */
std::vector<std::size_t>
finsOf(const Shape& shape)
{
  IncompleteModel model = read(shape).model;
  markFins(edgesWithFins(model), model);
  std::vector<std::size_t> fins;
  for (const Island& island : model.islands)
    if (island.is_fin)
      fins.push_back(island.triangles);
  return fins;
}

/** A sphere with one more triangle over its first edge. */
Shape
withFin(Shape shape)
{
  const Triangle first = shape.triangles.front();
  const Position middle = 0.5 * (shape.vertices[static_cast<std::size_t>(first[0])] +
                                 shape.vertices[static_cast<std::size_t>(first[1])]);
  shape.triangles.push_back(
      {first[0], first[1], static_cast<pcl::index_t>(shape.vertices.size())});
  shape.vertices.push_back(1.3 * middle);
  return shape;
}

TEST(Fins, StandOnAnEdgeThatIsWholeWithoutThem)
{
  EXPECT_TRUE(finsOf(icosphere(2)).empty());
  EXPECT_EQ(std::vector<std::size_t>{1}, finsOf(withFin(icosphere(2))));
}

TEST(Fins, TrianglesBetweenGapsThatTouchOthersAreNone)
{
  Shape shape = icosphere(2);
  const Triangle spared = shape.triangles[7];
  const auto shared = [&](const Triangle& triangle) {
    return std::count_if(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
      return std::find(spared.begin(), spared.end(), corner) != spared.end();
    });
  };
  shape.triangles.erase(
      std::remove_if(shape.triangles.begin(),
                     shape.triangles.end(),
                     [&](const Triangle& t) { return shared(t) == 2; }),
      shape.triangles.end());
  ASSERT_GT(read(shape).model.islands.size(), 1U);
  EXPECT_TRUE(finsOf(shape).empty());
}

TEST(Fins, LargeSheetsOnAnEdgeAreNone)
{
  Shape wall = grid(12, 12);
  Shape floor = wall;
  for (Position& p : floor.vertices)
    p = Position(p.x(), 5.0, p.y() - 5.0);
  Shape both = wall;
  std::vector<pcl::index_t> number;
  for (const Position& p : floor.vertices) {
    const auto found = std::find(wall.vertices.begin(), wall.vertices.end(), p);
    if (found == wall.vertices.end()) {
      number.push_back(static_cast<pcl::index_t>(both.vertices.size()));
      both.vertices.push_back(p);
    }
    else
      number.push_back(static_cast<pcl::index_t>(found - wall.vertices.begin()));
  }
  for (Triangle t : floor.triangles) {
    for (pcl::index_t& corner : t)
      corner = number[static_cast<std::size_t>(corner)];
    both.triangles.push_back(t);
  }
  ASSERT_GT(read(both).model.islands.size(), 1U);
  EXPECT_TRUE(finsOf(both).empty());
}

} // namespace
} // namespace pcl::repair
