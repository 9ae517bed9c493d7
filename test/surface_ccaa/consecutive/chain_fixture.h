// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: running chains in tests.
#pragma once

#include <pcl/console/print.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/mesh_asserts.h"
#include "test_parts.h"

#include <memory>

namespace pcl::ccaa::test {

using Chain = ConsecutiveReconstruction<PointXYZ>;

/** \brief Errors are expected in many tests; their text is not under test. */
class ConsecutiveTest : public ::testing::Test {
protected:
  ConsecutiveTest()
  {
    console::setVerbosityLevel(console::L_ALWAYS);
    chain_.setBaseAlgorithm(base_);
  }

  Triangles
  reconstruct(const Cloud::ConstPtr& cloud)
  {
    chain_.setInputCloud(cloud);
    Polygons polygons;
    chain_.reconstruct(polygons);
    EXPECT_EQ(chain_.getTriangleLabels().size(), polygons.size());
    return toTriangles(polygons);
  }

  Triangles
  reconstruct(const Positions& points)
  {
    return reconstruct(Cloud::ConstPtr(toCloud(points)));
  }

  /** \brief The default start and filter by hand. */
  static Triangles
  startAndFilter(const Cloud::ConstPtr& cloud)
  {
    Chain chain;
    chain.setBaseAlgorithm(nullptr);
    chain.setInputCloud(cloud);
    Polygons polygons;
    chain.reconstruct(polygons);
    return toTriangles(polygons);
  }

  /** \brief A start algorithm that gives always the same polygons. */
  static std::shared_ptr<ScriptedStart>
  startGiving(const Polygons& polygons)
  {
    return std::make_shared<ScriptedStart>(
        [polygons](const Cloud&, const Indices&) { return polygons; });
  }

  /** \brief A filter that leaves everything. */
  static std::shared_ptr<ScriptedFilter>
  openFilter()
  {
    return std::make_shared<ScriptedFilter>([](PolygonMesh&) {});
  }

  std::shared_ptr<ScriptedCompletion> base_ = std::make_shared<ScriptedCompletion>();
  Chain chain_;
};

} // namespace pcl::ccaa::test
