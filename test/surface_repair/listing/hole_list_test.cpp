// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of which boundaries are to be closed.

#include <gtest/gtest.h>

#include "listing/hole_list.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "surface_repair/boundary/boundary_models.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::without;

ModelSurvey
survey(const Shape& shape, bool joins = true)
{
  SurveyParameters parameters;
  parameters.trace_in_holes = false;
  parameters.trace_between_islands = joins;
  return surveyModel(pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)),
                     nullptr,
                     parameters,
                     {});
}

HoleList
listed(const Shape& shape, std::size_t greatest_hole = 0)
{
  FillingParameters parameters;
  parameters.greatest_hole = greatest_hole;
  return listHoles(survey(shape), parameters);
}

std::size_t
countOpen(const HoleList& list, OpenReason reason)
{
  return static_cast<std::size_t>(
      std::count_if(list.holes.begin(), list.holes.end(), [&](const OpenHole& hole) {
        return hole.open == reason;
      }));
}

Shape
holedSphere()
{
  return without(icosphere(4), [](const Position& p) { return p.z() > 0.8; });
}

/** A sphere without a belt. */
Shape
twoCaps()
{
  return without(icosphere(4), [](const Position& p) { return std::abs(p.z()) < 0.2; });
}

/** A sphere without a belt and without its upper pole. */
Shape
twoCapsAndAHole()
{
  return without(twoCaps(), [](const Position& p) { return p.z() > 0.95; });
}

/** A terrain without a strip across. */
Shape
terrainHalves()
{
  return without(terrain(50, 50, 1.0),
                 [](const Position& p) { return std::abs(p.x() - 25.0) < 1.5; });
}

TEST(HoleList, OfAClosedSurfaceIsEmpty)
{
  const HoleList list = listed(icosphere(2));
  EXPECT_TRUE(list.holes.empty());
  EXPECT_TRUE(list.regions.empty());
  EXPECT_EQ(1U, list.islands);
}

TEST(HoleList, HasAHoleAsARegionOfItsOwn)
{
  const HoleList list = listed(holedSphere());
  ASSERT_EQ(1U, list.holes.size());
  EXPECT_EQ(OpenReason::NONE, list.holes[0].open);
  EXPECT_EQ((std::vector<std::vector<std::size_t>>{{0}}), list.regions);
}

TEST(HoleList, LeavesAHoleOpenThatHasMoreEdgesThanTheGreatest)
{
  const std::size_t edges = listed(holedSphere()).holes[0].polygon.size();
  EXPECT_EQ(OpenReason::NONE, listed(holedSphere(), edges).holes[0].open);
  const HoleList list = listed(holedSphere(), edges - 1);
  EXPECT_EQ(OpenReason::TOO_LARGE, list.holes[0].open);
  EXPECT_TRUE(list.regions.empty());
}

TEST(HoleList, LeavesTheBorderOfATerrainOpen)
{
  const HoleList list = listed(terrain(50, 50, 1.0));
  ASSERT_EQ(1U, list.holes.size());
  EXPECT_EQ(OpenReason::OUTER_BORDER, list.holes[0].open);
}

TEST(HoleList, LeavesTheBorderAroundTwoHalvesOfATerrainOpen)
{
  const HoleList list = listed(terrainHalves());
  EXPECT_EQ(1U, countOpen(list, OpenReason::OUTER_BORDER));
  EXPECT_EQ(list.holes.size() - 1, countOpen(list, OpenReason::NONE));
  EXPECT_GT(list.holes.size(), 2U);
}

TEST(HoleList, TheBorderAroundTwoHalvesRunsOverTheOutermostBridges)
{
  for (const OpenHole& hole : listed(terrainHalves()).holes) {
    if (hole.open == OpenReason::OUTER_BORDER) {
      EXPECT_EQ(2U, hole.bridges.size());
      EXPECT_GT(hole.polygon.size(), 180U);
    }
  }
}

TEST(HoleList, LeavesTheMouthsOfATubeOpen)
{
  const HoleList list = listed(cylinder(40, 40, 1.0, 6.0));
  ASSERT_EQ(2U, list.holes.size());
  EXPECT_EQ(2U, countOpen(list, OpenReason::TUBE_MOUTH));
}

TEST(HoleList, LeavesAOneSidedIslandOpen)
{
  const HoleList list = listed(moebiusBand(40));
  ASSERT_EQ(1U, list.holes.size());
  EXPECT_EQ(OpenReason::ONE_SIDED, list.holes[0].open);
}

TEST(HoleList, LeavesRimsOpenThatNothingJoins)
{
  const HoleList list = listHoles(survey(twoCaps(), false), {});
  EXPECT_EQ(2U, countOpen(list, OpenReason::NOT_JOINED));
  EXPECT_EQ(2U, list.islands);
}

/** A body, and a ring of less area than what would cap the body. */
Shape
bodyAndRing()
{
  return without(ellipsoid(4, 2.0), [](const Position& p) {
    return p.z() > 1.3 || (p.z() > 0.8 && p.z() < 1.0);
  });
}

TEST(HoleList, ABoundaryThatIsJoinedStaysOpenAlsoWhereNoBridgeIsLeft)
{
  ModelSurvey found = survey(bodyAndRing());
  const std::size_t joined = countOpen(listHoles(found, {}), OpenReason::NOT_JOINED);
  ASSERT_FALSE(found.joined.bridges.empty());
  found.joined.bridges.clear();
  found.joined.holes = {};
  EXPECT_EQ(joined + 2, countOpen(listHoles(found, {}), OpenReason::NOT_JOINED));
}

TEST(HoleList, JoinedIslandsAreOne) { EXPECT_EQ(1U, listed(twoCaps()).islands); }

TEST(HoleList, BridgesConnectHolesToOneRegion)
{
  const HoleList list = listed(twoCaps());
  ASSERT_EQ(1U, list.regions.size());
  EXPECT_EQ(list.holes.size(), list.regions[0].size());
  EXPECT_GT(list.holes.size(), 4U);
}

TEST(HoleList, AHoleBesideBridgesIsARegionOfItsOwn)
{
  const HoleList list = listed(twoCapsAndAHole());
  ASSERT_EQ(2U, list.regions.size());
  EXPECT_EQ(1U, std::min(list.regions[0].size(), list.regions[1].size()));
}

TEST(HoleList, EveryHoleToBeClosedIsInOneRegion)
{
  for (const Shape& shape : {twoCapsAndAHole(), terrainHalves()}) {
    const HoleList list = listed(shape);
    std::vector<std::size_t> members;
    for (const auto& region : list.regions)
      members.insert(members.end(), region.begin(), region.end());
    std::sort(members.begin(), members.end());
    std::vector<std::size_t> expected;
    for (std::size_t h = 0; h < list.holes.size(); ++h)
      if (list.holes[h].open == OpenReason::NONE)
        expected.push_back(h);
    EXPECT_EQ(expected, members);
  }
}

TEST(HoleList, EveryVertexOfABoundaryIsInAHole)
{
  const ModelSurvey found = survey(twoCapsAndAHole());
  std::set<pcl::index_t> listed_vertices;
  for (const OpenHole& hole : listHoles(found, {}).holes)
    listed_vertices.insert(hole.polygon.vertices.begin(), hole.polygon.vertices.end());
  for (const BoundaryLoop& loop : found.loops)
    for (const pcl::index_t vertex : loop.vertices)
      EXPECT_EQ(1U, listed_vertices.count(vertex));
}

TEST(HoleList, NewVerticesOfBridgesAreNumberedWithoutGaps)
{
  const ModelSurvey found = survey(twoCaps());
  const HoleList list = listHoles(found, {});
  std::set<pcl::index_t> added;
  for (const OpenHole& hole : list.holes)
    for (const pcl::index_t vertex : hole.polygon.vertices)
      if (static_cast<std::size_t>(vertex) >= found.model.positions.size())
        added.insert(vertex);
  ASSERT_FALSE(added.empty());
  EXPECT_EQ(list.bridge_vertices, added.size());
  EXPECT_EQ(static_cast<pcl::index_t>(found.model.positions.size()), *added.begin());
  EXPECT_EQ(added.size() - 1,
            static_cast<std::size_t>(*added.rbegin() - *added.begin()));
}

} // namespace
} // namespace pcl::repair
