// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pcl_damage_cloud as a user runs it.
#include <gtest/gtest.h>

#include "app_runner.h"
#include "io/point_columns.h"
#include "model_samples.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace app_test {
namespace {

class DamageApp : public testing::Test {
protected:
  DamageApp() : mesh_(colouredSphere()) { save(folder_.path("in.ply"), mesh_); }

  RunResult
  damage(const std::string& output, const std::vector<std::string>& options)
  {
    return runApp(
        "pcl_damage_cloud", {folder_.path("in.ply"), folder_.path(output)}, options);
  }

  /** Labels tell the points of the sphere apart: 1000003 times their number. */
  static std::vector<std::size_t>
  originals(const pcl::PCLPointCloud2& cloud)
  {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < app::pointCount(cloud); ++i)
      numbers.push_back(static_cast<std::size_t>(valueOf(cloud, i, "label") / 1000003));
    return numbers;
  }

  TemporaryFolder folder_;
  pcl::PolygonMesh mesh_;
};

TEST_F(DamageApp, TakesASphereOutOfAMesh)
{
  // The upper pole of the unit sphere: the middle of the top of its box.
  const RunResult result = damage(
      "out.ply", {"--sphere", "0.5,0.5,1,0.2", "--removed", folder_.path("rest.ply")});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  const auto out = loadMesh(folder_.path("out.ply")).mesh;
  const auto rest = loadMesh(folder_.path("rest.ply")).mesh;
  const float radius = 0.2F * 2 * std::sqrt(3.0F);
  std::size_t inside = 0;
  for (const auto& point : app::readPositions(mesh_.cloud))
    inside += (point - Eigen::Vector3f(0, 0, 1)).norm() < radius * 0.99F ? 1 : 0;
  EXPECT_GT(inside, 5U);
  EXPECT_NEAR(static_cast<double>(162 - inside),
              static_cast<double>(app::pointCount(out.cloud)),
              3);
  for (const auto& point : app::readPositions(out.cloud))
    EXPECT_GE((point - Eigen::Vector3f(0, 0, 1)).norm(), radius * 0.98F);
  EXPECT_EQ(mesh_.polygons.size(), out.polygons.size() + rest.polygons.size());
}

TEST_F(DamageApp, KeepsOrderAndFieldsOfTheOthers)
{
  ASSERT_EQ(0, damage("out.ply", {"--spheres", "2", "--sphere-size", "0.1"}).exit_code);
  const auto out = loadMesh(folder_.path("out.ply")).mesh;
  const auto numbers = originals(out.cloud);
  ASSERT_LT(numbers.size(), 162U);
  EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (const char* field : {"x", "y", "z", "normal_x", "intensity", "label"})
      EXPECT_EQ(valueOf(mesh_.cloud, numbers[i], field), valueOf(out.cloud, i, field));
}

TEST_F(DamageApp, KeepsAShareAsFreePointsWithNoise)
{
  const RunResult result = damage("out.ply",
                                  {"--slab",
                                   "0,0,1,0.5,0.5",
                                   "--keep",
                                   "0.25",
                                   "--noise",
                                   "0.3",
                                   "--removed",
                                   folder_.path("rest.ply"),
                                   "--free-points",
                                   folder_.path("free.pcd")});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  const auto out = loadMesh(folder_.path("out.ply")).mesh;
  const auto free_points = loadCloud(folder_.path("free.pcd")).mesh.cloud;
  const std::size_t kept = app::pointCount(free_points);
  const std::size_t removed = 162 + kept - app::pointCount(out.cloud);
  EXPECT_NEAR(0.25 * static_cast<double>(removed), static_cast<double>(kept), 0.5);
  std::set<pcl::index_t> used;
  for (const auto& polygon : out.polygons)
    used.insert(polygon.vertices.begin(), polygon.vertices.end());
  EXPECT_EQ(162 - removed, used.size()); // free points have no triangle
  const auto numbers = originals(free_points);
  double largest = 0;
  for (std::size_t i = 0; i < kept; ++i)
    largest = std::max(
        largest,
        std::abs(valueOf(free_points, i, "x") - valueOf(mesh_.cloud, numbers[i], "x")));
  EXPECT_GT(largest, 0);
  EXPECT_LT(largest, 0.3 * 0.3 * 6); // spacing of this sphere is about 0.3
}

TEST_F(DamageApp, DamagesACloudAlike)
{
  save(folder_.path("cloud.pcd"), mesh_.cloud);
  const RunResult result = runApp("pcl_damage_cloud",
                                  {folder_.path("cloud.pcd"),
                                   folder_.path("out.xyz"),
                                   "--slab",
                                   "1,0,0,0,0.4",
                                   "--keep",
                                   "0.1"});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  const auto out = loadCloud(folder_.path("out.xyz")).mesh.cloud;
  std::size_t far_left = 0;
  for (const auto& point : app::readPositions(out))
    far_left += point.x() < -0.61F ? 1 : 0;
  EXPECT_GT(far_left, 0U); // the kept tenth
  EXPECT_LT(far_left, 10U);
}

TEST_F(DamageApp, TakesRegionsInUnitsOfTheCloud)
{
  ASSERT_EQ(0, damage("out.ply", {"--absolute", "--slab=0,0,2,0,1"}).exit_code);
  for (const auto& point :
       app::readPositions(loadMesh(folder_.path("out.ply")).mesh.cloud))
    EXPECT_GT(std::abs(point.z()), 0.5F);
}

TEST_F(DamageApp, AcceptsNegativeNumbersBehindABlank)
{
  EXPECT_EQ(0, damage("out.ply", {"--slab", "-1,0,0,0.5,0.1"}).exit_code);
  EXPECT_EQ(0, damage("out.ply", {"--absolute", "--sphere", "-1,0,0,0.5"}).exit_code);
}

TEST_F(DamageApp, GrowsConnectedPatchesOfTheGivenSize)
{
  const std::vector<std::string> options{
      "--patches", "3", "--patch-size", "0.1", "--removed", folder_.path("rest.pcd")};
  ASSERT_EQ(0, damage("out.ply", options).exit_code);
  const std::size_t left =
      app::pointCount(loadMesh(folder_.path("out.ply")).mesh.cloud);
  EXPECT_LE(162 - left, 48U); // 3 times a tenth of 162, where no patch is hemmed in
  EXPECT_GE(162 - left, 16U);
}

TEST_F(DamageApp, SameSeedSameDamage)
{
  const auto run = [&](const std::string& output, const std::string& seed) {
    const std::vector<std::string> options{"--spheres",
                                           "1",
                                           "--slabs",
                                           "1",
                                           "--patches",
                                           "1",
                                           "--keep",
                                           "0.5",
                                           "--noise",
                                           "0.5",
                                           "--seed",
                                           seed};
    EXPECT_EQ(0, damage(output, options).exit_code);
    return readFile(folder_.path(output));
  };
  const std::string first = run("1.ply", "5");
  EXPECT_TRUE(first == run("2.ply", "5"));
  EXPECT_FALSE(first == run("3.ply", "6"));
}

TEST_F(DamageApp, SaysWhenNothingWasTakenOut)
{
  const RunResult result = damage("out.ply", {"--absolute", "--sphere", "50,50,50,1"});
  EXPECT_EQ(2, result.exit_code);
  EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
  EXPECT_EQ(162U, app::pointCount(loadMesh(folder_.path("out.ply")).mesh.cloud));
}

TEST_F(DamageApp, RefusesBadRegions)
{
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{},
        {"--sphere", "1,2,3"},
        {"--sphere", "0.5,0.5,0.5,0"},
        {"--sphere", "0.5,0.5,0.5,5"},
        {"--sphere", "a,b,c,d"},
        {"--slab", "0,0,0,0.5,0.1"},
        {"--slab", "0,0,1,0.5"},
        {"--slab", "0,0,1,nan,0.1"},
        {"--spheres", "-1"},
        {"--patches", "1", "--patch-size", "2"},
        {"--patches", "1", "--keep", "-0.5"},
        {"--patches", "1", "--removed", folder_.path("out.ply")},
        {"--patches", "1", "--free-points", folder_.path("free.stl")}}) {
    SCOPED_TRACE(options.empty() ? "none" : options.back());
    const RunResult result = damage("out.ply", options);
    EXPECT_EQ(1, result.exit_code);
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
    EXPECT_EQ(1U, folder_.names().size());
  }
}

TEST_F(DamageApp, RefusesStlForACloud)
{
  save(folder_.path("cloud.pcd"), mesh_.cloud);
  const RunResult result =
      runApp("pcl_damage_cloud",
             {folder_.path("cloud.pcd"), folder_.path("out.stl"), "--patches", "1"});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_TRUE(isOneLine(result.errors));
}

} // namespace
} // namespace app_test
