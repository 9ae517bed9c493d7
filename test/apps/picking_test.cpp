// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: picking by a place of a picture, without a window.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "viewer/picking.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace app_test {
namespace {

using app::PickLine;
using app::pickNear;

bool
nothingHides(const Eigen::Vector3d& /*place*/)
{
  return false;
}

/** From x, y, z to pixels: 100 a unit, the farther the smaller. */
Eigen::Matrix4d
camera()
{
  Eigen::Matrix4d projection = Eigen::Matrix4d::Identity();
  projection.diagonal().head<2>().setConstant(100.0);
  projection.row(3) << 0.0, 0.0, 0.1, 1.0;
  return projection;
}

/** The same slowly: many places of each line one by one. Plain numbers, as these tests
 * are not optimized. */
std::optional<std::size_t>
pickSlowly(const std::vector<PickLine>& lines,
           const Eigen::Vector2d& place,
           double reach)
{
  constexpr int steps = 4000;
  std::optional<std::size_t> picked;
  double least = reach;
  for (const PickLine& line : lines)
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Eigen::Vector4d from = camera() * line.points[i].homogeneous();
      const std::size_t next = line.closed ? (i + 1) % line.points.size()
                                           : std::min(i + 1, line.points.size() - 1);
      const Eigen::Vector4d way = camera() * line.points[next].homogeneous() - from;
      for (int step = 0; step <= steps; ++step) {
        const double share = static_cast<double>(step) / steps;
        const double w = from[3] + share * way[3];
        const double distance = std::hypot((from[0] + share * way[0]) / w - place[0],
                                           (from[1] + share * way[1]) / w - place[1]);
        if (distance < least) {
          least = distance;
          picked = line.thing;
        }
      }
    }
  return picked;
}

TEST(PickNear, IsTheNearestOfAllPlacesOneByOne)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> places(-1.0, 1.0);
  std::size_t hits = 0;
  for (int round = 0; round < 30; ++round) {
    std::vector<PickLine> lines;
    for (std::size_t thing = 0; thing < 4; ++thing) {
      lines.push_back({thing, {}, thing != 2});
      for (int i = 0; i < 4; ++i)
        lines.back().points.emplace_back(
            places(random), places(random), places(random));
    }
    const Eigen::Vector2d place(80.0 * places(random), 80.0 * places(random));
    const auto picked = pickNear(lines, camera(), place, 10.0, nothingHides);
    EXPECT_EQ(pickSlowly(lines, place, 10.0), picked) << round;
    hits += picked ? 1 : 0;
  }
  EXPECT_GT(hits, 5U);
  EXPECT_LT(hits, 30U);
}

TEST(PickNear, FindsNothingBeyondReachAndBehindTheCamera)
{
  const std::vector<PickLine> lines{{0, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, false},
                                    {1, {{0.0, 1.0, -20.0}}, false}};
  EXPECT_TRUE(pickNear(lines, camera(), {50.0, 9.0}, 10.0, nothingHides));
  EXPECT_FALSE(pickNear(lines, camera(), {50.0, 11.0}, 10.0, nothingHides));
  EXPECT_FALSE(pickNear(lines, camera(), {0.0, -100.0}, 10.0, nothingHides));
  EXPECT_FALSE(pickNear({}, camera(), {0.0, 0.0}, 10.0, nothingHides));
}

TEST(PickNear, PrefersWhatIsNotHiddenToWhatIsNearer)
{
  const std::vector<PickLine> lines{{0, {{0.0, 0.0, 5.0}}, false},
                                    {1, {{0.05, 0.0, 0.0}}, false}};
  const auto behind = [](const Eigen::Vector3d& place) { return place.z() > 1.0; };
  EXPECT_EQ(0U, pickNear(lines, camera(), {0.0, 0.0}, 10.0, nothingHides));
  EXPECT_EQ(1U, pickNear(lines, camera(), {0.0, 0.0}, 10.0, behind));
  EXPECT_EQ(0U, pickNear(lines, camera(), {0.0, 0.0}, 3.0, behind))
      << "what is hidden where nothing else is in reach";
}

} // namespace
} // namespace app_test
