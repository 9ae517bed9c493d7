// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: bad usage and bad input end every app in the same way.
#include <gtest/gtest.h>

#include "app_runner.h"
#include "model_samples.h"
#include <unistd.h>

namespace app_test {
namespace {

/** How an app is called with an input and an output. */
struct AppCall {
  std::string program;
  std::string output; // name of the output file; the report for pcl_mesh_quality
  std::vector<std::string> rest;

  std::vector<std::string>
  arguments(const std::string& input, const std::string& output_path) const
  {
    std::vector<std::string> words{input};
    if (program == "pcl_mesh_quality")
      words.push_back("--report");
    if (program == "pcl_repair_holes")
      words.push_back("--inspect");
    words.push_back(output_path);
    words.insert(words.end(), rest.begin(), rest.end());
    return words;
  }
};

class BadInput : public testing::TestWithParam<AppCall> {
protected:
  /** Exit code 1, one line on stderr, nothing else left behind. */
  void
  expectRefused(const std::vector<std::string>& arguments)
  {
    const auto files_before = folder_.names();
    const RunResult result = runApp(GetParam().program, arguments);
    EXPECT_EQ(1, result.exit_code) << result.errors;
    EXPECT_TRUE(isOneLine(result.errors)) << result.errors;
    EXPECT_EQ("", result.output);
    EXPECT_EQ(files_before, folder_.names());
  }

  void
  expectInputRefused(const std::string& input)
  {
    SCOPED_TRACE(input);
    expectRefused(
        GetParam().arguments(folder_.path(input), folder_.path(GetParam().output)));
  }

  /** Sound input, and the given output. */
  void
  expectOutputRefused(const std::string& output)
  {
    SCOPED_TRACE(output);
    save(folder_.path("in.ply"), colouredSphere());
    expectRefused(GetParam().arguments(folder_.path("in.ply"), output));
  }

  bool
  readsMeshes() const
  {
    return GetParam().program == "pcl_mesh_quality" ||
           GetParam().program == "pcl_repair_holes";
  }

  TemporaryFolder folder_;
};

TEST_P(BadInput, MissingFileFolderOrUnknownEnding)
{
  std::filesystem::create_directory(folder_.path("folder.ply"));
  writeFile(folder_.path("cloud.las"), "no");
  writeFile(folder_.path("noending"), "no");
  writeFile(folder_.path("empty.ply"), "");
  for (const char* name :
       {"missing.ply", "folder.ply", "cloud.las", "noending", "empty.ply"})
    expectInputRefused(name);
}

TEST_P(BadInput, GarbageAndTruncatedFiles)
{
  save(folder_.path("cut.ply"), colouredSphere());
  const std::string bytes = readFile(folder_.path("cut.ply"));
  // Cut among the vertices, which every app reads.
  writeFile(folder_.path("cut.ply"), bytes.substr(0, 1500));
  writeFile(folder_.path("text.ply"), "Dear reader,\nthis is no cloud.\n");
  writeFile(folder_.path("newline.obj"), "v 0 0 0\nf \x01\x02\x03\n");
  for (const char* name : {"cut.ply", "text.ply", "newline.obj"})
    expectInputRefused(name);
}

TEST_P(BadInput, FewerThanThreeUsablePoints)
{
  if (readsMeshes())
    GTEST_SKIP() << "a mesh may be small";
  writeFile(folder_.path("one.xyz"), "1 2 3\n");
  writeFile(folder_.path("two.xyz"), "1 2 3\n4 5 6\n");
  writeFile(folder_.path("nan.xyz"), "nan 0 0\nnan 1 1\n0 0 0\n1 0 0\ninf 0 0\n");
  writeFile(folder_.path("comment.xyz"), "# nothing\n");
  writeFile(folder_.path("none.pcd"),
            "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 0\nHEIGHT 1\nDATA ascii\n");
  for (const char* name :
       {"one.xyz", "two.xyz", "nan.xyz", "comment.xyz", "none.pcd", "nofields.pcd"})
    expectInputRefused(name);
}

TEST_P(BadInput, UnwritableOutput)
{
  const std::string name = GetParam().output;
  if (GetParam().program != "pcl_repair_holes") { // which writes to a folder
    std::filesystem::create_directory(folder_.path("folder" + name));
    expectOutputRefused(folder_.path("folder" + name));
  }
  expectOutputRefused(folder_.path("missing/" + name));
  expectOutputRefused(folder_.path("in.ply")); // the input itself
  expectOutputRefused("/proc/" + name);
  writeFile(folder_.path("afile"), "x");
  expectOutputRefused(folder_.path("afile/" + name));
  if (!readsMeshes()) {
    expectOutputRefused(folder_.path("out.xyy"));
    expectOutputRefused(folder_.path("out"));
  }
}

TEST_P(BadInput, ReadOnlyFolder)
{
  if (geteuid() == 0)
    GTEST_SKIP() << "root may write everywhere";
  namespace fs = std::filesystem;
  fs::create_directory(folder_.path("locked"));
  fs::permissions(folder_.path("locked"),
                  fs::perms::owner_read | fs::perms::owner_exec);
  expectOutputRefused(folder_.path("locked/" + GetParam().output));
}

TEST_P(BadInput, BadUsage)
{
  save(folder_.path("in.ply"), colouredSphere());
  const auto good =
      GetParam().arguments(folder_.path("in.ply"), folder_.path(GetParam().output));
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--unknown"},
                                               {"--qui"},
                                               {"-z"},
                                               {"one", "too", "many", "files"},
                                               {"--quiet=3"}}) {
    SCOPED_TRACE(more.front());
    std::vector<std::string> arguments = good;
    arguments.insert(arguments.end(), more.begin(), more.end());
    expectRefused(arguments);
  }
  expectRefused({});
}

TEST_P(BadInput, HelpAndVersionGoToStandardOutput)
{
  for (const char* option : {"--help", "-h", "--version"}) {
    const RunResult result = runApp(GetParam().program, {option});
    EXPECT_EQ(0, result.exit_code);
    EXPECT_NE(std::string::npos, result.output.find(GetParam().program));
    EXPECT_EQ("", result.errors);
  }
}

TEST_P(BadInput, QuietRunsPrintNothing)
{
  save(folder_.path("in.ply"), colouredSphere());
  auto arguments =
      GetParam().arguments(folder_.path("in.ply"), folder_.path(GetParam().output));
  arguments.push_back("--quiet");
  const RunResult result = runApp(GetParam().program, arguments);
  EXPECT_EQ(0, result.exit_code);
  EXPECT_EQ("", result.output);
  EXPECT_EQ("", result.errors);
  EXPECT_EQ(2U, folder_.names().size());
}

TEST_P(BadInput, DoesNotTouchAnEarlierOutputWhenItFails)
{
  writeFile(folder_.path(GetParam().output), "an earlier result");
  writeFile(folder_.path("bad.ply"), "ply\n");
  expectInputRefused("bad.ply");
  EXPECT_EQ("an earlier result", readFile(folder_.path(GetParam().output)));
}

INSTANTIATE_TEST_SUITE_P(
    Apps,
    BadInput,
    testing::Values(AppCall{"pcl_ccaa_reconstruct", "out.ply", {}},
                    AppCall{"pcl_damage_cloud", "out.ply", {"--patches", "1"}},
                    AppCall{"pcl_mesh_quality", "out.json", {}},
                    AppCall{"pcl_repair_holes", "out", {"--no-pictures"}}),
    [](const auto& test) { return test.param.program; });

} // namespace
} // namespace app_test
