// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the triangulation of least weight.

#include <gtest/gtest.h>

#include "filling/disc_check.h"
#include "filling/minimum_weight_filling.h"
#include "filling/triangulation_table.h"
#include "filling_samples.h"
#include "mesh/intersection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace pcl::repair {
namespace {

using test::areaOf;
using test::fillingOf;
using test::holeIn;
using test::HoleShape;
using test::meetings;

bool
hasEdge(const Filling& filling, pcl::index_t a, pcl::index_t b)
{
  return std::any_of(
      filling.triangles.begin(), filling.triangles.end(), [&](Triangle t) {
        return std::count(t.begin(), t.end(), a) == 1 &&
               std::count(t.begin(), t.end(), b) == 1;
      });
}

/** A hole along three quarters of a circle's circumference, two edges high. */
FillingTask
slitAlongTube(std::size_t along)
{
  FillingTask task;
  const auto at = [&](std::size_t k, double z) {
    const double angle =
        1.5 * M_PI * static_cast<double>(k) / static_cast<double>(along);
    return Position(std::cos(angle), std::sin(angle), z);
  };
  for (std::size_t k = 0; k < along; ++k)
    task.polygon.points.push_back(at(k, 0.2));
  for (std::size_t k = along; k > 0; --k)
    task.polygon.points.push_back(at(k, 0.0));
  task.polygon.points.push_back(at(0, 0.0));
  task.polygon.points.insert(
      task.polygon.points.begin() + static_cast<std::ptrdiff_t>(along), at(along, 0.2));
  for (std::size_t k = 0; k < task.polygon.size(); ++k) {
    Position middle = task.polygon.points[k] + 0.5 * task.polygon.edge(k);
    middle.z() = 0.0;
    task.polygon.normals.push_back(middle.normalized());
  }
  return task;
}

TEST(MinimumWeightFilling, IsADiscForAnyNumberOfEdges)
{
  for (const std::size_t edges : {3, 4, 5, 6, 17, 160, 161, 162, 333, 600, 2001}) {
    const Filling filling = fillingOf(holeIn({edges, test::saddleHeight, 0.002}));
    EXPECT_TRUE(isDisc(filling, edges)) << edges;
    EXPECT_TRUE(filling.inner.empty());
  }
}

TEST(MinimumWeightFilling, FlatHoleIsCoveredOnce)
{
  for (const auto& [edges, roughness] :
       {std::pair<std::size_t, double>{30, 0.2}, {150, 0.2}, {400, 0.02}}) {
    const FillingTask task = holeIn({edges, HoleShape().height, roughness});
    double doubled = 0.0; // of the polygon, clockwise
    for (std::size_t k = 0; k < edges; ++k)
      doubled -=
          task.polygon.points[k].cross(task.polygon.points[task.polygon.next(k)]).z();
    EXPECT_NEAR(0.5 * doubled, areaOf(task, fillingOf(task)), 1e-9);
  }
}

TEST(MinimumWeightFilling, CapsAndSaddlesDoNotMeetThemselves)
{
  for (const auto& height : {test::capHeight, test::saddleHeight})
    for (const double roughness : {0.0, 0.05}) {
      const FillingTask task = holeIn({120, height, roughness});
      EXPECT_EQ(0U, meetings(task, fillingOf(task)));
    }
}

TEST(MinimumWeightFilling, SlitIsClosedAcrossNotOverTheTube)
{
  const FillingTask task = slitAlongTube(40);
  const double exact = 1.5 * M_PI * 0.2;
  EXPECT_NEAR(exact, areaOf(task, fillingOf(task)), 0.02 * exact);
}

TEST(MinimumWeightFilling, FoldsAgainstTheSurfaceDecide)
{
  // Either diagonal folds by the same angle: a valley, or a ridge.
  FillingTask task;
  task.polygon.points = {{0, 0, 0}, {0, 1, 0.3}, {1, 1, 0}, {1, 0, 0.3}};
  const Direction valley[2] = {{0.3, -0.3, 1}, {-0.3, 0.3, 1}};
  const Direction ridge[2] = {{-0.3, -0.3, 1}, {0.3, 0.3, 1}};
  task.polygon.normals = {valley[0], valley[0], valley[1], valley[1]};
  EXPECT_TRUE(hasEdge(fillingOf(task), 0, 2));
  task.polygon.normals = {ridge[0], ridge[1], ridge[1], ridge[0]};
  EXPECT_TRUE(hasEdge(fillingOf(task), 1, 3));
}

TEST(MinimumWeightFilling, JoinedPointsGetNoSecondEdge)
{
  FillingTask task = holeIn({4});
  task.polygon.points[1] *= 0.5; // the short diagonal is 1-3
  task.polygon.points[3] *= 0.5;
  ASSERT_TRUE(hasEdge(fillingOf(task), 1, 3));
  task.joined = [](std::size_t a, std::size_t b) {
    return std::min(a, b) == 1 && std::max(a, b) == 3;
  };
  EXPECT_TRUE(hasEdge(fillingOf(task), 0, 2));
}

TEST(MinimumWeightFilling, SaysWhenEveryDiagonalIsJoined)
{
  FillingTask task = holeIn({5});
  task.joined = [](std::size_t, std::size_t) { return true; };
  const Filling filling = fillingOf(task);
  EXPECT_FALSE(filling.closed());
  EXPECT_TRUE(filling.triangles.empty());
}

TEST(MinimumWeightFilling, ObstructedTrianglesAreAvoided)
{
  for (const std::size_t edges : {40, 200}) {
    FillingTask task = holeIn({edges});
    task.obstructed = [&](const ccaa::Corners& c) {
      return (c[0] - c[1]).norm() > 1.9 || (c[1] - c[2]).norm() > 1.9 ||
             (c[2] - c[0]).norm() > 1.9;
    };
    const Filling filling = fillingOf(task);
    ASSERT_TRUE(isDisc(filling, edges));
    for (const Triangle& t : filling.triangles)
      EXPECT_FALSE(task.obstructed(ccaa::cornersOf(t, task.polygon.points)));
  }
}

TEST(MinimumWeightFilling, ObstructionsAreAskedOnceForEachTriangleWhenNoneIsInTheWay)
{
  FillingTask task = holeIn({100, test::capHeight});
  std::size_t asked = 0;
  task.obstructed = [&](const ccaa::Corners&) {
    ++asked;
    return false;
  };
  fillingOf(task);
  EXPECT_EQ(98U, asked);
}

TEST(MinimumWeightFilling, CrossedDiagonalsChangeNothingAndSpareQuestions)
{
  for (const std::size_t edges : {40, 200}) {
    FillingTask task = holeIn({edges});
    const auto is_long = [](const Position& p, const Position& q) {
      return (p - q).norm() > 1.7;
    };
    std::size_t asked = 0;
    task.obstructed = [&](const ccaa::Corners& c) {
      ++asked;
      return is_long(c[0], c[1]) || is_long(c[1], c[2]) || is_long(c[2], c[0]);
    };
    const Triangles expected = fillingOf(task).triangles;
    const std::size_t asked_before = std::exchange(asked, 0U);
    task.crossed = is_long;
    EXPECT_EQ(expected, fillingOf(task).triangles);
    EXPECT_LT(2 * asked, asked_before);
  }
}

TEST(MinimumWeightFilling, AnEdgeWithoutAFreeTriangleIsFoundByFewQuestions)
{
  FillingTask task = holeIn({100});
  const auto& points = task.polygon.points;
  std::size_t asked = 0;
  task.obstructed = [&](const ccaa::Corners& c) {
    ++asked;
    return std::count(c.begin(), c.end(), points[70]) > 0 &&
           std::count(c.begin(), c.end(), points[71]) > 0;
  };
  EXPECT_FALSE(fillingOf(task).closed());
  EXPECT_LT(asked, 400U); // there are 161 700 triangles
}

TEST(TriangulationTable, AvoidsMoreTrianglesAsIfTheyHadBeenObstructedFromTheStart)
{
  const BoundaryCurve polygon = slitAlongTube(20).polygon;
  std::set<Triangle> avoided;
  FillingLimits limits;
  limits.obstructed = [&](std::size_t i, std::size_t m, std::size_t j) {
    return avoided.count({static_cast<pcl::index_t>(i),
                          static_cast<pcl::index_t>(m),
                          static_cast<pcl::index_t>(j)}) > 0;
  };
  const FillingWeights weights;
  TriangulationTable table(polygon, nullptr, weights, limits);
  for (int round = 0; round < 10; ++round) {
    Triangles more;
    for (const std::size_t t : {0U, 7U, 20U}) {
      more.push_back(table.triangles().at(t));
      std::sort(more.back().begin(), more.back().end());
    }
    avoided.insert(more.begin(), more.end());
    table.avoid(more);
    const TriangulationTable anew(polygon, nullptr, weights, limits);
    ASSERT_FALSE(anew.triangles().empty());
    EXPECT_EQ(anew.triangles(), table.triangles()) << round;
  }
}

TEST(MinimumWeightFilling, KnownFailureLeadsToTheSame)
{
  FillingTask task = slitAlongTube(24);
  const Triangle refused = [&] {
    Triangle triangle = fillingOf(task).triangles.at(5);
    std::sort(triangle.begin(), triangle.end());
    return triangle;
  }();
  task.obstructed = [&](const ccaa::Corners& corners) {
    return std::all_of(refused.begin(), refused.end(), [&](pcl::index_t v) {
      const Position& point = task.polygon.points[static_cast<std::size_t>(v)];
      return std::find(corners.begin(), corners.end(), point) != corners.end();
    });
  };
  const Filling searched = fillingOf(task);
  task.has_failed = true;
  EXPECT_EQ(searched.triangles, fillingOf(task).triangles);
}

TEST(MinimumWeightFilling, ObstructionsSeeTheTriangleWoundLikeTheSurface)
{
  FillingTask task = holeIn({9});
  bool upward = true;
  task.obstructed = [&](const ccaa::Corners& corners) {
    upward = upward && ccaa::areaNormal(corners).z() > 0.0;
    return false;
  };
  fillingOf(task);
  EXPECT_TRUE(upward);
}

TEST(MinimumWeightFilling, DoesNotDependOnScaleOrPlace)
{
  const FillingTask task = holeIn({90, test::saddleHeight, 0.1});
  FillingTask moved = task;
  for (Position& p : moved.polygon.points)
    p = 1024.0 * p;
  EXPECT_EQ(fillingOf(task).triangles, fillingOf(moved).triangles);
}

/** Two loops of different size side by side, cut open between two of their points. */
TEST(MinimumWeightFilling, NoEdgeBetweenVerticesOfARingComesTwice)
{
  for (const std::size_t inner : {3, 5, 9})
    for (const double aside : {0.0, 0.7, 3.0}) {
      FillingTask task;
      const auto add = [&](std::size_t count, double radius, double x, double turns) {
        const auto first = static_cast<pcl::index_t>(task.vertices.size());
        for (std::size_t k = 0; k <= count; ++k) {
          const double angle =
              turns * 2.0 * M_PI * static_cast<double>(k) / static_cast<double>(count);
          task.polygon.points.emplace_back(
              x + radius * std::cos(angle), radius * std::sin(angle), 0.1 * x);
          task.vertices.push_back(first +
                                  static_cast<pcl::index_t>(k == count ? 0 : k));
        }
        task.polygon.points.back() =
            task.polygon.points[task.polygon.size() - 1 - count];
      };
      add(12, 1.0, 0.0, -1.0);
      add(inner, 0.2, aside, 1.0);
      task.polygon.normals.assign(task.polygon.size(), Direction::UnitZ());
      task.joined = [&task](std::size_t a, std::size_t b) {
        return task.vertices[a] == task.vertices[b];
      };
      const Filling filling = fillingOf(task);
      ASSERT_TRUE(filling.closed());
      std::map<std::pair<pcl::index_t, pcl::index_t>, int> triangles_at;
      for (const Triangle& triangle : filling.triangles)
        for (std::size_t c = 0; c < 3; ++c)
          ++triangles_at[std::minmax(
              task.vertices[static_cast<std::size_t>(triangle[c])],
              task.vertices[static_cast<std::size_t>(triangle[(c + 1) % 3])])];
      for (const auto& [edge, count] : triangles_at)
        EXPECT_LE(count, 2) << edge.first << "-" << edge.second;
    }
}

} // namespace
} // namespace pcl::repair
