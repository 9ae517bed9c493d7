// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: running ProjectionCompletion in tests.
#pragma once

#include <pcl/console/print.h>
#include <pcl/surface_ccaa/projection_completion.h>
#include <pcl/surface_ccaa/umbrella_filter.h>

#include <gtest/gtest.h>

#include "mesh/mesh_facts.h"
#include "support/clouds.h"
#include "support/completion_shapes.h"
#include "support/mesh_asserts.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace pcl::ccaa::test {

/** \brief A completion of clouds without normals. The text of errors is captured by
 * those tests that ask for it, and not under test elsewhere. */
class CompletionTest : public ::testing::Test {
protected:
  using Completion = ProjectionCompletion<PointXYZ>;
  using Cloud = PointCloud<PointXYZ>;

  CompletionTest()
  {
    console::setVerbosityLevel(console::L_ALWAYS);
    completion_.setNumberOfThreads(1); // a busy machine makes small runs wait for more
  }

  Triangles
  run()
  {
    std::vector<Vertices> polygons;
    completion_.reconstruct(polygons);
    return toTriangles(polygons);
  }

  Triangles
  reconstruct(const Positions& points)
  {
    completion_.setInputCloud(toCloud(points));
    completion_.setPartialMesh(nullptr);
    return run();
  }

  /** \brief Complete the triangles of a shape over the cloud of its vertices. */
  Triangles
  complete(const Shape& given)
  {
    completion_.setInputCloud(toCloud(given.vertices));
    completion_.setPartialMesh(std::make_shared<PolygonMesh>(toPolygonMesh(given)));
    return run();
  }

  /** \brief Run expecting an error message and nothing else. */
  void
  expectError(const std::string& part_of_message)
  {
    console::setVerbosityLevel(console::L_ERROR);
    ::testing::internal::CaptureStderr();
    EXPECT_TRUE(run().empty());
    const std::string message = ::testing::internal::GetCapturedStderr();
    console::setVerbosityLevel(console::L_ALWAYS);
    EXPECT_NE(message.find("ProjectionCompletion"), std::string::npos) << message;
    EXPECT_NE(message.find(part_of_message), std::string::npos) << message;
  }

  Completion completion_;
};

/** \brief What a partial mesh has to be: an ICADM, by the umbrella filter. */
inline Shape
filteredToIcadm(Shape shape, std::size_t minimum_internal_points = 10)
{
  UmbrellaFilter filter;
  filter.setMinimumInternalPoints(minimum_internal_points);
  filter.setNumberOfThreads(1);
  filter.setInputMesh(std::make_shared<PolygonMesh>(toPolygonMesh(shape)));
  PolygonMesh output;
  filter.process(output);
  shape.triangles = toTriangles(output.polygons);
  return shape;
}

inline std::set<index_t>
usedPoints(const Triangles& triangles)
{
  std::set<index_t> used;
  for (const Triangle& t : triangles)
    used.insert(t.begin(), t.end());
  return used;
}

inline MeshFacts
factsOf(const Triangles& triangles, const Positions& points)
{
  RunControl control;
  return measureMesh(triangles, roundedToFloat(points), {}, control);
}

/** \brief What every result has to be: an ICADM, consistently wound, without
 * self-intersections. \return its facts */
inline MeshFacts
expectSound(const Triangles& triangles, const Positions& points)
{
  EXPECT_TRUE(isIcadm(triangles, points.size()));
  EXPECT_TRUE(isConsistentlyWound(triangles));
  const MeshFacts facts = factsOf(triangles, points);
  EXPECT_EQ(*facts.self_intersections, 0u);
  EXPECT_EQ(facts.degenerate_triangles, 0u);
  return facts;
}

/** \brief Sound, closed, outward, with every point. */
inline void
expectClosed(const Triangles& triangles,
             const Positions& points,
             std::size_t components,
             long genus)
{
  const MeshFacts facts = expectSound(triangles, points);
  EXPECT_EQ(facts.boundary_edges, 0u);
  EXPECT_EQ(facts.free_vertices, 0u);
  EXPECT_EQ(facts.components, components);
  ASSERT_TRUE(facts.genus.has_value());
  EXPECT_EQ(*facts.genus, genus);
  ASSERT_TRUE(facts.volume.has_value());
  EXPECT_GT(*facts.volume, 0.0);
}

/** \brief The result begins with the given triangles in their order; each piece of them
 * is wound as it was, or turned over as a whole. */
inline ::testing::AssertionResult
keepsGiven(const Triangles& given, const Triangles& result)
{
  if (result.size() < given.size())
    return ::testing::AssertionFailure() << "fewer triangles than given";
  const std::vector<std::size_t> pieces = pieceOfTriangles(given);
  const auto turn = [](Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  };
  std::map<std::size_t, bool> reversed;
  for (std::size_t t = 0; t < given.size(); ++t) {
    const Triangle expected = turn(given[t]), actual = turn(result[t]);
    const bool other_way = expected != actual;
    if (other_way && Triangle{expected[0], expected[2], expected[1]} != actual)
      return ::testing::AssertionFailure() << "triangle " << t << " is another one";
    if (reversed.emplace(pieces[t], other_way).first->second != other_way)
      return ::testing::AssertionFailure()
             << "triangle " << t << " is turned over, its neighbors are not";
  }
  return ::testing::AssertionSuccess();
}

} // namespace pcl::ccaa::test
