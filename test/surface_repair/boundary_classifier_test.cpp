// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the boundary classifier as a class in PCL pipelines.
#include <pcl/console/print.h>
#include <pcl/io/ply_io.h>
#include <pcl/surface_repair/boundary_classifier.h>

#include <gtest/gtest.h>

#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include "support/shared_data.h"

#include <limits>

namespace pcl {
namespace {

using namespace ccaa::test;
using ccaa::Position;
using repair::BoundaryClass;

/** \brief Errors are part of these tests: keep them off the terminal. */
class QuietPcl {
public:
  QuietPcl() : level_(pcl::console::getVerbosityLevel())
  {
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  }
  ~QuietPcl() { pcl::console::setVerbosityLevel(level_); }

private:
  pcl::console::VERBOSITY_LEVEL level_;
};

pcl::PolygonMesh::Ptr
meshOf(const Shape& shape)
{
  return pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape));
}

/** \brief A sheet of 20 by 20 points without the two triangles of one square. */
Shape
sheetWithHole()
{
  return withoutTriangles(grid(20, 20), {360, 361});
}

std::vector<ClassifiedBoundary>
classified(const pcl::PolygonMesh::ConstPtr& mesh, BoundaryClassifier& classifier)
{
  classifier.setInputMesh(mesh);
  std::vector<ClassifiedBoundary> boundaries;
  EXPECT_TRUE(classifier.classify(boundaries));
  return boundaries;
}

/** \brief Fails, says why on the terminal, and leaves nothing. */
void
expectNothing(BoundaryClassifier& classifier)
{
  const QuietPcl quiet;
  std::vector<ClassifiedBoundary> boundaries(3);
  EXPECT_FALSE(classifier.classify(boundaries));
  EXPECT_TRUE(boundaries.empty());
}

TEST(BoundaryClassifier, FindsTheHoleAndTheBorderOfASheet)
{
  BoundaryClassifier classifier;
  const auto boundaries = classified(meshOf(sheetWithHole()), classifier);
  ASSERT_EQ(2u, boundaries.size());
  EXPECT_EQ(BoundaryClass::OUTER_BORDER, boundaries[0].boundary_class);
  EXPECT_EQ(76u, boundaries[0].vertices.size());
  EXPECT_DOUBLE_EQ(76.0, boundaries[0].length);
  EXPECT_EQ(BoundaryClass::HOLE, boundaries[1].boundary_class);
  EXPECT_EQ(4u, boundaries[1].vertices.size());
}

TEST(BoundaryClassifier, SpeaksOfCloudIndices)
{
  Shape shape = shuffled(sheetWithHole(), 3);
  shape.vertices.insert(shape.vertices.begin(), 5, Position(9, 9, 9));
  for (auto& triangle : shape.triangles)
    for (auto& corner : triangle)
      corner += 5;
  BoundaryClassifier classifier;
  for (const auto& boundary : classified(meshOf(shape), classifier))
    for (std::size_t i = 0; i < boundary.vertices.size(); ++i) {
      const auto at = [&](std::size_t k) {
        const auto vertex = boundary.vertices[k % boundary.vertices.size()];
        return shape.vertices[static_cast<std::size_t>(vertex)];
      };
      EXPECT_DOUBLE_EQ(1.0, (at(i + 1) - at(i)).norm());
    }
}

TEST(BoundaryClassifier, ReportsTheClassAndItsCounts)
{
  BoundaryClassifier classifier;
  classified(meshOf(sheetWithHole()), classifier);
  EXPECT_EQ(repair::IcmClass::ICM1, classifier.getReport().icm_class);
  EXPECT_EQ(1u, classifier.getReport().counts.simple_holes);
  EXPECT_EQ(1u, classifier.getReport().outer_borders);
  classifier.setSimpleHoleEdges(3);
  classified(meshOf(sheetWithHole()), classifier);
  EXPECT_EQ(repair::IcmClass::ICM2, classifier.getReport().icm_class);
}

TEST(BoundaryClassifier, AClosedMeshHasNoBoundaries)
{
  BoundaryClassifier classifier;
  EXPECT_TRUE(classified(meshOf(icosphere(2)), classifier).empty());
  EXPECT_EQ(1u, classifier.getReport().counts.islands);
}

TEST(BoundaryClassifier, TakesMeshesThatAreNoManifold)
{
  BoundaryClassifier classifier;
  const auto boundaries = classified(
      meshOf(joined(threeOnEdge(), translated(grid(19, 19), Position(5, 5, 5)))),
      classifier);
  EXPECT_EQ(1u, classifier.getReport().reading.overfull_edges);
  EXPECT_EQ(BoundaryClass::OUTER_BORDER, boundaries.back().boundary_class);
}

TEST(BoundaryClassifier, CanBeUsedAgain)
{
  BoundaryClassifier classifier;
  EXPECT_EQ(2u, classified(meshOf(cylinder(12, 5)), classifier).size());
  EXPECT_EQ(1u, classified(meshOf(grid(5, 5)), classifier).size());
  EXPECT_EQ(0u, classifier.getReport().undecided);
}

TEST(BoundaryClassifier, LeavesTheInputAlone)
{
  const auto mesh = meshOf(sheetWithHole());
  const pcl::PolygonMesh before = *mesh;
  BoundaryClassifier classifier;
  classified(mesh, classifier);
  EXPECT_TRUE(sameCloud(before.cloud, mesh->cloud));
  EXPECT_EQ(toTriangles(before.polygons), toTriangles(mesh->polygons));
}

TEST(BoundaryClassifier, IsTheSameForAnyNumberOfThreads)
{
  const auto mesh = meshOf(shuffled(sheetWithHole(), 1));
  BoundaryClassifier classifier;
  classifier.setNumberOfThreads(1);
  const auto expected = classified(mesh, classifier);
  classifier.setNumberOfThreads(4);
  const auto found = classified(mesh, classifier);
  ASSERT_EQ(expected.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(expected[i].vertices, found[i].vertices);
    EXPECT_EQ(expected[i].confidence, found[i].confidence);
  }
}

TEST(BoundaryClassifier, FailsWithoutAMesh)
{
  BoundaryClassifier classifier;
  expectNothing(classifier);
}

TEST(BoundaryClassifier, FailsOnMeshesWithoutTriangles)
{
  BoundaryClassifier classifier;
  classifier.setInputMesh(meshOf(Shape()));
  expectNothing(classifier);
  Shape points = grid(3, 3);
  points.triangles.clear();
  classifier.setInputMesh(meshOf(points));
  expectNothing(classifier);
}

TEST(BoundaryClassifier, FailsOnAnUnreadableCloud)
{
  const auto mesh = meshOf(grid(3, 3));
  mesh->cloud.data.resize(7);
  BoundaryClassifier classifier;
  classifier.setInputMesh(mesh);
  expectNothing(classifier);
}

TEST(BoundaryClassifier, NonFinitePointsCostTheirPolygons)
{
  Shape shape = grid(20, 20);
  shape.vertices[210] = Position::Constant(std::numeric_limits<double>::quiet_NaN());
  const QuietPcl quiet; // a warning counts what is left out
  BoundaryClassifier classifier;
  const auto boundaries = classified(meshOf(shape), classifier);
  EXPECT_EQ(6u, classifier.getReport().reading.invalid_polygons);
  ASSERT_EQ(2u, boundaries.size());
  EXPECT_EQ(BoundaryClass::HOLE, boundaries[1].boundary_class);
}

TEST(BoundaryClassifier, FailsOnParametersOutOfRange)
{
  for (const double value : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    BoundaryClassifier confidence;
    confidence.setInputMesh(meshOf(grid(3, 3)));
    confidence.setMinimumConfidence(value);
    expectNothing(confidence);
    BoundaryClassifier share;
    share.setInputMesh(meshOf(grid(3, 3)));
    share.setMinimumFacedShare(value);
    expectNothing(share);
  }
}

TEST(BoundaryClassifier, ReturnsWhatWasSet)
{
  BoundaryClassifier classifier;
  classifier.setMinimumConfidence(0.7);
  classifier.setMinimumFacedShare(0.1);
  classifier.setSimpleHoleEdges(5);
  EXPECT_EQ(0.7, classifier.getMinimumConfidence());
  EXPECT_EQ(0.1, classifier.getMinimumFacedShare());
  EXPECT_EQ(5u, classifier.getSimpleHoleEdges());
}

TEST(BoundaryClassifier, StopsWhenTheCallbackSaysNo)
{
  for (const std::string refused : {"reading", "boundaries"}) {
    BoundaryClassifier classifier;
    classifier.setInputMesh(meshOf(sheetWithHole()));
    classifier.setProgressCallback(
        [&](const std::string& stage, double) { return stage != refused; });
    expectNothing(classifier);
  }
}

TEST(BoundaryClassifier, TheBunnyHasFiveHoles)
{
  const std::string path = sharedData("bunny/bun_zipper.ply");
  SKIP_WITHOUT_DATA(path);
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  ASSERT_GE(pcl::io::loadPLYFile(path, *mesh), 0);
  BoundaryClassifier classifier;
  const auto boundaries = classified(mesh, classifier);
  EXPECT_EQ(5u, boundaries.size());
  for (const auto& boundary : boundaries)
    EXPECT_EQ(BoundaryClass::HOLE, boundary.boundary_class);
  EXPECT_EQ(1113u, classifier.getReport().free_points);
}

TEST(BoundaryClassifier, TheMaskHasSixHolesAndAnOuterBorder)
{
  const std::string path = sharedData("holes/holes.ply");
  SKIP_WITHOUT_DATA(path);
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  ASSERT_GE(pcl::io::loadPLYFile(path, *mesh), 0);
  BoundaryClassifier classifier;
  for (const auto& boundary : classified(mesh, classifier))
    EXPECT_EQ(boundary.vertices.size() == 136,
              boundary.boundary_class == BoundaryClass::OUTER_BORDER);
  EXPECT_EQ(6u, classifier.getReport().counts.complex_holes);
  EXPECT_EQ(1u, classifier.getReport().outer_borders);
  EXPECT_EQ(repair::IcmClass::ICM2, classifier.getReport().icm_class);
}

} // namespace
} // namespace pcl
