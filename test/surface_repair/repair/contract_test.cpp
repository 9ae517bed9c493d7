// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what ForceLineHoleRepair promises for any input.

#include <pcl/console/print.h>
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "mesh/surface_topology.h"
#include "support/random_source.h"
#include "support/repair_fixture.h"

#include <atomic>
#include <cmath>
#include <limits>

namespace pcl::repair {
namespace {

using namespace test;

/** PCL's errors are expected here and would only hide others. */
class RepairContract : public ::testing::Test {
protected:
  void
  SetUp() override
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
};

Shape
holedSphere()
{
  return inPieces(icosphere(3), [](const Position& p) { return p.z() > 0.8 ? -1 : 0; });
}

Shape
sphereInFour()
{
  return inPieces(icosphere(4), cells(4, 0.16, 3));
}

bool
sameMesh(const pcl::PolygonMesh& a, const pcl::PolygonMesh& b)
{
  return a.cloud.data == b.cloud.data &&
         toTriangles(a.polygons) == toTriangles(b.polygons);
}

TEST_F(RepairContract, GivesNothingForTooFewPoints)
{
  for (std::size_t points = 0; points < 3; ++points) {
    const Shape few{Positions(points, Position::Zero()), {}};
    const Repaired result = repaired(few);
    EXPECT_TRUE(result.output.polygons.empty());
    EXPECT_FALSE(result.report.reading.problem.empty());
  }
}

TEST_F(RepairContract, GivesNothingForAMeshWithoutTriangles)
{
  const Repaired result = repaired({icosphere(1).vertices, {}});
  EXPECT_TRUE(result.output.polygons.empty());
  EXPECT_FALSE(result.report.reading.problem.empty());
}

TEST_F(RepairContract, LeavesAClosedMeshByteForByte)
{
  for (const Shape& closed : {tetrahedron(), icosphere(3), torus(30, 20), cube(4)}) {
    const Repaired result = repaired(closed);
    EXPECT_TRUE(sameMesh(result.input, result.output));
    EXPECT_TRUE(result.report.complete());
    EXPECT_TRUE(result.report.holes.empty());
  }
}

TEST_F(RepairContract, LeavesAMoebiusBandAloneAndSaysSo)
{
  const Repaired result = repaired(moebiusBand(40));
  EXPECT_TRUE(
      sameUnorientedTriangles(toTriangles(result.input.polygons), result.triangles()));
  ASSERT_EQ(1U, result.report.holes.size());
  EXPECT_EQ(OpenReason::ONE_SIDED, result.report.holes[0].open);
  EXPECT_FALSE(result.report.complete());
  EXPECT_TRUE(result.report.islands[0].one_sided);
}

TEST_F(RepairContract, ClosesASingleTriangleOrLeavesItButSurvives)
{
  const Repaired result = repaired(
      {{Position(0, 0, 0), Position(1, 0, 0), Position(0, 1, 0)}, {{0, 1, 2}}});
  EXPECT_FALSE(result.output.polygons.empty());
  expectNothingWorse(result, toTriangles(result.input.polygons));
}

TEST_F(RepairContract, KeepsPointsThatAreNotFinite)
{
  Shape shape = holedSphere();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  shape.vertices.emplace_back(nan, 0.0, 1.0);
  shape.vertices.emplace_back(0.0, std::numeric_limits<double>::infinity(), 0.0);
  const Repaired result = repaired(shape);
  expectNothingWorse(result, shape.triangles);
  EXPECT_EQ(0U, topologyOf(result.triangles()).borders);
  for (std::size_t i = pointsOf(result.input); i < pointsOf(result.output); ++i)
    EXPECT_TRUE(ccaa::positionView(result.output.cloud)[i].allFinite());
}

TEST_F(RepairContract, CopesWithDuplicateFreePoints)
{
  Shape shape = holedSphere();
  for (int i = 0; i < 20; ++i)
    shape.vertices.emplace_back(0.0, 0.0, 1.0);
  const Repaired result = repaired(shape);
  expectNothingWorse(result, shape.triangles);
  EXPECT_EQ(0U, topologyOf(result.triangles()).borders);
}

TEST_F(RepairContract, CopesWithDuplicateVertices)
{
  Shape shape = holedSphere();
  shape.vertices.insert(
      shape.vertices.end(), shape.vertices.begin(), shape.vertices.end());
  expectNothingWorse(repaired(shape), shape.triangles);
}

TEST_F(RepairContract, KeepsAllFieldsAndMixesThemForNewVertices)
{
  const Shape shape = holedSphere();
  pcl::PointCloud<pcl::PointXYZRGBNormal> cloud;
  for (const Position& p : shape.vertices) {
    pcl::PointXYZRGBNormal point;
    point.getVector3fMap() = p.cast<float>();
    point.getNormalVector3fMap() = p.cast<float>();
    point.r = 200;
    point.g = static_cast<std::uint8_t>(100.0 + 50.0 * p.x());
    point.b = 10;
    point.curvature = 7.0F;
    cloud.push_back(point);
  }
  pcl::PolygonMesh mesh;
  pcl::toPCLPointCloud2(cloud, mesh.cloud);
  mesh.polygons = toPolygons(shape.triangles);
  const Repaired result = repaired(mesh);
  expectNothingWorse(result, shape.triangles);
  pcl::PointCloud<pcl::PointXYZRGBNormal> after;
  pcl::fromPCLPointCloud2(result.output.cloud, after);
  ASSERT_GT(after.size(), cloud.size());
  for (std::size_t i = cloud.size(); i < after.size(); ++i) {
    EXPECT_NEAR(200, after[i].r, 1);
    EXPECT_NEAR(100, after[i].g, 50);
    EXPECT_NEAR(7.0F, after[i].curvature, 1e-4F);
    EXPECT_GT(after[i].getNormalVector3fMap().z(), 0.5F);
    EXPECT_NEAR(1.0F, after[i].getNormalVector3fMap().norm(), 0.01F);
  }
}

TEST_F(RepairContract, IsTheSameForAnyNumberOfThreads)
{
  const pcl::PolygonMesh mesh = toPolygonMesh(sphereInFour());
  const Repaired first = repaired(mesh, {}, {}, 1);
  for (const unsigned int threads : {2U, 7U})
    EXPECT_TRUE(sameMesh(first.output, repaired(mesh, {}, {}, threads).output))
        << threads;
}

/** Free points scattered around the cap that a sphere lacks, many of them off it. */
class ScatteredFreePoints : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(ScatteredFreePoints, KeepNoHoleOpenThatIsClosedWithoutThem)
{
  RandomSource random(GetParam());
  Positions free_points;
  for (int k = 0; k < 150; ++k) {
    const double x = random.uniform(-0.6, 0.6);
    const double y = random.uniform(-0.6, 0.6);
    const double height = std::sqrt(1.0 - x * x - y * y);
    free_points.emplace_back(x, y, height + 0.05 * random.normal());
  }
  const Repaired result = repaired(toPolygonMesh(holedSphere()), free_points);
  EXPECT_EQ(0U, countBoundaryEdges(result.triangles()));
  expectNothingWorse(result, toTriangles(result.input.polygons));
}

INSTANTIATE_TEST_SUITE_P(Seeds,
                         ScatteredFreePoints,
                         ::testing::Range(std::uint64_t{0}, std::uint64_t{12}));

TEST_F(RepairContract, IsTheSameForAnyNumberOfThreadsInFullModeWithFreePoints)
{
  const DamagedModel made = casesWithFreePoints(1).front().make();
  RepairParameters parameters;
  parameters.survey.field.mode = FieldMode::FULL;
  const pcl::PolygonMesh mesh = toPolygonMesh(made.damaged);
  const Repaired first = repaired(mesh, made.free_points, parameters, 1);
  EXPECT_TRUE(
      sameMesh(first.output, repaired(mesh, made.free_points, parameters, 7).output));
}

TEST_F(RepairContract, DoesNotChangeItsInput)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(sphereInFour()));
  const pcl::PolygonMesh before = *mesh;
  ForceLineHoleRepair repair;
  repair.setInputMesh(mesh);
  pcl::PolygonMesh output;
  repair.process(output);
  EXPECT_TRUE(sameMesh(before, *mesh));
}

TEST_F(RepairContract, AnObjectCanBeUsedAgain)
{
  ForceLineHoleRepair repair;
  for (const Shape& shape : {sphereInFour(), holedSphere(), sphereInFour()}) {
    repair.setInputMesh(pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)));
    pcl::PolygonMesh output;
    repair.process(output);
    EXPECT_TRUE(sameMesh(repaired(shape).output, output));
    EXPECT_EQ(output.polygons.size(), repair.getReport().origins.size());
  }
}

TEST_F(RepairContract, TheOutputMayBeTheInput)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(sphereInFour()));
  const pcl::PolygonMesh before = *mesh;
  ForceLineHoleRepair repair;
  repair.setInputMesh(mesh);
  repair.process(*mesh);
  EXPECT_TRUE(sameMesh(repaired(before).output, *mesh));
}

TEST_F(RepairContract, TheOutputMayHoldAnythingBefore)
{
  const Shape shape = holedSphere();
  ForceLineHoleRepair repair;
  repair.setInputMesh(pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)));
  pcl::PolygonMesh output = toPolygonMesh(cube(3));
  repair.process(output);
  EXPECT_TRUE(sameMesh(repaired(shape).output, output));
}

TEST_F(RepairContract, CanBeCancelledAtEveryStage)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(sphereInFour()));
  for (const int calls : {0, 1, 3, 10}) {
    std::atomic<int> left{calls};
    ForceLineHoleRepair repair;
    repair.setInputMesh(mesh);
    repair.setProgressCallback([&](const std::string&, double) { return left-- > 0; });
    pcl::PolygonMesh output;
    repair.process(output);
    EXPECT_TRUE(output.polygons.empty()) << calls;
    EXPECT_TRUE(repair.getReport().cancelled) << calls;
    EXPECT_FALSE(repair.getReport().complete());
  }
}

TEST_F(RepairContract, RefusesParametersOutOfRange)
{
  using Change = void (*)(RepairParameters&);
  const Change changes[] = {
      [](RepairParameters& p) { p.survey.field.trust = 1.0; },
      [](RepairParameters& p) { p.survey.field.falloff_exponent = 0.0; },
      [](RepairParameters& p) { p.survey.field.interpolation = -1.0; },
      [](RepairParameters& p) { p.survey.field.room = 1.0; },
      [](RepairParameters& p) { p.survey.field.coarse_distance = -1.0; },
      [](RepairParameters& p) { p.survey.hole_threshold = 0.6; },
      [](RepairParameters& p) { p.refinement.edge_length = 0.0; },
      [](RepairParameters& p) { p.survey.field.near = std::nan(""); }};
  for (std::size_t i = 0; i < std::size(changes); ++i) {
    RepairParameters parameters;
    changes[i](parameters);
    EXPECT_TRUE(repaired(holedSphere(), parameters).output.polygons.empty()) << i;
  }
}

TEST_F(RepairContract, LeavesHolesOpenThatAreTooLarge)
{
  RepairParameters parameters;
  parameters.filling.greatest_hole = 5;
  const Repaired result = repaired(holedSphere(), parameters);
  ASSERT_EQ(1U, result.report.holes.size());
  EXPECT_EQ(OpenReason::TOO_LARGE, result.report.holes[0].open);
  EXPECT_EQ(result.input.polygons.size(), result.output.polygons.size());
}

TEST_F(RepairContract, LeavesIslandsApartWhenAsked)
{
  RepairParameters parameters;
  parameters.join_islands = false;
  const Repaired result = repaired(sphereInFour(), parameters);
  expectNothingWorse(result, toTriangles(result.input.polygons));
  for (const RepairBridge& bridge : result.report.bridges)
    EXPECT_EQ(bridge.begin_island, bridge.end_island);
}

TEST_F(RepairContract, EveryFillingClosesASphere)
{
  for (const FillingChoice choice : {FillingChoice::AUTOMATIC,
                                     FillingChoice::FAN,
                                     FillingChoice::MINIMUM_WEIGHT,
                                     FillingChoice::COMPLETION})
    for (const bool refine : {false, true}) {
      RepairParameters parameters;
      parameters.filling.choice = choice;
      parameters.refine = parameters.relax = refine;
      const Repaired result = repaired(sphereInFour(), parameters);
      const Topology found = topologyOf(result.triangles());
      EXPECT_EQ(2, found.characteristic) << static_cast<int>(choice) << refine;
      EXPECT_EQ(0U, found.borders) << static_cast<int>(choice) << refine;
      expectNothingWorse(result, toTriangles(result.input.polygons));
    }
}

TEST_F(RepairContract, ASingleOutlierMakesNoSpike)
{
  const Shape shape = holedSphere();
  const Repaired result = repaired(toPolygonMesh(shape), {Position(0.0, 0.0, 1.4)});
  const auto positions = ccaa::positionView(result.output.cloud);
  for (std::size_t i = pointsOf(result.input); i < pointsOf(result.output); ++i)
    EXPECT_LT(positions[i].norm(), 1.1) << i;
}

TEST_F(RepairContract, BridgesEndAtPointsOfTheIslandsThatTheyJoin)
{
  const Repaired result = repaired(sphereInFour());
  ASSERT_FALSE(result.report.bridges.empty());
  const auto component = componentOfTriangles(toTriangles(result.input.polygons));
  const auto positions = ccaa::positionView(result.input.cloud);
  for (const RepairBridge& bridge : result.report.bridges) {
    ASSERT_LT(static_cast<std::size_t>(bridge.begin), pointsOf(result.input));
    ASSERT_LT(static_cast<std::size_t>(bridge.end), pointsOf(result.input));
    ASSERT_GE(bridge.points.size(), 2U);
    EXPECT_EQ(bridge.points.size(), bridge.normals.size());
    EXPECT_GT(bridge.quality, 0.0);
    EXPECT_LT(bridge.end_island, result.report.islands.size());
    const auto begin = static_cast<std::size_t>(bridge.begin);
    EXPECT_LT((positions[begin] - bridge.points.front()).norm(), 0.1);
  }
}

} // namespace
} // namespace pcl::repair
