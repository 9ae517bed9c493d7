// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what new vertices inherit.

#include <gtest/gtest.h>

#include "repair/new_vertices.h"
#include "support/shapes.h"

#include <algorithm>

namespace pcl::repair {
namespace {

using namespace ccaa::test;

/** A flat sheet of input vertices that are points 0, 1, ...; every one of them has a
 * new triangle with a new vertex at a place. */
RepairedModel
sheetWith(const Position& place)
{
  RepairedModel repaired;
  IncompleteModel& model = repaired.model;
  const Shape sheet = grid(6, 6);
  model.positions = sheet.vertices;
  model.triangles = sheet.triangles;
  repaired.input_vertices = sheet.vertices.size();
  repaired.input_triangles = sheet.triangles.size();
  for (std::size_t v = 0; v < sheet.vertices.size(); ++v)
    model.point_of_vertex.push_back(static_cast<pcl::index_t>(v));
  const auto added = static_cast<pcl::index_t>(model.positions.size());
  model.positions.push_back(place);
  model.point_of_vertex.push_back(pcl::UNAVAILABLE);
  for (pcl::index_t v = 0; v + 1 < added; ++v)
    model.triangles.push_back({v, v + 1, added});
  return repaired;
}

TEST(AddedVertices, AreThoseWithoutAPoint)
{
  const AddedVertices added = addedVertices(sheetWith({2.2, 2.1, 0.5}));
  EXPECT_EQ((std::vector<std::size_t>{36}), added.numbers);
  ASSERT_EQ(1U, added.vertices.size());
  EXPECT_EQ(Position(2.2, 2.1, 0.5), added.vertices[0].position);
}

TEST(AddedVertices, InheritMostFromTheNearest)
{
  const auto sources = addedVertices(sheetWith({2.2, 2.1, 0.1})).vertices[0].sources;
  const auto heaviest = std::max_element(
      sources.begin(), sources.end(), [](const auto& a, const auto& b) {
        return a.weight < b.weight;
      });
  EXPECT_EQ(2 * 6 + 2, heaviest->vertex);
}

TEST(AddedVertices, InheritFromTwelveAtTheMostThatCount)
{
  const auto sources = addedVertices(sheetWith({2.2, 2.1, 0.1})).vertices[0].sources;
  double sum = 0.0;
  for (const auto& source : sources)
    sum += source.weight;
  EXPECT_LE(
      std::count_if(sources.begin(),
                    sources.end(),
                    [&](const auto& source) { return source.weight > 1e-9 * sum; }),
      12);
}

TEST(AddedVertices, InheritFromInputVerticesWithNewTrianglesOnly)
{
  RepairedModel repaired = sheetWith({2.2, 2.1, 0.1});
  repaired.model.triangles.resize(repaired.input_triangles);
  repaired.model.triangles.push_back({30, 31, 36});
  const auto sources = addedVertices(repaired).vertices[0].sources;
  EXPECT_EQ(2U, sources.size());
  for (const auto& source : sources)
    EXPECT_TRUE(source.vertex == 30 || source.vertex == 31) << source.vertex;
}

TEST(AddedVertices, AtThePlaceOfAnInputVertexInheritFromThatOne)
{
  const auto sources = addedVertices(sheetWith({2.0, 2.0, 0.0})).vertices[0].sources;
  double sum = 0.0;
  double own = 0.0;
  for (const auto& source : sources) {
    sum += source.weight;
    own += source.vertex == 2 * 6 + 2 ? source.weight : 0.0;
  }
  EXPECT_GT(own, 0.999 * sum);
}

TEST(AddedVertices, FreePointsOfTheMeshAreNone)
{
  RepairedModel repaired = sheetWith({2.2, 2.1, 0.1});
  repaired.model.point_of_vertex.back() = 77;
  EXPECT_TRUE(addedVertices(repaired).numbers.empty());
}

TEST(AddedVertices, AnotherFanOfAPointIsACopyOfIt)
{
  RepairedModel repaired = sheetWith({2.2, 2.1, 0.1});
  repaired.model.point_of_vertex[35] = 5;
  const AddedVertices added = addedVertices(repaired);
  ASSERT_EQ((std::vector<std::size_t>{35, 36}), added.numbers);
  EXPECT_EQ(repaired.model.positions[35], added.vertices[0].position);
  ASSERT_EQ(1U, added.vertices[0].sources.size());
  EXPECT_EQ(5, added.vertices[0].sources[0].vertex);
}

TEST(AddedVertices, FarFromTheOriginInheritTheSame)
{
  const Position far = Position::Constant(1e6);
  RepairedModel repaired = sheetWith({2.2, 2.1, 0.1});
  const auto near = addedVertices(repaired).vertices[0].sources;
  for (Position& position : repaired.model.positions)
    position += far;
  const auto moved = addedVertices(repaired).vertices[0].sources;
  ASSERT_EQ(near.size(), moved.size());
  for (std::size_t i = 0; i < near.size(); ++i)
    EXPECT_NEAR(near[i].weight, moved[i].weight, 1e-4 * near[0].weight);
}

} // namespace
} // namespace pcl::repair
