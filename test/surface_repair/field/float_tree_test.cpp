// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of searches around positions of any size.

#include <gtest/gtest.h>

#include "field/float_tree.h"

namespace pcl::repair {
namespace {

TEST(FloatTree, FindsTheNearestFromBeyondWhatFloatsHold)
{
  const FloatTree tree({{0.0, 0.0, 0.0}, {1e-30, 0.0, 0.0}, {0.0, 1e-30, 0.0}});
  for (const double far : {1e-20, 1.0, 1e30, 1e300})
    EXPECT_EQ(3U, tree.nearest(Position(far, 0.0, 0.0), 3).size()) << far;
}

} // namespace
} // namespace pcl::repair
