// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of how edges are shared out among threads.
#include <gtest/gtest.h>

#include "greedy/block_schedule.h"

#include <random>

using pcl::ccaa::BlockSchedule;

namespace {

TEST(BlockSchedule, TheTopLevelIsOneGroup)
{
  for (const std::size_t points : {0u, 1u, 2048u, 2049u, 100000u}) {
    const BlockSchedule schedule(points);
    EXPECT_LE(schedule.groupCount(schedule.levels() - 1), 1u) << points;
  }
}

TEST(BlockSchedule, GroupsOfALevelCoverAllPointsOnce)
{
  const BlockSchedule schedule(50000);
  for (unsigned int level = 0; level < schedule.levels(); ++level) {
    std::size_t next = 0;
    for (std::size_t group = 0; group < schedule.groupCount(level); ++group) {
      EXPECT_EQ(schedule.begin(level, group), next);
      next = schedule.end(level, group);
    }
    EXPECT_EQ(next, 50000u);
  }
}

TEST(BlockSchedule, AnEdgeBelongsToTheLowestLevelThatHoldsBothEnds)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<pcl::index_t> pick(0, 99999);
  const auto group = [](pcl::index_t rank, unsigned int level) {
    return std::size_t(rank) >> (BlockSchedule::BLOCK_BITS + level);
  };
  for (int i = 0; i < 1000; ++i) {
    const pcl::index_t a = pick(random), b = pick(random);
    const unsigned int level = BlockSchedule::levelOf(a, b);
    EXPECT_EQ(group(a, level), group(b, level));
    if (level > 0) {
      EXPECT_NE(group(a, level - 1), group(b, level - 1));
    }
  }
}

} // namespace
