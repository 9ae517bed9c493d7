// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the order in which --help tells of the options.
#include <gtest/gtest.h>

#include "app_runner.h"

#include <string>
#include <tuple>

namespace app_test {
namespace {

TEST(Help, HasTheOptionsOfTheMethodBehindTheEverydayOnes)
{
  for (const auto& [program, everyday, method] :
       {std::tuple("pcl_repair_holes", "--no-join", "--falloff-exponent"),
        std::tuple("pcl_repair_holes", "--view", "--filling"),
        std::tuple("pcl_ccaa_reconstruct", "--format", "--min-angle")}) {
    const std::string help = runApp(program, {"--help"}).output;
    const std::size_t heading = help.find("\nOptions of the method");
    ASSERT_NE(std::string::npos, heading);
    EXPECT_LT(help.find(std::string("\n  ") + everyday), heading) << everyday;
    EXPECT_GT(help.find(std::string("\n  ") + method), heading) << method;
  }
}

} // namespace
} // namespace app_test
