// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of what sparse free points tell about lost parts.

#include <gtest/gtest.h>

#include "fairing/triangle_search.h"
#include "support/random_source.h"
#include "support/repair_fixture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

namespace pcl::repair::test {
namespace {

/** Mean length of an edge of the bodies here. */
constexpr double SPACING = 0.08;

Shape
body()
{
  return ellipsoid(4, 3.0);
}

bool
isLost(const Position& p)
{
  return p.z() > 1.0;
}

using IsLost = std::function<bool(const Position&)>;

/** A shape without all triangles at lost vertices. */
Shape
remainder(const Shape& whole, const IsLost& is_lost)
{
  std::vector<std::size_t> removed;
  for (std::size_t t = 0; t < whole.triangles.size(); ++t)
    if (std::any_of(
            whole.triangles[t].begin(), whole.triangles[t].end(), [&](auto corner) {
              return is_lost(whole.vertices[static_cast<std::size_t>(corner)]);
            }))
      removed.push_back(t);
  return withoutFreeVertices(withoutTriangles(whole, removed));
}

/** Every so many-th of the lost vertices; 0: none. */
Positions
samples(const Shape& whole, const IsLost& is_lost, std::size_t every)
{
  Positions lost, taken;
  std::copy_if(
      whole.vertices.begin(), whole.vertices.end(), std::back_inserter(lost), is_lost);
  for (std::size_t i = 0; every > 0 && i < lost.size(); i += every)
    taken.push_back(lost[i]);
  return taken;
}

Positions
samples(std::size_t every)
{
  return samples(body(), isLost, every);
}

Repaired
repairedWith(const Positions& free_points)
{
  return repaired(toPolygonMesh(remainder(body(), isLost)), free_points);
}

/** The distance from the surface that a share of points stays within. */
double
distanceOf(const Positions& points, const Repaired& result, double share = 0.95)
{
  const Positions places =
      ccaa::copyPositions(ccaa::positionView(result.output.cloud)).positions;
  std::vector<ccaa::Corners> triangles;
  for (const Triangle& triangle : result.triangles())
    triangles.push_back(ccaa::cornersOf(triangle, places));
  const TriangleSearch surface(triangles);
  std::vector<double> distances;
  for (const Position& point : points)
    distances.push_back(surface.nearest(point, 10.0).distance);
  std::sort(distances.begin(), distances.end());
  return distances[static_cast<std::size_t>(share *
                                            static_cast<double>(distances.size() - 1))];
}

double
highest(const Repaired& result)
{
  double height = -std::numeric_limits<double>::infinity();
  const Positions places =
      ccaa::copyPositions(ccaa::positionView(result.output.cloud)).positions;
  for (const Triangle& triangle : result.triangles())
    for (const pcl::index_t corner : triangle)
      height = std::max(height, places[static_cast<std::size_t>(corner)].z());
  return height;
}

void
expectWholeBody(const Repaired& result)
{
  EXPECT_TRUE(isSubsetOf(toTriangles(result.input.polygons), result.triangles()));
  EXPECT_TRUE(keepsPoints(result));
  EXPECT_TRUE(addsNoIntersection(result));
  const Topology after = topologyOf(result.triangles());
  EXPECT_EQ(1U, after.components);
  EXPECT_EQ(2, after.characteristic);
  EXPECT_EQ(0U, after.borders);
}

TEST(FreePoints, BringBackALostLimb)
{
  for (const std::size_t every : {10U, 20U, 40U}) {
    SCOPED_TRACE(every);
    const Repaired result = repairedWith(samples(every));
    expectWholeBody(result);
    EXPECT_LE(distanceOf(samples(every), result), 0.15 * SPACING);
    EXPECT_LE(distanceOf(samples(1), result), 1.5 * SPACING);
  }
}

/** A limb of which a part many times longer than it is thick is lost. \param[in] every
 * see samples() */
Repaired
repairedGap(double gap, std::size_t every)
{
  const Shape whole = ellipsoid(4, 12.0);
  const IsLost is_lost = [gap](const Position& p) {
    return std::abs(p.z() - 1.0) < 0.5 * gap;
  };
  return repaired(toPolygonMesh(remainder(whole, is_lost)),
                  samples(whole, is_lost, every));
}

TEST(FreePoints, BetweenTwoStumpsMakeThemOneLimb)
{
  constexpr double GAP = 7.0;
  expectWholeBody(repairedGap(GAP, 0)); // by their junction alone
  for (const std::size_t every : {5U, 15U}) {
    SCOPED_TRACE(every);
    const Repaired result = repairedGap(GAP, every);
    expectWholeBody(result);
    EXPECT_TRUE(result.report.complete());
    EXPECT_EQ(2U, result.report.islands.size());
  }
}

/** But for a strip that winds around a limb all of it is lost: chords across what is
 * missing run through each other, and nothing grows on them. */
TEST(FreePoints, BringBackALimbBesideAWindingStrip)
{
  const Shape whole = ellipsoid(4, 6.0);
  const IsLost is_lost = [](const Position& p) {
    return std::abs(p.z()) < 4.0 &&
           std::cos(std::atan2(p.y(), p.x()) - 3.0 * p.z()) > -0.8;
  };
  const Positions few = samples(whole, is_lost, 20);
  const Repaired result = repaired(toPolygonMesh(remainder(whole, is_lost)), few);
  expectWholeBody(result);
  EXPECT_LE(distanceOf(few, result), 0.15 * SPACING);
}

TEST(FreePoints, AreMetWithinTheirNoise)
{
  const double deviation = 0.3 * SPACING;
  RandomSource random(5);
  Positions noisy = samples(20);
  for (Position& point : noisy)
    point += deviation * Position(random.normal(), random.normal(), random.normal());
  const Repaired result = repairedWith(noisy);
  expectWholeBody(result);
  EXPECT_LE(distanceOf(noisy, result), 1.5 * deviation);
}

TEST(FreePoints, FarOutliersRaiseNoBump)
{
  Positions points = samples(20);
  points.emplace_back(0.5, 0.5, 9.0);
  points.emplace_back(6.0, 0.0, 2.0);
  const Repaired result = repairedWith(points);
  expectWholeBody(result);
  EXPECT_LT(highest(result), 3.0 + SPACING);
}

/** As scanners leave them where depth jumps: in small clusters, none near the next. */
Positions
strays(std::uint64_t seed)
{
  RandomSource random(seed);
  Positions points;
  for (int cluster = 0; cluster < 12; ++cluster) {
    const double height = 1.3 + 0.35 * cluster;
    const Position center(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), height);
    const double size = random.uniform(0.2, 1.5) * SPACING;
    for (int i = 0; i < 5; ++i)
      points.push_back(
          center + size * Position(random.normal(), random.normal(), random.normal()));
  }
  return points;
}

/** What is tried with them costs more than it may, and then they count for nothing. */
TEST(FreePoints, StraysAllAroundLeaveNothingOpen)
{
  RandomSource random(1);
  Positions points;
  for (int i = 0; i < 400; ++i)
    points.emplace_back(random.uniform(-2.0, 2.0),
                        random.uniform(-2.0, 2.0),
                        random.uniform(-4.0, 4.0));
  expectWholeBody(repairedWith(points));
}

TEST(FreePoints, StrayClustersRaiseNothing)
{
  const double plain = highest(repairedWith({}));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const Repaired result = repairedWith(strays(seed));
    expectWholeBody(result);
    EXPECT_LT(highest(result), plain + 0.5);
  }
}

TEST(FreePoints, OverTheGivenSurfaceTellNothingNew)
{
  Positions points;
  for (const Position& vertex : body().vertices)
    if (vertex.z() < 0.5 && points.size() < 60)
      points.push_back(1.01 * vertex);
  const Repaired with = repairedWith(points);
  const Repaired plain = repairedWith({});
  expectWholeBody(with);
  EXPECT_NEAR(highest(plain), highest(with), 0.05 * SPACING);
}

} // namespace
} // namespace pcl::repair::test
