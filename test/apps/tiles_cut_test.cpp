// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where clouds are cut into tiles, and what that does.
#include "support/random_source.h"
#include "tiles_fixture.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace app_test {
namespace {

/** A sheet of squares with stripes between them where hardly any points lie. */
pcl::ccaa::Positions
sheetWithSparseStripes(std::size_t count, std::uint64_t seed)
{
  pcl::ccaa::test::RandomSource random(seed);
  const auto toStripe = [](double x) { return std::abs(std::fmod(x, 0.8) - 0.4); };
  pcl::ccaa::Positions points;
  while (points.size() < count) {
    const double x = random.uniform(0.0, 4.0), y = random.uniform(0.0, 4.0);
    const double height =
        0.1 * std::sin(2.0 * x) * std::cos(3.0 * y) + random.uniform(0.0, 0.005);
    if (std::min(toStripe(x), toStripe(y)) > 0.12 || random.uniform() < 0.02)
      points.emplace_back(x, y, height);
  }
  return points;
}

TEST_F(TiledApp, LongTrianglesBesideCutsLeaveTheMeshSound)
{
  for (const std::uint64_t seed : {1U, 2U}) {
    SCOPED_TRACE(seed);
    const auto points = sheetWithSparseStripes(20000, seed);
    ASSERT_TRUE(hasMeshed(tiledOf(test::toRawCloud(points), {"--tiles=5000"})));
    expectSound(loadMesh(folder_.path("out.ply")).mesh);
  }
}

/** A strip of points one unit apart, and beside it some that are ten units apart. */
pcl::ccaa::Positions
stripWithSparseSide()
{
  pcl::ccaa::test::RandomSource random(1);
  pcl::ccaa::Positions points;
  const auto add = [&](double step, double from, int columns, int rows) {
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < rows; ++j)
        points.emplace_back(step * (i + random.uniform(0.2, 0.8)),
                            from + step * (j + random.uniform(0.2, 0.8)),
                            random.uniform(0.0, 0.2));
  };
  add(1.0, 0.0, 1000, 16);
  add(10.0, 16.0, 100, 6);
  return points;
}

TEST_F(TiledApp, ACutThroughSparsePointsTearsNothing)
{
  save(folder_.path("in.ply"), test::toRawCloud(stripWithSparseSide()));
  ASSERT_TRUE(hasMeshed(tiled({"in.ply"}, "cut.ply", {"--tiles=16000"})));
  ASSERT_TRUE(hasMeshed(tiled({"in.ply"}, "whole.ply", {"--tiles=20000"})));
  const auto cut = expectSound(loadMesh(folder_.path("cut.ply")).mesh);
  const auto whole = expectSound(loadMesh(folder_.path("whole.ply")).mesh);
  EXPECT_LT(double(cut.boundary_edges), 1.05 * double(whole.boundary_edges));
}

TEST_F(TiledApp, TilesHoldAboutTheSameNumberOfPoints)
{
  constexpr double COUNT = 100000.0;
  save(folder_.path("in.ply"),
       test::toRawCloud(sheetWithSparseStripes(std::size_t(COUNT), 7)));
  ASSERT_TRUE(
      hasMeshed(step("cut", "tiles", {folder_.path("in.ply"), "--tiles=8000"})));
  std::istringstream lines(step("neighbors", "tiles", {}).output);
  std::size_t tiles = 0;
  for (std::string line; std::getline(lines, line); ++tiles)
    EXPECT_NEAR(std::stod(line), COUNT / 50.0, 0.1 * COUNT / 50.0) << tiles;
  EXPECT_EQ(50U, tiles);
}

} // namespace
} // namespace app_test
