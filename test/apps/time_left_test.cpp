// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the estimate of the time left, without any clock.
#include <gtest/gtest.h>

#include "cli/progress.h"

#include <cmath>
#include <limits>

namespace app_test {
namespace {

using app::TimeLeft;

/** One step of `seconds` at an even pace, told ten times a second from `from` to `to`
 * of it. */
void
goOn(TimeLeft& time, double seconds, double from, double to, double start = 0)
{
  const int ticks = static_cast<int>(seconds * 10);
  for (int i = static_cast<int>(from * ticks); i <= static_cast<int>(to * ticks); ++i)
    time.update(static_cast<double>(i) / ticks, start + i / 10.0);
}

TEST(TimeLeft, IsExactAtAnEvenPace)
{
  TimeLeft time;
  goOn(time, 40, 0, 0.5);
  ASSERT_TRUE(time.seconds());
  EXPECT_NEAR(20, *time.seconds(), 0.2);
  goOn(time, 40, 0.51, 0.9);
  EXPECT_NEAR(4, *time.seconds(), 0.2);
}

TEST(TimeLeft, IsNotToldOfShortSteps)
{
  TimeLeft time;
  goOn(time, TimeLeft::patience * 0.9, 0, 1);
  EXPECT_FALSE(time.seconds());
}

TEST(TimeLeft, IsNotToldBeforeThePaceIsKnown)
{
  TimeLeft time;
  goOn(time, 1000, 0, 0.04);
  EXPECT_FALSE(time.seconds());
  goOn(time, 1000, 0.041, 0.06);
  EXPECT_TRUE(time.seconds());
}

TEST(TimeLeft, BeginsAnewWithEachStep)
{
  TimeLeft time;
  goOn(time, 40, 0, 1);
  EXPECT_NEAR(0, *time.seconds(), 0.1);
  time.update(0, 41);
  EXPECT_FALSE(time.seconds());
  goOn(time, 10, 0, 0.5, 41);
  EXPECT_NEAR(5, *time.seconds(), 0.2);
}

TEST(TimeLeft, DoesNotJumpWhenThePaceChanges)
{
  TimeLeft time;
  goOn(time, 20, 0, 0.5); // 10 seconds left, then four times slower
  double before = *time.seconds();
  for (int i = 1; i <= 400; ++i) {
    time.update(0.5 + 0.5 * i / 400, 10 + i / 10.0);
    EXPECT_LT(std::abs(*time.seconds() - before), 0.5) << i;
    before = *time.seconds();
  }
  EXPECT_LT(before, 1.0);
}

TEST(TimeLeft, CountsDownWhileNothingIsTold)
{
  TimeLeft time;
  goOn(time, 40, 0, 0.5);
  time.update(0.5, 21);
  EXPECT_NEAR(19.3, *time.seconds(), 0.5);
}

TEST(TimeLeft, CountsOnlyTheShareOfTheStepItself)
{
  TimeLeft time; // the step begins at one half of a whole that is not known
  for (int i = 0; i <= 100; ++i)
    time.update(0.5 + 0.25 * i / 100, i / 10.0);
  EXPECT_NEAR(10, *time.seconds(), 0.2);
}

TEST(TimeLeft, TakesNoHarmFromSharesThatAreNone)
{
  TimeLeft time;
  time.update(std::numeric_limits<double>::quiet_NaN(), 1);
  time.update(-1, 2);
  time.update(7, 9);
  ASSERT_TRUE(time.seconds());
  EXPECT_GE(*time.seconds(), 0);
}

TEST(ClockText, IsShortAndCoarse)
{
  EXPECT_EQ("0:07", app::clockText(7.4, false));
  EXPECT_EQ("1:05", app::clockText(65, false));
  EXPECT_EQ("2:01:05", app::clockText(7265, false));
  EXPECT_EQ("0:07", app::clockText(7.4, true));
  EXPECT_EQ("0:45", app::clockText(43, true));
  EXPECT_EQ("4:10", app::clockText(253, true));
  EXPECT_EQ("21:00", app::clockText(1275, true));
  EXPECT_EQ("0:00", app::clockText(-3, true));
}

} // namespace
} // namespace app_test
