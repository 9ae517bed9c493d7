// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the normals of vertices.
#include <gtest/gtest.h>

#include "mesh/vertex_normals.h"
#include "support/shapes.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::ccaa::test {
namespace {

using Normals = std::vector<Eigen::Vector3f>;

Normals
normalsOf(const Shape& shape, int threads = 1, std::size_t block_size = BLOCK_SIZE)
{
  return vertexNormals(
      shape.triangles, shape.vertices, LoopContext{threads, nullptr, "", block_size});
}

::testing::AssertionResult
isNear(const Eigen::Vector3f& normal, const Position& expected, double tolerance = 1e-6)
{
  if ((normal.cast<double>() - expected).norm() <= tolerance)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << normal.transpose() << " instead of " << expected.transpose();
}

TEST(VertexNormals, OfAPlaneAreItsNormal)
{
  for (const auto& normal : normalsOf(grid(5, 4)))
    EXPECT_TRUE(isNear(normal, Position::UnitZ()));
}

TEST(VertexNormals, OfASphereAreRadial)
{
  const Shape sphere = icosphere(4, 3.0);
  const Normals normals = normalsOf(sphere);
  for (std::size_t i = 0; i < normals.size(); ++i)
    EXPECT_TRUE(isNear(normals[i], sphere.vertices[i].normalized(), 2e-3));
}

TEST(VertexNormals, OfTheFirstVerticesOfAnIcosahedronAreRadialBySymmetry)
{
  const Shape sphere = icosphere(0);
  const Normals normals = normalsOf(sphere);
  for (std::size_t i = 0; i < normals.size(); ++i)
    EXPECT_TRUE(isNear(normals[i], sphere.vertices[i]));
}

/** Each face counts as a right angle, whether one or two triangles make it up. */
TEST(VertexNormals, OfACubeDoNotDependOnItsDiagonals)
{
  for (const int divisions : {1, 3}) {
    const Shape shape = cube(divisions);
    const Normals normals = normalsOf(shape);
    for (std::size_t i = 0; i < normals.size(); ++i) {
      Position expected = Position::Zero();
      for (int axis = 0; axis < 3; ++axis)
        expected[axis] = shape.vertices[i][axis] == 0   ? -1
                         : shape.vertices[i][axis] == 1 ? 1
                                                        : 0;
      EXPECT_TRUE(isNear(normals[i], expected.normalized()));
    }
  }
}

TEST(VertexNormals, OfATetrahedronsCornerWeighByAngle)
{
  // At (1, 0, 0) two faces of 45 degrees and the oblique one of 60.
  const Shape shape = tetrahedron();
  const Position oblique = Position::Ones().normalized();
  const Position expected = M_PI / 4 * Position(0, -1, 0) +
                            M_PI / 4 * Position(0, 0, -1) + M_PI / 3 * oblique;
  const Normals normals = normalsOf(shape);
  for (std::size_t i = 0; i < 4; ++i) {
    const Position& at = shape.vertices[i];
    const bool is_known = at.x() == 1 || at.norm() == 0;
    const Position known = at.x() == 1 ? expected.normalized() : Position(-oblique);
    EXPECT_TRUE(!is_known || isNear(normals[i], known)) << i;
  }
}

TEST(VertexNormals, FollowTheWinding)
{
  Shape shape = icosphere(2);
  const Normals outward = normalsOf(shape);
  shape.triangles = reversed(shape.triangles);
  const Normals inward = normalsOf(shape);
  for (std::size_t i = 0; i < outward.size(); ++i)
    EXPECT_TRUE(isNear(inward[i], -outward[i].cast<double>()));
}

TEST(VertexNormals, DoNotDependOnTheScale)
{
  const Shape shape = torus(20, 10);
  const Normals expected = normalsOf(shape);
  for (const double factor : {1e-9, 1e9}) {
    const Normals normals = normalsOf(scaled(shape, factor));
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_TRUE(isNear(normals[i], expected[i].cast<double>())) << factor;
  }
}

TEST(VertexNormals, AreTheSameForAnyNumberOfThreads)
{
  const Shape shape = shuffled(torus(60, 30), 5);
  const Normals expected = normalsOf(shape, 1, 100);
  for (const int threads : {2, 7}) {
    const Normals normals = normalsOf(shape, threads, 100);
    EXPECT_EQ(0,
              std::memcmp(normals.data(),
                          expected.data(),
                          expected.size() * sizeof(Eigen::Vector3f)));
  }
}

TEST(VertexNormals, PointsWithoutTrianglesHaveNone)
{
  Shape shape = icosphere(1);
  shape.vertices.push_back({5, 5, 5});
  const Normals normals = normalsOf(shape);
  EXPECT_TRUE(normals.back().array().isNaN().all());
  EXPECT_TRUE(normals.front().allFinite());
}

TEST(VertexNormals, DegenerateAndNonFiniteTrianglesDoNotCount)
{
  Shape shape = grid(2, 2);
  const double infinity = std::numeric_limits<double>::infinity();
  shape.vertices.push_back({0.5, 0, 0});
  shape.vertices.push_back({infinity, 0, 1});
  shape.triangles.push_back({0, 4, 1}); // on one line
  shape.triangles.push_back({0, 1, 5});
  const Normals normals = normalsOf(shape);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_TRUE(isNear(normals[i], Position::UnitZ()));
  EXPECT_TRUE(normals[4].hasNaN());
  EXPECT_TRUE(normals[5].hasNaN());
}

TEST(VertexNormals, OfTrianglesThatCancelOutAreNone)
{
  Shape shape = grid(2, 2);
  for (const Triangle& t : reversed(shape.triangles))
    shape.triangles.push_back(t);
  for (const auto& normal : normalsOf(shape))
    EXPECT_TRUE(normal.hasNaN());
}

TEST(VertexNormals, OfNothingAreNothing) { EXPECT_TRUE(normalsOf(Shape()).empty()); }

} // namespace
} // namespace pcl::ccaa::test
