// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the pictures of an inspection.

#include <gtest/gtest.h>

#include "repair_fixture.h"

#include <string>
#include <vector>

namespace app_test {
namespace {

/** Named apart from the rest: sanitizers complain about the drivers that draw. */
class RenderInspection : public RepairApp {};

TEST_F(RenderInspection, DrawsPicturesInTheAskedSize)
{
  save(folder_.path("caps.ply"), twoCaps());
  const RunResult result = inspect("caps.ply", {"--size", "400x240"});
  ASSERT_EQ(0, result.exit_code) << result.errors;
  for (const char* name : {"loops.png", "islands.png", "lines.png", "slice.png"}) {
    const std::string picture = readFile(foundFile(name));
    ASSERT_GT(picture.size(), 1000U) << name;
    EXPECT_EQ("PNG", picture.substr(1, 3));
    EXPECT_EQ(std::string("\0\0\1\x90\0\0\0\xf0", 8), picture.substr(16, 8)) << name;
  }
}

TEST_F(RenderInspection, DrawsTheSamePicturesForAnyNumberOfThreads)
{
  save(folder_.path("caps.ply"), twoCaps());
  std::vector<std::string> first;
  for (const char* threads : {"1", "2"}) {
    const RunResult result =
        inspect("caps.ply", {"--threads", threads, "--size", "300x200"});
    ASSERT_EQ(0, result.exit_code) << result.errors;
    const std::vector<std::string> pictures{readFile(foundFile("lines.png")),
                                            readFile(foundFile("slice.png"))};
    if (first.empty())
      first = pictures;
    EXPECT_TRUE(first == pictures) << threads;
  }
}

} // namespace
} // namespace app_test
