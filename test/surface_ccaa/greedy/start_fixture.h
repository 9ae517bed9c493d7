// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a GreedyStart for the tests of the class.
#pragma once

#include <pcl/console/print.h>
#include <pcl/surface_ccaa/block_search.h>
#include <pcl/surface_ccaa/greedy_start.h>

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/mesh_asserts.h"

#include <memory>
#include <set>
#include <vector>

namespace pcl::ccaa::test {

using Start = GreedyStart<PointXYZ>;
using Cloud = PointCloud<PointXYZ>;
using Blocks = pcl::search::BlockSearch<PointXYZ>;

inline std::size_t
usedPoints(const Triangles& triangles)
{
  std::set<index_t> used;
  for (const Triangle& t : triangles)
    used.insert(t.begin(), t.end());
  return used.size();
}

/** Errors are expected in many tests; their text is not under test. */
class GreedyStartTest : public ::testing::Test {
protected:
  GreedyStartTest()
  {
    console::setVerbosityLevel(console::L_ALWAYS);
    start_.setSearchMethod(std::make_shared<Blocks>());
  }

  Triangles
  reconstruct(const Cloud::ConstPtr& cloud)
  {
    start_.setInputCloud(cloud);
    std::vector<Vertices> polygons;
    start_.reconstruct(polygons);
    return toTriangles(polygons);
  }

  Triangles
  reconstruct(const Positions& points)
  {
    return reconstruct(toCloud(points));
  }

  Start start_;
};

} // namespace pcl::ccaa::test
