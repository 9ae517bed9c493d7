// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: labels, normals, hints and measuring on request.
#include <gtest/gtest.h>

#include "io/point_columns.h"
#include "model_samples.h"
#include "reconstruct_fixture.h"
#include "support/clouds.h"
#include "support/shared_data.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace app_test {
namespace {

/** Values of the last property of every face of a binary PLY of triangles. */
std::vector<std::int32_t>
lastFaceProperty(const std::string& ply, std::size_t faces)
{
  constexpr std::size_t face_bytes = 1 + 4 * sizeof(std::int32_t);
  std::vector<std::int32_t> values(faces);
  for (std::size_t i = 0; i < faces; ++i)
    std::memcpy(&values[i],
                ply.data() + ply.size() - (faces - i) * face_bytes + face_bytes -
                    sizeof(std::int32_t),
                sizeof(std::int32_t));
  return values;
}

TEST_F(ReconstructApp, LabelsSayWhichStageMadeATriangle)
{
  save(folder_.path("in.ply"), colouredCloud(3000));
  const std::vector<std::string> options{
      "--labels", "--report", folder_.path("report.json")};
  ASSERT_TRUE(hasMeshed(reconstruct("in.ply", "out.ply", options)));
  const std::string ply = readFile(folder_.path("out.ply"));
  EXPECT_NE(std::string::npos, ply.find("property int stage\nend_header"));
  const auto labels = lastFaceProperty(ply, report().at("triangles"));
  const auto made = report().at("triangles_by_stage");
  EXPECT_TRUE(std::is_sorted(labels.begin(), labels.end()));
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 0), made.at("start"));
  EXPECT_EQ(std::count(labels.begin(), labels.end(), 1), made.at("base"));
  EXPECT_GT(loadMesh(folder_.path("out.ply")).mesh.polygons.size(), 4000U);
}

TEST_F(ReconstructApp, WithoutLabelsFacesHaveNoProperty)
{
  save(folder_.path("in.ply"), colouredCloud(1000));
  ASSERT_TRUE(hasMeshed(reconstruct("in.ply", "out.ply")));
  EXPECT_EQ(std::string::npos, readFile(folder_.path("out.ply")).find("stage"));
}

/** A sphere as text, with normals that point inward. */
std::string
sphereText(bool with_normals)
{
  std::string text;
  for (const auto& p : test::fibonacciSphere(1000)) {
    const Eigen::Vector3d n = -p;
    text += std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
            std::to_string(p.z());
    if (with_normals)
      text += " " + std::to_string(n.x()) + " " + std::to_string(n.y()) + " " +
              std::to_string(n.z());
    text += "\n";
  }
  return text;
}

TEST_F(ReconstructApp, WritesNormalsOnRequest)
{
  writeFile(folder_.path("in.xyz"), sphereText(false));
  const RunResult result = reconstruct("in.xyz", "out.ply", {"--normals"});
  ASSERT_TRUE(hasMeshed(result));
  EXPECT_EQ("", result.errors);
  const auto cloud = loadMesh(folder_.path("out.ply")).mesh.cloud;
  std::size_t offset = 0;
  ASSERT_TRUE(app::findNormal(cloud, offset));
  const auto positions = app::readPositions(cloud);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    Eigen::Vector3f normal;
    std::memcpy(normal.data(), app::pointAt(cloud, i) + offset, sizeof(normal));
    EXPECT_GT(normal.dot(positions[i]), 0.99f) << i;
  }
}

TEST_F(ReconstructApp, KeepsTheNormalsOfTheCloudAndWindsByThem)
{
  writeFile(folder_.path("in.xyz"), sphereText(true));
  ASSERT_TRUE(hasMeshed(reconstruct("in.xyz", "plain.ply")));
  const RunResult result = reconstruct("in.xyz", "out.ply", {"--normals"});
  ASSERT_TRUE(hasMeshed(result));
  EXPECT_NE(std::string::npos, result.errors.find("has normals")) << result.errors;
  EXPECT_TRUE(readFile(folder_.path("plain.ply")) == readFile(folder_.path("out.ply")));
  test::Shape shape;
  ASSERT_TRUE(test::readShape(folder_.path("out.ply"), shape));
  EXPECT_LT(test::signedVolume(shape), -4);
}

TEST_F(ReconstructApp, AViewpointTellsTheOuterSide)
{
  std::string pcd = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"
                    "COUNT 1 1 1\nWIDTH 400\nHEIGHT 1\nVIEWPOINT 9 9 ";
  const std::string rest = " 1 0 0 0\nPOINTS 400\nDATA ascii\n";
  std::string points;
  for (int i = 0; i < 400; ++i)
    points += std::to_string(i / 20) + " " + std::to_string(i % 20) + " 0\n";
  for (const int height : {30, -30}) {
    writeFile(folder_.path("in.pcd"), pcd + std::to_string(height) + rest + points);
    ASSERT_TRUE(hasMeshed(reconstruct("in.pcd", "out.ply")));
    test::Shape shape;
    ASSERT_TRUE(test::readShape(folder_.path("out.ply"), shape));
    ASSERT_GT(shape.triangles.size(), 700U);
    for (const auto& t : shape.triangles) {
      const auto corner = [&](std::size_t i) {
        return shape.vertices[static_cast<std::size_t>(t[i])];
      };
      EXPECT_GT((corner(1) - corner(0)).cross(corner(2) - corner(0)).z() * height, 0);
    }
  }
}

TEST_F(ReconstructApp, PrintsWhetherTheChainPays)
{
  save(folder_.path("in.ply"), colouredCloud(2000));
  const std::vector<std::string> options{
      "--measure-speedup", "--report", folder_.path("report.json")};
  const RunResult result = reconstruct("in.ply", "out.ply", options);
  ASSERT_TRUE(hasMeshed(result));
  EXPECT_EQ(4, std::count(result.output.begin(), result.output.end(), '\n'));
  EXPECT_NE(std::string::npos, result.output.find("k c_A > c_B + c_F"));
  const auto speedup = report().at("speedup");
  EXPECT_GT(speedup.at("t_A"), 0.0);
  EXPECT_DOUBLE_EQ(speedup.at("t_A").get<double>() / speedup.at("t_BA").get<double>(),
                   speedup.at("S").get<double>());
  EXPECT_TRUE(speedup.at("condition_holds").is_boolean());
}

TEST_F(ReconstructApp, RefusesLabelsInFormatsWithoutAPlaceForThem)
{
  save(folder_.path("in.ply"), colouredCloud(500));
  for (const char* name : {"out.obj", "out.stl", "out.vtk"}) {
    const RunResult result = reconstruct("in.ply", name, {"--labels"});
    EXPECT_EQ(1, result.exit_code);
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
    EXPECT_NE(std::string::npos, result.errors.find(".ply"));
    EXPECT_EQ(1U, folder_.names().size());
  }
}

TEST_F(ReconstructApp, CountsTheBoundaryLoopsThatAreLeft)
{
  std::string text;
  for (const auto& p : test::noisySphere(3000, 0.03))
    text += std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
            std::to_string(p.z()) + "\n";
  writeFile(folder_.path("in.xyz"), text);
  const std::vector<std::string> options{
      "--until", "filter", "--report", folder_.path("report.json")};
  ASSERT_TRUE(hasMeshed(reconstruct("in.xyz", "out.ply", options)));
  const RunResult quality = runApp(
      "pcl_mesh_quality",
      {folder_.path("out.ply"), "--report", folder_.path("quality.json"), "--quiet"});
  ASSERT_EQ(0, quality.exit_code);
  const auto facts = nlohmann::json::parse(readFile(folder_.path("quality.json")));
  EXPECT_GT(report().at("boundary_loops"), 1);
  EXPECT_EQ(facts.at("boundary_loops").size(), report().at("boundary_loops"));
}

/** A frame of 120 by 90 rays to a tilted wall, whose depths have steps; the sensor is
 * the origin. */
std::string
steppedFrame(double step)
{
  std::string text = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 120\nHEIGHT 90\n"
                     "VIEWPOINT 0 0 0 1 0 0 0\nDATA ascii\n";
  for (int row = 0; row < 90; ++row)
    for (int column = 0; column < 120; ++column) {
      const double x = 0.009 * (column - 60), y = 0.009 * (row - 45);
      const double depth = step * std::round(2.0 / (1.0 - 0.8 * y - 0.2 * x) / step);
      text += std::to_string(x * depth) + " " + std::to_string(y * depth) + " " +
              (row == 40 && column < 50 ? "nan" : std::to_string(depth)) + "\n";
    }
  return text;
}

TEST_F(ReconstructApp, BeginsWithTheGridWhereDepthHasCoarseSteps)
{
  writeFile(folder_.path("in.pcd"), steppedFrame(0.06));
  const std::vector<std::string> options{"--report", folder_.path("report.json")};
  ASSERT_TRUE(hasMeshed(reconstruct("in.pcd", "out.ply", options)));
  EXPECT_EQ("grid", report().at("start"));
  EXPECT_EQ(1, report().at("pieces"));
  EXPECT_EQ(120 * 90 - 50, report().at("usable_points"));
}

TEST_F(ReconstructApp, BeginsGreedilyWhereTheGridIsNoBetter)
{
  writeFile(folder_.path("in.pcd"), steppedFrame(1e-5));
  const std::vector<std::string> options{"--report", folder_.path("report.json")};
  ASSERT_TRUE(hasMeshed(reconstruct("in.pcd", "out.ply", options)));
  EXPECT_EQ("greedy", report().at("start"));
}

TEST_F(ReconstructApp, RefusesTheGridOfACloudThatHasNone)
{
  save(folder_.path("in.pcd"), colouredCloud(500));
  const RunResult result = reconstruct("in.pcd", "out.ply", {"--start", "grid"});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_NE(std::string::npos, result.errors.find("--start grid needs an organised"));
}

} // namespace
} // namespace app_test
