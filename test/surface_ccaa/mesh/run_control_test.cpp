// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of progress and cancelling.

#include <gtest/gtest.h>

#include "run/run_control.h"

#include <string>
#include <thread>

namespace pcl::ccaa {
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

TEST(RunControl, AsksAgainAfterMuchWorkThatReportsNothing)
{
  int told = 0;
  RunControl control([&](const std::string& stage, double) {
    EXPECT_EQ("work", stage);
    return ++told < 3;
  });
  control.report("work", 0.5);
  EXPECT_TRUE(control.spend(RunControl::PATIENCE - 1));
  EXPECT_EQ(1, told);
  EXPECT_TRUE(control.spend(1));
  EXPECT_EQ(2, told);
  EXPECT_FALSE(control.spend(RunControl::PATIENCE));
  EXPECT_EQ(RunControl::PATIENCE, control.longestUnasked());
}

TEST(RunControl, PartStopsWhenItHasSpentWhatItMay)
{
  RunControl whole;
  RunControl part(&whole, 100), other(&whole, 100);
  EXPECT_TRUE(part.spend(100));
  EXPECT_FALSE(part.spend(1));
  EXPECT_TRUE(part.cancelled());
  EXPECT_FALSE(other.cancelled());
  EXPECT_FALSE(whole.cancelled());
  EXPECT_EQ(101U, whole.work());
}

TEST(WorkCount, TellsSmallStepsTogether)
{
  RunControl control;
  {
    WorkCount work(&control);
    for (int i = 0; i < 100; ++i)
      EXPECT_TRUE(work.add(1));
    EXPECT_EQ(0U, control.work());
    work.add(RunControl::PATIENCE);
    EXPECT_EQ(100U + RunControl::PATIENCE, control.work());
    work.add(7);
  }
  EXPECT_EQ(107U + RunControl::PATIENCE, control.work());
  EXPECT_TRUE(WorkCount(nullptr).add(RunControl::PATIENCE));
}

TEST(WorkCount, StopsSoonAfterItsPartMay)
{
  RunControl part(nullptr, 1000000);
  WorkCount work(&part);
  std::uint64_t steps = 0;
  while (work.add(10))
    ++steps;
  EXPECT_GE(10 * (steps + 1), 1000000U);
  EXPECT_LE(10 * steps, 1100000U);
}

TEST(RunControl, PartStopsWithTheWholeAndTellsNoStages)
{
  int told = 0;
  RunControl whole([&](const std::string&, double) { return ++told < 2; });
  RunControl part(&whole);
  EXPECT_TRUE(part.report("of the part", 0.5));
  EXPECT_EQ(0, told);
  EXPECT_TRUE(part.askAgain());
  EXPECT_FALSE(part.spend(RunControl::PATIENCE));
  EXPECT_TRUE(whole.cancelled());
  EXPECT_FALSE(part.report("of the part", 0.6));
}

} // namespace
} // namespace pcl::ccaa
