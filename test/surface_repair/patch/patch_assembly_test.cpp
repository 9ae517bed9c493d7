// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of putting fillings together.

#include <gtest/gtest.h>

#include "patch/patch_assembly.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::modelOf;
using test::without;

constexpr std::size_t MODEL_VERTICES = 100;

Position
placeOf(pcl::index_t vertex)
{
  return {static_cast<double>(vertex), 0.5 * static_cast<double>(vertex % 3), 1.0};
}

/** A polygon of vertices, closed by a fan from its first one, or from a new one. */
FilledPart
partOf(const std::vector<pcl::index_t>& vertices, std::size_t hole, bool has_center)
{
  FilledPart part;
  part.hole = hole;
  part.polygon.vertices = vertices;
  for (const pcl::index_t vertex : vertices)
    part.polygon.curve.points.push_back(placeOf(vertex));
  part.polygon.curve.normals.assign(vertices.size(), Direction::UnitZ());
  const auto edges = static_cast<pcl::index_t>(vertices.size());
  if (has_center) {
    part.filling.inner.emplace_back(0.0, static_cast<double>(hole), 7.0);
    part.filling.free_point.push_back(hole == 0 ? NONE : 40 + hole);
  }
  for (pcl::index_t k = 0; k < edges; ++k) {
    const Triangle triangle =
        has_center ? Triangle{(k + 1) % edges, k, edges} : Triangle{k + 1, k, 0};
    if (has_center || (k > 0 && k + 1 < edges))
      part.filling.triangles.push_back(triangle);
  }
  return part;
}

/** Two holes beside a bridge over the new vertices 100 and 101. */
std::vector<FilledPart>
twoParts()
{
  return {partOf({7, 3, 100, 101, 20}, 0, true), partOf({20, 101, 100, 3, 9}, 1, true)};
}

TEST(PatchAssembly, PartsShareTheVerticesOfTheirBridges)
{
  const Patch patch = assemblePatch(twoParts(), MODEL_VERTICES);
  EXPECT_EQ(6U + 2U, patch.positions.size()); // 3 7 9 20 100 101, two centres
}

TEST(PatchAssembly, VerticesOfTheModelComeFirstAscending)
{
  const Patch patch = assemblePatch(twoParts(), MODEL_VERTICES);
  EXPECT_EQ((std::vector<pcl::index_t>{3, 7, 9, 20}), patch.rim);
}

TEST(PatchAssembly, EveryVertexKeepsItsPlace)
{
  const Patch patch = assemblePatch(twoParts(), MODEL_VERTICES);
  const std::vector<pcl::index_t> vertices{3, 7, 9, 20, 100, 101};
  for (std::size_t v = 0; v < vertices.size(); ++v)
    EXPECT_EQ(placeOf(vertices[v]), patch.positions[v]);
}

TEST(PatchAssembly, TrianglesKnowTheirHoles)
{
  const Patch patch = assemblePatch(twoParts(), MODEL_VERTICES);
  EXPECT_EQ((std::vector<std::size_t>{0, 0, 0, 0, 0, 1, 1, 1, 1, 1}), patch.hole);
}

TEST(PatchAssembly, FreePointsAreKnownAndHeld)
{
  const Patch patch = assemblePatch(twoParts(), MODEL_VERTICES);
  ASSERT_EQ(patch.positions.size(), patch.free_point.size());
  EXPECT_EQ(1, std::count(patch.free_point.begin(), patch.free_point.end(), 41U));
  EXPECT_TRUE(patch.isHeld(7));
  EXPECT_FALSE(patch.isHeld(6));
}

TEST(PatchAssembly, PartsTogetherAreASurface)
{
  const Patch patch = assemblePatch(twoParts(), MODEL_VERTICES);
  EXPECT_TRUE(isIcadm(patch.triangles, patch.positions.size()));
  EXPECT_TRUE(ccaa::test::isConsistentlyWound(patch.triangles));
  EXPECT_EQ(1U, countComponents(patch.triangles));
}

TEST(PatchAssembly, OfNothingIsEmpty)
{
  const Patch patch = assemblePatch({}, MODEL_VERTICES);
  EXPECT_TRUE(patch.positions.empty());
  EXPECT_TRUE(patch.triangles.empty());
}

TEST(PatchWithoutHoles, DropsVerticesThatOnlyTheyHave)
{
  const Patch patch = withoutHoles(assemblePatch(twoParts(), MODEL_VERTICES), {1});
  EXPECT_EQ((std::vector<pcl::index_t>{3, 7, 20}), patch.rim);
  EXPECT_EQ(5U + 1U, patch.positions.size()); // the bridge's vertices stay
  EXPECT_EQ(patch.positions.size(), patch.free_point.size());
}

TEST(PatchWithoutHoles, IsWhatTheOthersAloneWouldBe)
{
  const std::vector<FilledPart> parts = twoParts();
  const Patch left = withoutHoles(assemblePatch(parts, MODEL_VERTICES), {0});
  const Patch alone = assemblePatch({parts[1]}, MODEL_VERTICES);
  EXPECT_EQ(alone.rim, left.rim);
  EXPECT_EQ(alone.positions, left.positions);
  EXPECT_EQ(alone.free_point, left.free_point);
  EXPECT_EQ(alone.triangles, left.triangles);
  EXPECT_EQ(alone.hole, left.hole);
}

TEST(PatchWithoutHoles, WithoutAllOfThemNothingIsLeft)
{
  const Patch left = withoutHoles(assemblePatch(twoParts(), MODEL_VERTICES), {0, 1});
  EXPECT_TRUE(left.positions.empty());
  EXPECT_TRUE(left.rim.empty());
  EXPECT_TRUE(left.triangles.empty());
}

TEST(PatchWithoutHoles, OfNoneStaysTheSame)
{
  const Patch patch = assemblePatch(twoParts(), MODEL_VERTICES);
  EXPECT_EQ(patch.triangles, withoutHoles(patch, {}).triangles);
}

/** A square sheet without the nine squares in its middle. */
IncompleteModel
holedSheet()
{
  return modelOf(without(grid(10, 10), [](const Position& p) {
    return (p - Position(4.5, 4.5, 0.0)).lpNorm<Eigen::Infinity>() < 1.5;
  }));
}

/** A fan in the smallest loop of a model. */
Patch
fanIn(const IncompleteModel& model)
{
  const BoundaryLoops loops = extractBoundaries(model);
  const BoundaryLoop& hole = *std::min_element(
      loops.begin(), loops.end(), [](const BoundaryLoop& a, const BoundaryLoop& b) {
        return a.length < b.length;
      });
  FilledPart part;
  part.polygon = polygonOf(hole);
  part.filling.inner.emplace_back(4.5, 4.5, 0.5);
  part.filling.free_point.push_back(NONE);
  const auto edges = static_cast<pcl::index_t>(hole.vertices.size());
  for (pcl::index_t k = 0; k < edges; ++k)
    part.filling.triangles.push_back({(k + 1) % edges, k, edges});
  return assemblePatch({part}, model.positions.size());
}

TEST(PatchThatFits, IsAFanInAHole)
{
  const IncompleteModel model = holedSheet();
  EXPECT_TRUE(fitsModel(model, fanIn(model)));
}

TEST(PatchThatFits, IsNoneWoundTheOtherWay)
{
  const IncompleteModel model = holedSheet();
  Patch patch = fanIn(model);
  patch.triangles = reversed(patch.triangles);
  EXPECT_FALSE(fitsModel(model, patch));
}

TEST(PatchThatFits, HasNoTriangleTwice)
{
  const IncompleteModel model = holedSheet();
  Patch patch = fanIn(model);
  patch.triangles.push_back(patch.triangles.front());
  patch.hole.push_back(0);
  EXPECT_FALSE(fitsModel(model, patch));
}

TEST(PatchThatFits, HasNoThirdTriangleOnAnEdgeOfTheModel)
{
  const IncompleteModel model = holedSheet();
  Patch patch; // a triangle at an inner edge of the sheet
  const Triangle inner = model.triangles.front();
  std::size_t corner = 0;
  while (model.adjacency.across(0, static_cast<int>(corner)) < 0)
    ++corner;
  patch.rim = {inner[corner], inner[(corner + 1) % 3]};
  patch.positions = {model.positions[static_cast<std::size_t>(patch.rim[0])],
                     model.positions[static_cast<std::size_t>(patch.rim[1])],
                     Position(0.0, 0.0, 5.0)};
  patch.free_point.assign(3, NONE);
  patch.triangles = {{0, 1, 2}};
  patch.hole = {0};
  EXPECT_FALSE(fitsModel(model, patch));
}

TEST(PatchThatFits, MakesNoSecondFanAtAVertex)
{
  const IncompleteModel model = holedSheet();
  Patch patch = fanIn(model);
  const auto next = static_cast<pcl::index_t>(patch.positions.size());
  patch.positions.emplace_back(3.0, 3.0, 4.0);
  patch.positions.emplace_back(4.0, 3.0, 4.0);
  patch.free_point.resize(patch.positions.size(), NONE);
  patch.triangles.push_back({0, next, next + 1});
  patch.hole.push_back(0);
  EXPECT_FALSE(fitsModel(model, patch));
}

TEST(PatchThatFits, MayLeaveAPartOfTheHoleOpen)
{
  const IncompleteModel model = holedSheet();
  Patch patch = fanIn(model);
  patch.triangles.resize(patch.triangles.size() - 2);
  patch.hole.resize(patch.triangles.size());
  EXPECT_TRUE(fitsModel(model, patch));
}

TEST(PatchThatFits, IsAnEmptyOne) { EXPECT_TRUE(fitsModel(holedSheet(), Patch())); }

} // namespace
} // namespace pcl::repair
