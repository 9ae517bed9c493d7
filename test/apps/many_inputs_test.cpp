// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: many inputs in one run, and runs that only look.
#include "repair_fixture.h"

namespace app_test {
namespace {

class ManyInputs : public RepairApp {
protected:
  void
  SetUp() override
  {
    test::Shape holed = test::withoutTriangles(test::icosphere(2), {0, 1, 2, 3});
    save(folder_.path("a.ply"), test::toPolygonMesh(holed));
    save(folder_.path("b.ply"), test::toPolygonMesh(test::icosphere(1)));
    writeFile(folder_.path("bad.ply"), "ply\n");
  }

  RunResult
  repairAll(const std::vector<std::string>& names,
            const std::vector<std::string>& options = {})
  {
    std::vector<std::string> arguments{"--output-folder", folder_.path("out")};
    for (const std::string& name : names)
      arguments.push_back(folder_.path(name));
    arguments.insert(arguments.end(), options.begin(), options.end());
    return runApp("pcl_repair_holes", arguments);
  }

  bool
  exists(const std::string& name) const
  {
    return std::filesystem::exists(folder_.path(name));
  }
};

TEST_F(ManyInputs, EachBecomesAFileOfItsName)
{
  const RunResult result = repairAll({"a.ply", "b.ply"}, {"--format", "off"});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ(320U, loadMesh(folder_.path("out/a.off")).mesh.polygons.size());
  EXPECT_EQ(80U, loadMesh(folder_.path("out/b.off")).mesh.polygons.size());
  EXPECT_EQ(3, std::count(result.output.begin(), result.output.end(), '\n'));
}

TEST_F(ManyInputs, GoesOnAfterABadOneAndEndsWithTheWorstCode)
{
  const RunResult result = repairAll({"bad.ply", "a.ply"});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_TRUE(exists("out/a.ply"));
  EXPECT_FALSE(exists("out/bad.ply"));
  EXPECT_EQ(2, std::count(result.errors.begin(), result.errors.end(), '\n'))
      << result.errors;
}

TEST_F(ManyInputs, OneReportTellsOfAll)
{
  repairAll({"bad.ply", "a.ply"}, {"--report", folder_.path("report.json"), "-q"});
  const auto json = report();
  EXPECT_EQ("pcl_repair_holes", json.at("program"));
  EXPECT_EQ(1, json.at("exit_code"));
  ASSERT_EQ(2U, json.at("files").size());
  EXPECT_EQ(1, json.at("files")[0].at("exit_code"));
  EXPECT_EQ(nullptr, json.at("files")[0].at("output"));
  EXPECT_NE("", json.at("files")[0].at("reason"));
  EXPECT_EQ(0, json.at("files")[1].at("exit_code"));
  EXPECT_EQ(1U, json.at("files")[1].at("holes").size());
}

TEST_F(ManyInputs, TheirReportMayGoToStandardOutput)
{
  const RunResult result = repairAll({"a.ply", "b.ply"}, {"--report", "-"});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_EQ(2U, nlohmann::json::parse(result.output).at("files").size());
  EXPECT_EQ(3, std::count(result.errors.begin(), result.errors.end(), '\n'));
}

TEST_F(ManyInputs, TwoOfOneNameAreRefusedBeforeTheWork)
{
  std::filesystem::create_directory(folder_.path("other"));
  save(folder_.path("other/a.ply"), colouredSphere());
  EXPECT_EQ(1, repairAll({"a.ply", "other/a.ply"}).exit_code);
  EXPECT_FALSE(exists("out"));
}

TEST_F(ManyInputs, AnInputIsNeverWrittenOver)
{
  const std::string before = readFile(folder_.path("a.ply"));
  const RunResult result =
      runApp("pcl_repair_holes",
             {folder_.path("a.ply"), "--output-folder", folder_.path(".")});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_TRUE(before == readFile(folder_.path("a.ply")));
}

TEST_F(ManyInputs, NoFolderStaysBehindWhenAllFail)
{
  EXPECT_EQ(1, repairAll({"bad.ply"}).exit_code);
  EXPECT_FALSE(exists("out"));
}

TEST_F(ManyInputs, SeveralNamesWithoutAFolderAreRefused)
{
  const RunResult result =
      runApp("pcl_repair_holes",
             {folder_.path("a.ply"), folder_.path("out.ply"), folder_.path("b.ply")});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_FALSE(exists("out.ply"));
}

TEST_F(ManyInputs, ADryRunTellsTheHolesAndWritesNothing)
{
  const auto before = folder_.names();
  const RunResult result =
      runApp("pcl_repair_holes", {folder_.path("a.ply"), "--dry-run", "--report", "-"});
  EXPECT_EQ(2, result.exit_code);
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(true, json.at("would_repair"));
  EXPECT_EQ(1, json.at("plan").at("holes"));
  EXPECT_EQ(before, folder_.names());
}

TEST_F(ManyInputs, ADryRunTellsWhatIsTakenFromTheData)
{
  save(folder_.path("caps.ply"), twoCaps());
  const RunResult result = runApp(
      "pcl_repair_holes", {folder_.path("caps.ply"), "--dry-run", "--report", "-"});
  const auto json = nlohmann::json::parse(result.output);
  EXPECT_EQ(2, json.at("plan").at("island_rims"));
  EXPECT_GT(json.at("parameters_from_data").at("near"), 0.0);
  EXPECT_EQ(2.5, json.at("parameters_from_data").at("far_in_gaps"));
}

TEST_F(ManyInputs, ADryRunOfASoundModelIsZero)
{
  const RunResult result =
      runApp("pcl_repair_holes", {folder_.path("b.ply"), "--dry-run"});
  EXPECT_EQ(0, result.exit_code);
  EXPECT_EQ("", result.errors);
}

TEST_F(ManyInputs, ADryRunOfManyTellsOfEach)
{
  const RunResult result = repairAll({"a.ply", "b.ply"}, {"--dry-run"});
  EXPECT_EQ(2, result.exit_code);
  EXPECT_FALSE(exists("out"));
  for (const char* name : {"a.ply: ICM1", "b.ply: ICM1"})
    EXPECT_NE(std::string::npos, result.output.find(name)) << result.output;
}

} // namespace
} // namespace app_test
