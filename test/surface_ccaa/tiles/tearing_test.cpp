// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: opening a surface along edges.
#include <gtest/gtest.h>

#include "support/mesh_asserts.h"
#include "support/mesh_topology.h"
#include "support/random_source.h"
#include "support/shapes.h"
#include "tiles/tearing.h"

#include <algorithm>
#include <vector>

namespace pcl::ccaa::test {
namespace {

/** All of a surface is known, but told only as far as it is asked for. */
Tearing
torn(const Triangles& triangles, const std::vector<Tearing::Edge>& edges)
{
  Tearing tearing(edges);
  while (!tearing.asked().empty()) {
    for (const Triangle& t : triangles)
      tearing.see({WideIndex(t[0]), WideIndex(t[1]), WideIndex(t[2])});
    tearing.settle();
  }
  return tearing;
}

Triangles
left(const Triangles& triangles, const Tearing& tearing)
{
  Triangles all;
  for (const Triangle& t : triangles)
    if (tearing.gone().count(
            cornersInOrder({WideIndex(t[0]), WideIndex(t[1]), WideIndex(t[2])})) == 0)
      all.push_back(t);
  return all;
}

/** Some edges, the same for a seed. */
std::vector<Tearing::Edge>
someEdges(const Triangles& triangles, std::size_t count, std::uint64_t seed)
{
  RandomSource random(seed);
  std::vector<Tearing::Edge> edges;
  for (std::size_t i = 0; i < count; ++i) {
    const auto t =
        static_cast<std::size_t>(random.uniform() * double(triangles.size()));
    const auto ends =
        std::minmax({WideIndex(triangles[t][0]), WideIndex(triangles[t][1])});
    edges.push_back({ends.first, ends.second});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

TEST(Tearing, LeavesOneFanAtEachPoint)
{
  const Shape shape = icosphere(3);
  std::size_t more_than_torn = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto edges = someEdges(shape.triangles, 60, seed);
    const Tearing tearing = torn(shape.triangles, edges);
    const Triangles all = left(shape.triangles, tearing);
    EXPECT_TRUE(isIcadm(all, shape.vertices.size())) << seed;
    for (const Triangle& t : all)
      for (std::size_t i = 0; i < 3; ++i) {
        const auto ends = std::minmax({WideIndex(t[i]), WideIndex(t[(i + 1) % 3])});
        EXPECT_FALSE(std::binary_search(
            edges.begin(), edges.end(), Tearing::Edge{ends.first, ends.second}));
      }
    more_than_torn += tearing.gone().size() > 2 * edges.size() ? 1 : 0;
  }
  EXPECT_GT(more_than_torn, 0U); // some seed leaves several fans
}

TEST(Tearing, CountsTheEdgesThatAreOpenThen)
{
  for (const Shape& shape : {icosphere(3), terrain(20, 20)})
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const auto edges = someEdges(shape.triangles, 40, seed);
      std::int64_t inner = 0;
      for (const Tearing::Edge& edge : edges)
        inner +=
            std::count_if(
                shape.triangles.begin(), shape.triangles.end(), [&](const Triangle& t) {
                  return std::count(t.begin(), t.end(), index_t(edge[0])) +
                             std::count(t.begin(), t.end(), index_t(edge[1])) ==
                         2;
                }) == 2;
      const Tearing tearing = torn(shape.triangles, edges);
      const auto before =
          static_cast<std::int64_t>(countBoundaryEdges(shape.triangles));
      // Those that are torn counted as two.
      EXPECT_EQ(
          before + 2 * inner + tearing.openEdges(),
          static_cast<std::int64_t>(countBoundaryEdges(left(shape.triangles, tearing))))
          << seed;
    }
}

TEST(Tearing, NothingGoesWhereNothingIsTorn)
{
  const Tearing tearing = torn(icosphere(2).triangles, {});
  EXPECT_TRUE(tearing.gone().empty());
  EXPECT_EQ(tearing.openEdges(), 0);
}

} // namespace
} // namespace pcl::ccaa::test
