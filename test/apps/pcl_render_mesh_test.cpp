// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pcl_render_mesh as a user runs it.

#include <gtest/gtest.h>

#include "app_runner.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

/** \brief A triangle and a cloud to draw, in a folder of their own. */
class RenderMesh : public testing::Test {
protected:
  RenderMesh()
  {
    app_test::writeFile(path("triangle.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    app_test::writeFile(path("cloud.xyz"), "0 0 0\n1 0 0\n0 1 0\n");
  }

  std::string
  path(const std::string& name) const
  {
    return folder_.path(name);
  }

  static app_test::RunResult
  render(const std::vector<std::string>& arguments)
  {
    return app_test::runApp("pcl_render_mesh", arguments);
  }

private:
  app_test::TemporaryFolder folder_;
};

/** \brief Width and height from the header of a PNG file, 0 if it is none. */
std::pair<std::uint32_t, std::uint32_t>
readPngSize(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  unsigned char header[24] = {};
  file.read(reinterpret_cast<char*>(header), sizeof(header));
  if (!file || header[1] != 'P')
    return {0, 0};
  const auto number = [&](int at) {
    return std::uint32_t{header[at]} << 24 | std::uint32_t{header[at + 1]} << 16 |
           std::uint32_t{header[at + 2]} << 8 | std::uint32_t{header[at + 3]};
  };
  return {number(16), number(20)};
}

TEST_F(RenderMesh, TakesPictureOfMeshInTheAskedSize)
{
  const auto run = render({path("triangle.obj"), path("a.png"), "--size", "320x200"});
  ASSERT_EQ(0, run.exit_code) << run.errors;
  EXPECT_TRUE(app_test::isOneLineWithVerdict(run.output)) << run.output;
  EXPECT_EQ(std::make_pair(320u, 200u), readPngSize(path("a.png")));
}

TEST_F(RenderMesh, TakesPictureOfCloudInEveryColoring)
{
  for (const std::string coloring : {"none", "role", "component"}) {
    const std::string picture = path(coloring + ".png");
    EXPECT_EQ(0,
              render({path("cloud.xyz"), picture, "--color-by", coloring}).exit_code);
    EXPECT_EQ(std::make_pair(1200u, 900u), readPngSize(picture)) << coloring;
  }
}

TEST_F(RenderMesh, ColoursWhatIsNewSinceAnEarlierState)
{
  app_test::writeFile(path("square.obj"),
                      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 3 2 1\nf 2 4 3\n");
  const auto picture = [&](const std::string& name, const std::string& earlier) {
    const auto run = render({path("square.obj"),
                             path(name),
                             "--size",
                             "60x60",
                             "--new-since",
                             path(earlier)});
    EXPECT_EQ(0, run.exit_code) << run.errors;
    return app_test::readFile(path(name));
  };
  // The triangle is there, the other way round; the rest of the square is not.
  EXPECT_NE(picture("half.png", "triangle.obj"), picture("none.png", "square.obj"));
  EXPECT_NE(picture("half.png", "triangle.obj"), picture("all.png", "cloud.xyz"));
}

TEST_F(RenderMesh, ShowsTheColoursOfThePoints)
{
  const auto picture = [&](const std::string& name, const std::string& colour) {
    app_test::writeFile(path("coloured.obj"),
                        "v 0 0 0 " + colour + "\nv 1 0 0 " + colour + "\nv 0 1 0 " +
                            colour + "\nf 1 2 3\n");
    const auto run = render(
        {path("coloured.obj"), path(name), "--size", "60x60", "--color-by", "rgb"});
    EXPECT_EQ(0, run.exit_code) << run.errors;
    return app_test::readFile(path(name));
  };
  EXPECT_NE(picture("red.png", "1 0 0"), picture("blue.png", "0 0 1"));
}

TEST_F(RenderMesh, NeedsNoDisplay)
{
  unsetenv("DISPLAY");
  const auto run = render({path("triangle.obj"), path("a.png")});
  ASSERT_EQ(0, run.exit_code) << run.errors;
  EXPECT_TRUE(fs::exists(path("a.png")));
}

TEST_F(RenderMesh, RefusesBadUsageWithOneLineAndNoFile)
{
  const std::string input = path("triangle.obj");
  const std::string output = path("a.png");
  const std::vector<std::vector<std::string>> refused = {
      {},
      {input},
      {input, path("a.jpg")},
      {path("missing.ply"), output},
      {path(""), output},
      {input, path("no/such/folder.png")},
      {input, output, "--size", "0x7"},
      {input, output, "--view", "0,0,0"},
      {input, output, "--view-up", "1,2"},
      {input, output, "--color-by", "mood"},
      {input, output, "--color-by", "rgb"},
      {input, output, "--new-since", path("missing.ply")},
      {input, output, "--new-since", input, "--color-by", "component"},
      {input, output, "--zoom", "-1"},
      {input, output, "--unknown"}};
  for (const auto& arguments : refused) {
    const auto run = render(arguments);
    EXPECT_EQ(1, run.exit_code) << testing::PrintToString(arguments);
    EXPECT_TRUE(app_test::isOneLine(run.errors)) << run.errors;
    EXPECT_FALSE(fs::exists(output)) << testing::PrintToString(arguments);
  }
}

} // namespace
