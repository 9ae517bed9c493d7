// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: standard input and output in place of files.
#include <gtest/gtest.h>

#include "io/point_columns.h"
#include "repair_fixture.h"

namespace app_test {
namespace {

class Streams : public RepairApp {
protected:
  void
  SetUp() override
  {
    save(folder_.path("caps.ply"), twoCaps());
    save(folder_.path("cloud.pcd"), colouredCloud(400));
  }

  /** What a program has written to standard output, as a file. */
  std::string
  kept(const RunResult& result, const std::string& name)
  {
    writeFile(folder_.path(name), result.output);
    return folder_.path(name);
  }
};

TEST_F(Streams, WhatIsWrittenToStandardOutputIsTheFile)
{
  ASSERT_EQ(
      0,
      runApp("pcl_repair_holes", {folder_.path("caps.ply"), folder_.path("out.ply")})
          .exit_code);
  const RunResult result =
      runWithInput("pcl_repair_holes", {"-", "-"}, folder_.path("caps.ply"));
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_TRUE(readFile(folder_.path("out.ply")) == result.output);
  EXPECT_NE(std::string::npos, result.errors.find("standard output: ICM3"));
}

TEST_F(Streams, ProgramsWorkInAPipe)
{
  const RunResult result = runInShell(
      "pcl_damage_cloud " + folder_.path("caps.ply") +
      " - --patches 1 | pcl_repair_holes - - | pcl_mesh_quality - --report -");
  ASSERT_EQ(0, result.exit_code) << result.errors;
  const auto report = nlohmann::json::parse(result.output);
  EXPECT_EQ("-", report.at("input"));
  EXPECT_EQ(true, report.at("closed"));
}

TEST_F(Streams, AReconstructionReadsPcdAndWritesTheFormatAskedFor)
{
  const RunResult result = runWithInput(
      "pcl_ccaa_reconstruct", {"-", "-", "--format", "obj"}, folder_.path("cloud.pcd"));
  ASSERT_EQ(0, result.exit_code) << result.errors;
  EXPECT_GT(loadMesh(kept(result, "a.obj")).mesh.polygons.size(), 100U);
}

TEST_F(Streams, ADamagedCloudStaysPcd)
{
  const RunResult result = runWithInput(
      "pcl_damage_cloud", {"-", "-", "--patches", "1"}, folder_.path("cloud.pcd"));
  ASSERT_EQ(0, result.exit_code) << result.errors;
  const auto cloud = loadCloud(kept(result, "a.pcd")).mesh.cloud;
  EXPECT_EQ(392U, app::pointCount(cloud));
  EXPECT_TRUE(app::findField(cloud, "label"));
}

TEST_F(Streams, ARunThatFailsWritesNoByte)
{
  writeFile(folder_.path("bad.ply"),
            readFile(folder_.path("caps.ply")).substr(0, 2000));
  for (const char* program : {"pcl_ccaa_reconstruct", "pcl_repair_holes"}) {
    const RunResult result = runWithInput(program, {"-", "-"}, folder_.path("bad.ply"));
    EXPECT_EQ(1, result.exit_code);
    EXPECT_EQ("", result.output);
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
  }
  const RunResult empty = runApp("pcl_repair_holes", {"-", "-"});
  EXPECT_EQ(1, empty.exit_code);
  EXPECT_EQ("pcl_repair_holes: standard input is empty\n", empty.errors);
}

TEST_F(Streams, AReportThatCannotBeWrittenLeavesStandardOutputEmpty)
{
  const RunResult result = runApp(
      "pcl_repair_holes", {folder_.path("caps.ply"), "-", "--report", "/dev/full"});
  EXPECT_EQ(1, result.exit_code);
  EXPECT_EQ("", result.output);
}

TEST_F(Streams, EachStreamServesOnce)
{
  const std::string caps = folder_.path("caps.ply");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{caps, "-", "--report", "-"},
        {"-", folder_.path("out.ply"), "--free-points", "-"}}) {
    const RunResult result = runApp("pcl_repair_holes", arguments);
    EXPECT_EQ(1, result.exit_code);
    EXPECT_NE(std::string::npos, result.errors.find("only")) << result.errors;
  }
}

TEST_F(Streams, ABrokenPipeIsOneSentence)
{
  const RunResult result =
      runInShell("pcl_repair_holes " + folder_.path("caps.ply") + " - --quiet | true");
  EXPECT_EQ(1, result.exit_code);
  EXPECT_EQ("pcl_repair_holes: cannot write standard output: Broken pipe\n",
            result.errors);
}

TEST_F(Streams, AFormatIsRefusedWhereANameTellsIt)
{
  const std::string caps = folder_.path("caps.ply");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{caps, folder_.path("a.ply"), "--format", "vtk"},
        {caps, "-", "--format", "las"},
        {caps, "-", "--format", "pcd"}})
    EXPECT_EQ(1, runApp("pcl_repair_holes", arguments).exit_code) << arguments.back();
}

TEST_F(Streams, AHelpThatCannotBeWrittenIsAFailure)
{
  const RunResult result = runInShell("pcl_repair_holes --help > /dev/full");
  EXPECT_EQ(1, result.exit_code);
  EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
}

} // namespace
} // namespace app_test
