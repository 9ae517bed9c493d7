// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of edges without length that go from a patch.

#include <gtest/gtest.h>

#include "fairing/edge_collapse.h"
#include "support/mesh_topology.h"

#include <algorithm>

namespace pcl::repair {
namespace {

/** A triangle of the model's vertices, in it another one, and in that one a third of a
 * given size, corner by corner: 13 triangles. */
Patch
nestedTriangles(double size)
{
  Patch patch;
  patch.rim = {0, 1, 2};
  for (const double scale : {3.0, 1.0, size})
    for (const Position& corner :
         {Position(1.0, 0.0, 0.0), Position(-0.5, 0.9, 0.0), Position(-0.5, -0.9, 0.0)})
      patch.positions.push_back(scale * corner);
  for (pcl::index_t ring = 0; ring < 6; ring += 3)
    for (pcl::index_t c = 0; c < 3; ++c) {
      const pcl::index_t next = (c + 1) % 3;
      patch.triangles.push_back({ring + c, ring + next, ring + 3 + c});
      patch.triangles.push_back({ring + next, ring + 3 + next, ring + 3 + c});
    }
  patch.triangles.push_back({6, 7, 8});
  patch.free_point.assign(9, NONE);
  patch.hole.assign(13, 0);
  return patch;
}

TEST(EdgeCollapse, LeavesAPatchWithoutShortEdgesAsItIs)
{
  Patch patch = nestedTriangles(0.1);
  EXPECT_EQ(0U, collapseShortEdges(patch));
  EXPECT_EQ(9U, patch.positions.size());
  EXPECT_EQ(13U, patch.triangles.size());
}

TEST(EdgeCollapse, MakesOneVertexOfThoseInOnePlace)
{
  for (const double size : {0.0, 1e-6}) {
    Patch patch = nestedTriangles(size);
    EXPECT_EQ(2U, collapseShortEdges(patch));
    EXPECT_EQ(7U, patch.positions.size());
    EXPECT_EQ(9U, patch.triangles.size());
    EXPECT_EQ(patch.positions.size(), patch.free_point.size());
    EXPECT_EQ(patch.triangles.size(), patch.hole.size());
    const ccaa::test::Topology found = ccaa::test::topologyOf(patch.triangles);
    EXPECT_EQ(1, found.characteristic) << "a disc";
    EXPECT_EQ(1U, found.borders);
  }
}

TEST(EdgeCollapse, KeepsWhatIsHeld)
{
  Patch patch = nestedTriangles(0.0);
  std::fill(patch.free_point.begin() + 6, patch.free_point.end(), 5);
  EXPECT_EQ(0U, collapseShortEdges(patch));
  EXPECT_EQ(9U, patch.positions.size());
}

TEST(EdgeCollapse, KeepsCreases)
{
  Patch patch = nestedTriangles(0.0);
  patch.addCrease(0, 3);
  patch.addCrease(3, 8);
  EXPECT_EQ(1U, collapseShortEdges(patch)) << "the two that are on none";
  EXPECT_EQ(8U, patch.positions.size());
  EXPECT_TRUE(patch.isCrease(0, 3));
  EXPECT_TRUE(patch.isCrease(3, 7));
}

} // namespace
} // namespace pcl::repair
