// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: several clouds as one, and clouds that are only looked at.
#include "io/merge.h"
#include "io/model_io.h"
#include "io/point_columns.h"
#include "repair_fixture.h"

namespace app_test {
namespace {

/** A cloud of one point, as a PCD with these fields behind x, y and z. */
app::NamedModel
part(float x, const std::string& fields = "", const std::string& viewpoint = "")
{
  std::string sizes;
  std::string types;
  std::string values;
  for (const char c : fields)
    if (c == ' ') {
      sizes += " 4";
      types += " F";
      values += " 7";
    }
  const std::string bytes =
      "FIELDS x y z" + fields + "\nSIZE 4 4 4" + sizes + "\nTYPE F F F" + types +
      "\nWIDTH 1\nHEIGHT 1\n" +
      (viewpoint.empty() ? "" : "VIEWPOINT " + viewpoint + " 1 0 0 0\n") +
      "DATA ascii\n" + std::to_string(x) + " 0 0" + values + "\n";
  app::NamedModel named{"part", {}};
  const auto status =
      app::parseCloud(app::FileFormat::PCD, bytes.data(), bytes.size(), named.model);
  EXPECT_TRUE(status.ok()) << status.message();
  return named;
}

app::Model
merged(std::vector<app::NamedModel> parts)
{
  app::Model whole;
  app::mergeModels(parts, whole);
  return whole;
}

TEST(Merge, PutsPointsOneBehindTheOther)
{
  const app::Model whole = merged({part(1), part(2), part(3)});
  ASSERT_EQ(3U, app::pointCount(whole.mesh.cloud));
  EXPECT_EQ(3, valueOf(whole.mesh.cloud, 2, "x"));
  EXPECT_TRUE(whole.warnings.empty());
}

TEST(Merge, KeepsFieldsThatAgreeAndTellsOfOthers)
{
  const app::Model whole =
      merged({part(1, " intensity height"), part(2, " intensity")});
  EXPECT_EQ(7, valueOf(whole.mesh.cloud, 1, "intensity"));
  EXPECT_FALSE(app::findField(whole.mesh.cloud, "height"));
  ASSERT_EQ(1U, whole.warnings.size());
  EXPECT_NE(std::string::npos, whole.warnings[0].find("height"));
}

TEST(Merge, GivesEachPointTheViewpointOfItsFile)
{
  const app::Model whole = merged({part(1, "", "0 0 5"), part(2, "", "0 0 -5")});
  EXPECT_EQ(5, valueOf(whole.mesh.cloud, 0, "vp_z"));
  EXPECT_EQ(-5, valueOf(whole.mesh.cloud, 1, "vp_z"));
  EXPECT_FALSE(whole.viewpoint.known);
}

TEST(Merge, KeepsTheViewpointThatAllShare)
{
  const app::Model whole = merged({part(1, "", "0 0 5"), part(2, "", "0 0 5")});
  EXPECT_TRUE(whole.viewpoint.known);
  EXPECT_FALSE(app::findField(whole.mesh.cloud, "vp_z"));
}

TEST(Merge, TellsWhenAViewpointIsMissing)
{
  const app::Model whole = merged({part(1, "", "0 0 5"), part(2)});
  EXPECT_FALSE(whole.viewpoint.known);
  EXPECT_FALSE(app::findField(whole.mesh.cloud, "vp_z"));
  EXPECT_EQ(1U, whole.warnings.size());
}

TEST(Merge, TellsOfUnitsThatDiffer)
{
  std::vector<app::NamedModel> parts{part(1), part(2)};
  parts[0].model.remarks.comments = {"units mm"};
  EXPECT_EQ(1U, merged(parts).warnings.size());
}

TEST_F(RepairApp, ReconstructsSeveralCloudsAsOne)
{
  save(folder_.path("a.pcd"), colouredCloud(300, 1));
  save(folder_.path("b.ply"), colouredCloud(200, 2));
  const RunResult result = runApp("pcl_ccaa_reconstruct",
                                  {folder_.path("a.pcd"),
                                   folder_.path("b.ply"),
                                   "--merge",
                                   "-o",
                                   folder_.path("out.ply"),
                                   "--report",
                                   folder_.path("report.json")});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ(500U, app::pointCount(loadMesh(folder_.path("out.ply")).mesh.cloud));
  EXPECT_EQ(500, report().at("N"));
  EXPECT_EQ(2U, report().at("input").size());
}

TEST_F(RepairApp, ReconstructsManyCloudsEachForItself)
{
  save(folder_.path("a.pcd"), colouredCloud(300, 1));
  save(folder_.path("b.pcd"), colouredCloud(200, 2));
  const RunResult result = runApp("pcl_ccaa_reconstruct",
                                  {folder_.path("a.pcd"),
                                   folder_.path("b.pcd"),
                                   "--output-folder",
                                   folder_.path("out"),
                                   "--format",
                                   "vtk"});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ(300U, app::pointCount(loadMesh(folder_.path("out/a.vtk")).mesh.cloud));
  EXPECT_EQ(200U, app::pointCount(loadMesh(folder_.path("out/b.vtk")).mesh.cloud));
}

TEST_F(RepairApp, SeveralCloudsNeedToBeToldWhatTheyAre)
{
  save(folder_.path("a.pcd"), colouredCloud(30));
  const RunResult result =
      runApp("pcl_ccaa_reconstruct",
             {folder_.path("a.pcd"), folder_.path("a.pcd"), folder_.path("out.ply")});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_NE(std::string::npos, result.errors.find("--merge"));
}

TEST_F(RepairApp, ADryRunOfAReconstructionTellsOfTheCloud)
{
  save(folder_.path("a.pcd"), colouredCloud(30));
  const RunResult result =
      runApp("pcl_ccaa_reconstruct",
             {folder_.path("a.pcd"), "--dry-run", "--report", "-", "--quiet"});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(30, json.at("N"));
  EXPECT_EQ("normals", json.at("outer_side_by"));
  EXPECT_EQ(nullptr, json.at("output"));
  EXPECT_EQ(1U, folder_.names().size());
}

} // namespace
} // namespace app_test
