// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the shortest turn from one direction to another.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "mesh/turn_between.h"

#include <cmath>

namespace pcl::ccaa::test {
namespace {

TEST(TurnBetween, IsTheShortestAlsoBetweenOpposites)
{
  const Eigen::Vector3d from(1.0, 2.0, -2.0);
  for (const Eigen::Vector3d& to : {Eigen::Vector3d(0.0, 0.0, 7.0),
                                    Eigen::Vector3d(from),
                                    Eigen::Vector3d(-2.0 * from)}) {
    const Eigen::Quaterniond turn = turnBetween(from, to);
    EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-12);
    const double angle = std::acos(from.normalized().dot(to.normalized()));
    EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), angle, 1e-7);
  }
}

} // namespace
} // namespace pcl::ccaa::test
