// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of finding the outer side of islands.

#include <gtest/gtest.h>

#include "orientation/island_orientation.h"
#include "surface_repair/boundary/boundary_models.h"

#include <random>

namespace pcl::repair {
namespace {

using namespace ccaa::test;
using test::modelOf;
using test::without;

/** The shape without slabs of a thickness across x, y and z. */
Shape
inPieces(Shape shape, double thickness)
{
  return without(std::move(shape), [thickness](const Position& p) {
    return p.cwiseAbs().minCoeff() < 0.5 * thickness;
  });
}

std::vector<IslandSide>
flips(const std::vector<bool>& flipped)
{
  std::vector<IslandSide> sides(flipped.size());
  for (std::size_t i = 0; i < flipped.size(); ++i)
    sides[i].flipped = flipped[i];
  return sides;
}

std::vector<IslandSide>
orient(const IncompleteModel& model,
       const OrientationParameters& parameters = {},
       int threads = 1)
{
  ccaa::LoopContext context;
  context.threads = threads;
  return orientIslands(
      model, extractBoundaries(model), parameters, DEFAULT_ROOM, context);
}

/** The model with some islands turned, and what orientIslands() says of it. */
std::vector<bool>
flippedAfter(IncompleteModel model, const std::vector<bool>& turned)
{
  turnIslands(model, flips(turned));
  std::vector<bool> flipped;
  for (const IslandSide& side : orient(model))
    flipped.push_back(side.flipped);
  return flipped;
}

std::vector<bool>
randomFlips(std::size_t count, unsigned seed)
{
  std::mt19937 generator(seed);
  std::vector<bool> turned;
  for (std::size_t i = 0; i < count; ++i)
    turned.push_back((generator() & 1U) != 0);
  return turned;
}

class RandomFlips : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomFlips, AreFoundOnASphereInEightPieces)
{
  const IncompleteModel model = modelOf(inPieces(icosphere(4), 0.15));
  ASSERT_EQ(8U, model.islands.size());
  const std::vector<bool> turned = randomFlips(8, GetParam());
  EXPECT_EQ(turned, flippedAfter(model, turned));
}

TEST_P(RandomFlips, AreFoundOnATorusInPieces)
{
  const IncompleteModel model = modelOf(inPieces(torus(60, 30), 0.1));
  const std::vector<bool> turned = randomFlips(model.islands.size(), GetParam());
  EXPECT_EQ(turned, flippedAfter(model, turned));
}

TEST_P(RandomFlips, AreFoundOnACubeInPieces)
{
  const IncompleteModel model =
      modelOf(inPieces(translated(cube(20, 2.0), Position(-1, -1, -1)), 0.3));
  const std::vector<bool> turned = randomFlips(model.islands.size(), GetParam());
  EXPECT_EQ(turned, flippedAfter(model, turned));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomFlips, ::testing::Range(0U, 8U));

/** A terrain with an island in a ring-shaped gap. */
IncompleteModel
terrainWithIsland()
{
  return modelOf(without(terrain(40, 40, 1.0), [](const Position& p) {
    const double radius = std::hypot(p.x() - 20.0, p.y() - 20.0);
    return radius > 6.0 && radius < 9.0;
  }));
}

TEST(IslandOrientation, IslandInAnOpenTerrainIsTurnedToItsSurroundings)
{
  IncompleteModel model = terrainWithIsland();
  ASSERT_EQ(2U, model.islands.size());
  const std::size_t small = model.islands[0].area < model.islands[1].area ? 0 : 1;
  std::vector<bool> turned(2, false);
  turned[small] = true;
  turnIslands(model, flips(turned));
  const std::vector<IslandSide> sides = orient(model);

  EXPECT_NE(sides[0].flipped, sides[1].flipped);
}

TEST(IslandOrientation, FieldDecidesWhatFreeSightCannot)
{
  OrientationParameters blind;
  blind.clear_sight = 2.0; // above any balance
  IncompleteModel model = modelOf(inPieces(icosphere(4), 0.15));
  turnIslands(model, flips({true, false, false, false, false, false, false, false}));
  const std::vector<IslandSide> sides = orient(model, blind);
  for (std::size_t i = 1; i < sides.size(); ++i)
    EXPECT_NE(sides[0].flipped, sides[i].flipped);
}

TEST(IslandOrientation, FlatSheetIsUndecidedAndStays)
{
  const std::vector<IslandSide> sides = orient(modelOf(grid(20, 20)));
  ASSERT_EQ(1U, sides.size());
  EXPECT_EQ(SideRule::UNDECIDED, sides[0].rule);
  EXPECT_FALSE(sides[0].flipped);
}

/** A sphere without what lies above a height. */
IncompleteModel
sphereOpenAbove(double height)
{
  return modelOf(
      without(icosphere(4), [height](const Position& p) { return p.z() > height; }));
}

TEST(IslandOrientation, VolumeDecidesAboutAnOnlyIslandThatIsNearlyClosed)
{
  const std::vector<IslandSide> sides = orient(sphereOpenAbove(0.95));
  EXPECT_EQ(SideRule::VOLUME, sides[0].rule);
  EXPECT_FALSE(sides[0].flipped);
  EXPECT_EQ(1.0, sides[0].confidence);
}

TEST(IslandOrientation, AnOnlyIslandOfNegativeVolumeIsTurned)
{
  IncompleteModel model = sphereOpenAbove(0.95);
  turnIslands(model, flips({true}));
  const std::vector<IslandSide> sides = orient(model);
  EXPECT_EQ(SideRule::VOLUME, sides[0].rule);
  EXPECT_TRUE(sides[0].flipped);
}

TEST(IslandOrientation, VolumeIsThatOfTheShapeWhereverItIs)
{
  for (const double far : {-1000.0, 1000.0}) {
    const Shape shape =
        without(icosphere(3), [](const Position& p) { return p.z() > 0.95; });
    IncompleteModel model = modelOf(translated(shape, Position::Constant(far)));
    turnIslands(model, flips({true}));
    EXPECT_TRUE(orient(model)[0].flipped) << far;
  }
}

/** Eight, whose lengths together are those of one that is too large. */
TEST(IslandOrientation, VolumeDecidesAboutManySmallOpenings)
{
  const Position corner = Position::Ones().normalized();
  const std::vector<IslandSide> sides =
      orient(modelOf(without(icosphere(5), [&](const Position& p) {
        return p.cwiseAbs().dot(corner) > std::cos(0.2);
      })));
  ASSERT_EQ(1U, sides.size());
  EXPECT_EQ(SideRule::VOLUME, sides[0].rule);
  EXPECT_FALSE(sides[0].flipped);
}

TEST(IslandOrientation, VolumeSaysNothingOfALargeOpening)
{
  EXPECT_NE(SideRule::VOLUME, orient(sphereOpenAbove(0.3))[0].rule);
}

TEST(IslandOrientation, VolumeSaysNothingOfSeveralIslands)
{
  const IncompleteModel model =
      modelOf(joined(icosphere(2), translated(icosphere(2), Position(5, 0, 0))));
  for (const IslandSide& side : orient(model))
    EXPECT_NE(SideRule::VOLUME, side.rule);
}

TEST(IslandOrientation, GivenNormalsWinOverVolume)
{
  IncompleteModel model = sphereOpenAbove(0.95);
  for (const Position& position : model.positions)
    model.given_normals.push_back(-position); // inward
  EXPECT_EQ(SideRule::NORMALS, orient(model)[0].rule);
}

TEST(IslandOrientation, GivenNormalsWinOverFreeSight)
{
  IncompleteModel model = modelOf(inPieces(icosphere(3), 0.2));
  for (const Position& position : model.positions)
    model.given_normals.push_back(-position); // inward
  for (const IslandSide& side : orient(model)) {
    EXPECT_EQ(SideRule::NORMALS, side.rule);
    EXPECT_TRUE(side.flipped);
  }
}

TEST(IslandOrientation, NormalsThatContradictEachOtherDoNotDecide)
{
  IncompleteModel model = modelOf(inPieces(icosphere(3), 0.2));
  for (std::size_t v = 0; v < model.positions.size(); ++v)
    model.given_normals.push_back((v % 2 == 0 ? 1.0 : -1.0) * model.positions[v]);
  for (const IslandSide& side : orient(model)) {
    EXPECT_NE(SideRule::NORMALS, side.rule);
    EXPECT_FALSE(side.flipped);
  }
}

TEST(IslandOrientation, SensorPositionDecidesAboutAFlatSheet)
{
  IncompleteModel model = modelOf(grid(20, 20)); // wound upward
  model.viewpoints.assign(model.positions.size(), Position(10.0, 10.0, -50.0));
  const std::vector<IslandSide> sides = orient(model);
  EXPECT_EQ(SideRule::VIEWPOINT, sides[0].rule);
  EXPECT_TRUE(sides[0].flipped);
}

TEST(IslandOrientation, OneSidedIslandIsReportedAndLeftAlone)
{
  IncompleteModel model = modelOf(moebiusBand(24));
  model.islands[0].one_sided = true;
  const std::vector<IslandSide> sides = orient(model);
  EXPECT_EQ(SideRule::ONE_SIDED, sides[0].rule);
  EXPECT_FALSE(sides[0].flipped);
}

TEST(IslandOrientation, FreePointsAroundTheModelBlockTheSight)
{
  IncompleteModel model = modelOf(inPieces(icosphere(3), 0.2));
  for (const Position& position : icosphere(4, 1.5).vertices)
    model.free_points.push_back(position);
  for (const IslandSide& side : orient(model))
    EXPECT_NE(SideRule::FREE_SIGHT, side.rule);
}

TEST(IslandOrientation, ConfidencesLieBetweenZeroAndOne)
{
  for (const IslandSide& side : orient(modelOf(inPieces(torus(60, 30), 0.1)))) {
    EXPECT_GE(side.confidence, 0.0);
    EXPECT_LE(side.confidence, 1.0);
  }
}

TEST(IslandOrientation, ResultIsTheSameForAnyNumberOfThreads)
{
  const IncompleteModel model = modelOf(inPieces(torus(60, 30), 0.1));
  const std::vector<IslandSide> one = orient(model);
  const std::vector<IslandSide> seven = orient(model, {}, 7);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].flipped, seven[i].flipped);
    EXPECT_EQ(one[i].confidence, seven[i].confidence);
  }
}

TEST(IslandOrientation, ModelWithoutTrianglesHasNoSides)
{
  EXPECT_TRUE(orient(IncompleteModel()).empty());
}

TEST(TurnIslands, TurnedIslandIsWoundTheOtherWayRound)
{
  IncompleteModel model = modelOf(icosphere(2));
  const Triangles before = model.triangles;
  turnIslands(model, flips({true}));
  for (std::size_t t = 0; t < before.size(); ++t)
    EXPECT_EQ((Triangle{before[t][0], before[t][2], before[t][1]}), model.triangles[t]);
}

TEST(TurnIslands, NormalsFollow)
{
  IncompleteModel model = modelOf(icosphere(2));
  const Directions before = model.normals;
  turnIslands(model, flips({true}));
  for (std::size_t v = 0; v < before.size(); ++v)
    EXPECT_EQ(Direction(-before[v]), model.normals[v]);
}

TEST(TurnIslands, AdjacencyFollows)
{
  IncompleteModel model = modelOf(icosphere(2));
  turnIslands(model, flips({true}));
  ccaa::TriangleAdjacency anew;
  anew.build(model.triangles, model.positions.size());
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    for (int corner = 0; corner < 3; ++corner)
      EXPECT_EQ(anew.across(static_cast<pcl::index_t>(t), corner),
                model.adjacency.across(static_cast<pcl::index_t>(t), corner));
}

TEST(TurnIslands, OtherIslandsKeepTheirTriangles)
{
  IncompleteModel model = modelOf(inPieces(icosphere(3), 0.2));
  const Triangles before = model.triangles;
  turnIslands(model, flips({false, true, false, false, false, false, false, false}));
  for (std::size_t t = 0; t < before.size(); ++t)
    EXPECT_EQ(model.island_of[t] == 1, before[t] != model.triangles[t]);
}

} // namespace
} // namespace pcl::repair
