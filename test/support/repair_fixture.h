// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: repairs of this room's tests and what each has to keep.
#pragma once

#include <pcl/surface_repair/force_line_hole_repair.h>

#include <gtest/gtest.h>

#include "icadm/incomplete_model.h"
#include "mesh/cloud_access.h"
#include "mesh/intersection.h"
#include "repair/decision_proposal.h"
#include "support/mesh_asserts.h"
#include "support/repair_shapes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <memory>
#include <string>

namespace pcl::repair::test {

using namespace ccaa::test;

/** \brief A repair that was made. */
struct Repaired {
  pcl::PolygonMesh input;
  pcl::PolygonMesh output;
  RepairReport report;

  Triangles
  triangles() const
  {
    return toTriangles(output.polygons);
  }
};

inline Repaired
repaired(const pcl::PolygonMesh& input,
         const Positions& free_points = {},
         const RepairParameters& parameters = {},
         unsigned int threads = 1)
{
  Repaired result;
  result.input = input;
  ForceLineHoleRepair repair;
  repair.setInputMesh(pcl::make_shared<pcl::PolygonMesh>(input));
  repair.setParameters(parameters);
  repair.setNumberOfThreads(threads);
  if (!free_points.empty())
    repair.setFreePoints(
        pcl::make_shared<pcl::PCLPointCloud2>(toPolygonMesh({free_points, {}}).cloud));
  repair.process(result.output);
  result.report = repair.getReport();
  return result;
}

inline Repaired
repaired(const Shape& shape, const RepairParameters& parameters = {})
{
  return repaired(toPolygonMesh(shape), {}, parameters);
}

/** \brief What is decided about a shape when nobody says anything. */
inline Decisions
proposed(const Shape& shape, const RepairParameters& parameters = {})
{
  return proposeDecisions(
      surveyModel(pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape)),
                  nullptr,
                  parameters.survey,
                  {}),
      parameters);
}

/** \brief The repair that follows decisions. */
inline Repaired
decided(const Shape& shape, const Decisions& decisions)
{
  RepairParameters parameters;
  parameters.survey.decisions = std::make_shared<const Decisions>(decisions);
  return repaired(shape, parameters);
}

inline std::size_t
pointsOf(const pcl::PolygonMesh& mesh)
{
  return static_cast<std::size_t>(mesh.cloud.width) * mesh.cloud.height;
}

/** \brief The triangles of the output, where a point appended as a copy of another one
 * (for a fan that only touches it) counts as that one. */
inline Triangles
trianglesOverPlaces(const Repaired& result)
{
  const Positions places =
      ccaa::copyPositions(ccaa::positionView(result.output.cloud)).positions;
  const auto key = [](const Position& p) {
    return std::array<double, 3>{p.x(), p.y(), p.z()};
  };
  std::map<std::array<double, 3>, pcl::index_t> first;
  for (const Triangle& triangle : toTriangles(result.input.polygons))
    for (const pcl::index_t corner : triangle)
      first.emplace(key(places[static_cast<std::size_t>(corner)]), corner);
  const auto given = static_cast<pcl::index_t>(pointsOf(result.input));
  Triangles triangles = result.triangles();
  for (Triangle& triangle : triangles)
    for (pcl::index_t& corner : triangle) {
      const auto same = first.find(key(places[static_cast<std::size_t>(corner)]));
      if (corner >= given && same != first.end())
        corner = same->second;
    }
  return triangles;
}

/** \brief The points of the input come first, byte for byte, in the same layout. */
inline ::testing::AssertionResult
keepsPoints(const Repaired& result)
{
  const auto& before = result.input.cloud;
  const auto& after = result.output.cloud;
  const auto same_field = [](const auto& a, const auto& b) {
    return a.name == b.name && a.offset == b.offset && a.datatype == b.datatype &&
           a.count == b.count;
  };
  if (before.point_step != after.point_step || !std::equal(before.fields.begin(),
                                                           before.fields.end(),
                                                           after.fields.begin(),
                                                           after.fields.end(),
                                                           same_field))
    return ::testing::AssertionFailure() << "another layout";
  const std::size_t bytes = pointsOf(result.input) * before.point_step;
  if (after.data.size() < bytes ||
      !std::equal(before.data.begin(),
                  before.data.begin() + static_cast<std::ptrdiff_t>(bytes),
                  after.data.begin()))
    return ::testing::AssertionFailure() << "other bytes";
  return ::testing::AssertionSuccess();
}

inline std::size_t
countIntersections(const pcl::PolygonMesh& mesh)
{
  ccaa::RunControl control;
  return ccaa::findSelfIntersections(
             toTriangles(mesh.polygons), ccaa::positionView(mesh.cloud), 1, control)
      .pairs.size();
}

/** \brief No two triangles meet that did not before. */
inline ::testing::AssertionResult
addsNoIntersection(const Repaired& result)
{
  const std::size_t before = countIntersections(result.input);
  const std::size_t after = countIntersections(result.output);
  if (after <= before)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << after - before << " pairs of triangles";
}

/** \brief The numbers of the report and the lists of it agree with the mesh. */
inline ::testing::AssertionResult
hasConsistentReport(const Repaired& result)
{
  const RepairReport& report = result.report;
  const std::size_t triangles = result.output.polygons.size();
  const auto fail = [](const char* what) {
    return ::testing::AssertionFailure() << what;
  };
  if (report.origins.size() != triangles || report.hole_of.size() != triangles)
    return fail("provenance of another number of triangles");
  if (report.input_triangles + report.new_triangles != triangles)
    return fail("number of triangles");
  if (pointsOf(result.input) + report.new_vertices != pointsOf(result.output))
    return fail("number of vertices");
  std::vector<std::size_t> made(report.holes.size(), 0);
  for (std::size_t t = 0; t < triangles; ++t) {
    const bool is_input = report.origins[t] == TriangleOrigin::INPUT;
    if (is_input != (report.hole_of[t] == NONE))
      return fail("a triangle of the input in a hole, or a new one in none");
    if (!is_input && ++made.at(report.hole_of[t]) == 0)
      return fail("no such hole");
  }
  std::size_t shortfalls = 0;
  for (std::size_t h = 0; h < report.holes.size(); ++h) {
    shortfalls += report.holes[h].shortfall ? 1 : 0;
    if (made[h] != report.holes[h].triangles)
      return fail("triangles of a hole");
    if ((report.holes[h].open == OpenReason::NONE) != (made[h] > 0))
      return fail("a closed hole without triangles, or an open one with some");
  }
  return shortfalls == report.shortfalls ? ::testing::AssertionSuccess()
                                         : fail("number of shortfalls");
}

/** \brief Whatever becomes of the holes: manifold, nothing lost, nothing worse. */
inline void
expectNothingWorse(const Repaired& result, const Triangles& wound)
{
  const Triangles triangles = result.triangles();
  EXPECT_TRUE(isIcadm(triangles, pointsOf(result.output)));
  EXPECT_TRUE(isSubsetOf(wound, triangles));
  EXPECT_TRUE(keepsPoints(result));
  EXPECT_TRUE(addsNoIntersection(result));
  EXPECT_TRUE(hasConsistentReport(result));
}

/** As expectNothingWorse(), where islands may touch in points. */
inline void
expectNothingLost(const Repaired& result)
{
  EXPECT_TRUE(isIcadm(result.triangles(), pointsOf(result.output)));
  EXPECT_TRUE(
      isSubsetOf(toTriangles(result.input.polygons), trianglesOverPlaces(result)));
  EXPECT_TRUE(keepsPoints(result));
  EXPECT_TRUE(addsNoIntersection(result));
  EXPECT_TRUE(hasConsistentReport(result));
}

/** One piece, and nothing that was given is lost. */
inline void
expectOnePiece(const Repaired& result, long characteristic)
{
  expectNothingLost(result);
  EXPECT_EQ(1U, topologyOf(result.triangles()).components);
  EXPECT_EQ(characteristic, topologyOf(result.triangles()).characteristic);
}

/** Whole, and nothing that was given is lost. */
inline void
expectWhole(const Repaired& result, std::size_t pieces, long characteristic)
{
  expectNothingLost(result);
  const Topology after = topologyOf(result.triangles());
  EXPECT_EQ(pieces, after.components);
  EXPECT_EQ(characteristic, after.characteristic);
  EXPECT_EQ(0U, after.borders);
  EXPECT_TRUE(result.report.complete());
}

} // namespace pcl::repair::test
