// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of progress and cancelling.

#include <gtest/gtest.h>

#include "run/run_control.h"

#include <string>
#include <thread>

namespace pcl {
namespace ccaa {
namespace {

TEST(RunControl, TellsFromTheThreadThatMadeItOnly)
{
  int told = 0;
  RunControl control([&](const std::string&, double) {
    ++told;
    return true;
  });
  std::thread([&] { EXPECT_TRUE(control.report("work", 0.5)); }).join();
  EXPECT_EQ(0, told);
  EXPECT_TRUE(control.report("work", 0.5));
  EXPECT_EQ(1, told);
}

TEST(RunControl, AnotherThreadHearsThatItIsToStop)
{
  RunControl control([](const std::string&, double) { return false; });
  EXPECT_FALSE(control.report("work", 0.5));
  std::thread([&] { EXPECT_FALSE(control.report("work", 0.6)); }).join();
}

} // namespace
} // namespace ccaa
} // namespace pcl
