// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of small islands that wait and are laid into patches.

#include <gtest/gtest.h>

#include "support/random_source.h"
#include "support/repair_fixture.h"
#include "surface_repair/boundary/boundary_models.h"

#include <cmath>
#include <functional>

namespace pcl::repair::test {
namespace {

/** A sphere without a cap but for single triangles, and what is around them, within it.
 * \param[in] spared of its triangles */
Shape
capWithCrumbs(double height, const std::function<bool(std::size_t)>& spared)
{
  const Shape sphere = icosphere(4);
  std::vector<std::size_t> removed;
  for (std::size_t t = 0; t < sphere.triangles.size(); ++t) {
    const Triangle& corners = sphere.triangles[t];
    double z = 0.0;
    for (const pcl::index_t corner : corners)
      z += sphere.vertices[static_cast<std::size_t>(corner)].z() / 3.0;
    if (z > height && !spared(t))
      removed.push_back(t);
  }
  return withoutFreeVertices(withoutTriangles(sphere, removed));
}

/** One in a hundred triangles of the cap is left. */
Shape
capWithManyCrumbs(std::uint64_t seed)
{
  RandomSource random(seed);
  std::vector<bool> spared(5120);
  for (std::size_t t = 0; t < spared.size(); ++t)
    spared[t] = random.uniform() < 0.01;
  return capWithCrumbs(0.6, [&](std::size_t t) { return spared[t]; });
}

TEST(Crumbs, CrumbsInAHoleBecomePartOfItsPatch)
{
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    const Repaired result = repaired(capWithManyCrumbs(seed));
    EXPECT_GT(result.report.islands.size(), 2U);
    expectWhole(result, 1, 2);
  }
}

TEST(Crumbs, AreLaidInTheSameWayForAnyNumberOfThreads)
{
  const pcl::PolygonMesh input = toPolygonMesh(capWithManyCrumbs(1));
  const Repaired alone = repaired(input);
  for (const unsigned int threads : {2U, 5U}) {
    const Repaired together = repaired(input, {}, {}, threads);
    EXPECT_EQ(alone.output.cloud.data, together.output.cloud.data);
    ASSERT_EQ(alone.output.polygons.size(), together.output.polygons.size());
    for (std::size_t t = 0; t < alone.output.polygons.size(); ++t)
      EXPECT_EQ(alone.output.polygons[t].vertices,
                together.output.polygons[t].vertices);
  }
}

/** It hangs on a point of the rim. */
TEST(Crumbs, ACrumbMuchSmallerThanTheTrianglesOverItIsLaid)
{
  for (const double size : {0.03, 0.003, 0.0003}) {
    SCOPED_TRACE(size);
    Shape shape = withoutFreeVertices(
        without(icosphere(2), [](const Position& p) { return p.z() > 0.6; }));
    const auto highest = std::max_element(
        shape.vertices.begin(),
        shape.vertices.end(),
        [](const Position& a, const Position& b) { return a.z() < b.z(); });
    const auto rim = static_cast<pcl::index_t>(highest - shape.vertices.begin());
    const Position root = *highest;
    const Direction in = Direction(-root.x(), -root.y(), 0.0).normalized();
    const Direction along = Direction::UnitZ().cross(in);
    const auto first = static_cast<pcl::index_t>(shape.vertices.size());
    for (const double side : {-0.4, 0.4})
      shape.vertices.push_back(root +
                               size * (in + side * along + 0.3 * Direction::UnitZ()));
    shape.triangles.push_back({rim, first, first + 1});
    const Repaired result = repaired(shape);
    EXPECT_EQ(2U, result.report.islands.size());
    expectWhole(result, 1, 2);
  }
}

/** Further from the patch than its extent tells, but not for the edges around. */
TEST(Crumbs, ATinyCrumbInTheMiddleOfAHoleIsLaid)
{
  Shape shape = withoutFreeVertices(
      without(icosphere(3), [](const Position& p) { return p.z() > 0.6; }));
  const auto first = static_cast<pcl::index_t>(shape.vertices.size());
  const double size = 1e-4;
  for (const double turn : {0.0, 2.0, 4.0})
    shape.vertices.emplace_back(size * std::cos(turn), size * std::sin(turn), 1.1);
  shape.triangles.push_back({first, first + 1, first + 2});
  const Repaired result = repaired(shape);
  EXPECT_EQ(2U, result.report.islands.size());
  expectWhole(result, 1, 2);
}

/** A bowl with a small hole and a crumb in that; far below a disc larger than the hole.
 */
TEST(Crumbs, ADiscFarFromASmallHoleIsNotLaidIntoItsPatch)
{
  const Shape bowl = without(icosphere(4), [](const Position& p) {
    return p.z() > -0.6 || (p.z() < -0.985 && p.z() > -0.997);
  });
  Shape disc = without(icosphere(4), [](const Position& p) { return p.z() > -0.96; });
  for (Position& p : disc.vertices)
    p.z() -= 0.8;
  const Repaired result = repaired(joined(bowl, disc));
  EXPECT_EQ(3U, result.report.islands.size());
  expectNothingLost(result);
  EXPECT_EQ(2U, topologyOf(result.triangles()).components);
}

TEST(Crumbs, FinsStayWithoutAShortfall)
{
  Shape shape = without(icosphere(3), [](const Position& p) { return p.z() > 0.8; });
  const auto lowest = static_cast<std::size_t>(
      std::min_element(
          shape.vertices.begin(),
          shape.vertices.end(),
          [](const Position& a, const Position& b) { return a.z() < b.z(); }) -
      shape.vertices.begin());
  const auto at = std::find_if(
      shape.triangles.begin(), shape.triangles.end(), [&](const Triangle& t) {
        return std::count(t.begin(), t.end(), static_cast<pcl::index_t>(lowest)) > 0;
      });
  const Triangle under = *at;
  const auto corner = static_cast<pcl::index_t>(shape.vertices.size());
  shape.vertices.push_back(1.2 * shape.vertices[lowest]);
  shape.triangles.push_back({under[0], under[1], corner});
  for (const CloseChoice close : {CloseChoice::HOLES, CloseChoice::ALL}) {
    RepairParameters parameters;
    parameters.filling.close = close;
    const Repaired result = repaired(withoutFreeVertices(shape), parameters);
    expectNothingLost(result);
    EXPECT_EQ(2U, topologyOf(result.triangles()).components);
    EXPECT_EQ(1U, topologyOf(result.triangles()).borders);
    EXPECT_TRUE(result.report.complete());
    EXPECT_EQ(OpenReason::FIN, result.report.holes.back().open);
  }
}

TEST(Crumbs, WithoutWaitingCrumbsAreIslandsFromTheStart)
{
  const auto spared = [](std::size_t t) { return t % 97 == 0; };
  RepairParameters parameters;
  parameters.crumb_triangles = 0;
  const Repaired at_once = repaired(capWithCrumbs(0.6, spared), parameters);
  const Repaired waiting = repaired(capWithCrumbs(0.6, spared));
  EXPECT_GT(at_once.report.junctions.size(), waiting.report.junctions.size());
  expectNothingLost(at_once);
}

} // namespace
} // namespace pcl::repair::test
