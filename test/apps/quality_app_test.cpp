// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pcl_mesh_quality as a user runs it.
#include <gtest/gtest.h>

#include "app_runner.h"
#include "model_samples.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"
#include <nlohmann/json.hpp>

namespace app_test {
namespace {

namespace test = pcl::ccaa::test;

class QualityApp : public testing::Test {
protected:
  nlohmann::json
  measure(const pcl::PolygonMesh& mesh, const std::vector<std::string>& options = {})
  {
    save(folder_.path("mesh.ply"), mesh);
    const RunResult result =
        runApp("pcl_mesh_quality",
               {folder_.path("mesh.ply"), "--report", folder_.path("report.json")},
               options);
    EXPECT_EQ(0, result.exit_code) << result.errors;
    EXPECT_EQ("", result.errors);
    return nlohmann::json::parse(readFile(folder_.path("report.json")));
  }

  TemporaryFolder folder_;
};

TEST_F(QualityApp, ReportsAClosedSphere)
{
  const nlohmann::json facts = measure(colouredSphere());
  EXPECT_EQ(162, facts.at("vertices"));
  EXPECT_EQ(162, facts.at("used_vertices"));
  EXPECT_EQ(320, facts.at("triangles"));
  EXPECT_EQ(1, facts.at("components"));
  EXPECT_EQ(0, facts.at("boundary_loops").size());
  EXPECT_EQ(2, facts.at("euler_characteristic"));
  EXPECT_EQ(0, facts.at("genus"));
  EXPECT_EQ(true, facts.at("watertight"));
  EXPECT_EQ(0, facts.at("self_intersections"));
  EXPECT_TRUE(facts.at("consistently_wound"));
  EXPECT_GT(facts.at("volume"), 0.0);
}

TEST_F(QualityApp, ReportsLoopsOfATubeWithTheirLengths)
{
  const auto facts = measure(test::toPolygonMesh(test::cylinder(60, 5)));
  const auto& loops = facts.at("boundary_loops");
  ASSERT_EQ(2U, loops.size());
  EXPECT_EQ(60, loops[0].at("edges"));
  EXPECT_NEAR(2 * M_PI, loops[0].at("length"), 0.01);
  EXPECT_EQ(0, facts.at("genus"));
  EXPECT_EQ(false, facts.at("watertight"));
}

TEST_F(QualityApp, ReportsWhatIsBroken)
{
  EXPECT_EQ(1,
            measure(test::toPolygonMesh(test::threeOnEdge())).at("non_manifold_edges"));
  EXPECT_EQ(1,
            measure(test::toPolygonMesh(test::bowTie())).at("non_manifold_vertices"));
  EXPECT_FALSE(measure(test::toPolygonMesh(test::moebiusBand(9))).at("orientable"));
}

TEST_F(QualityApp, LeavesSelfIntersectionsOutOnRequest)
{
  const auto facts = measure(colouredSphere(), {"--no-self-intersections"});
  EXPECT_TRUE(facts.at("self_intersections").is_null());
}

TEST_F(QualityApp, PrintsATableForPeople)
{
  save(folder_.path("mesh.off.ply"), colouredSphere());
  const RunResult result = runApp("pcl_mesh_quality", {folder_.path("mesh.off.ply")});
  EXPECT_EQ(0, result.exit_code);
  EXPECT_NE(std::string::npos,
            result.output.find("mesh.off.ply: closed manifold, 320"));
  EXPECT_NE(std::string::npos,
            result.output.find("watertight: yes, genus 0, Euler characteristic 2"));
  for (const char* word : {"points", "boundary loops", "genus", "smallest angle"})
    EXPECT_NE(std::string::npos, result.output.find(word)) << word;
}

TEST_F(QualityApp, AcceptsAMeshWithoutTriangles)
{
  pcl::PolygonMesh mesh = colouredSphere();
  mesh.polygons.clear();
  const auto facts = measure(mesh);
  EXPECT_EQ(0, facts.at("triangles"));
  EXPECT_EQ(162, facts.at("free_vertices"));
}

TEST_F(QualityApp, RefusesAnIndexOutOfRange)
{
  writeFile(folder_.path("bad.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  const RunResult result = runApp("pcl_mesh_quality", {folder_.path("bad.obj")});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
}

} // namespace
} // namespace app_test
