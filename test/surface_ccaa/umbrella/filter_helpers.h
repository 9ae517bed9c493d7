// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: running the umbrella filter in tests.
#pragma once

#include <pcl/surface_ccaa/umbrella_filter.h>

#include <gtest/gtest.h>

#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace pcl::ccaa::test {

/** \brief What came out of one run. */
struct Filtered {
  Triangles triangles;
  std::vector<PointRole> roles;
  UmbrellaReport report;
};

/** \brief Run a filter object on a shape. */
inline Filtered
filterWith(UmbrellaFilter& filter, const Shape& shape)
{
  auto input = pcl::make_shared<pcl::PolygonMesh>(toPolygonMesh(shape));
  filter.setInputMesh(input);
  pcl::PolygonMesh output;
  filter.process(output);
  EXPECT_TRUE(sameCloud(input->cloud, output.cloud));
  return {toTriangles(output.polygons), filter.getPointRoles(), filter.getReport()};
}

/** \brief Filter with the region rule C3.4-3 off unless asked for. */
inline Filtered
filtered(const Shape& shape,
         std::size_t minimum_internal_points = 0,
         unsigned threads = 1)
{
  UmbrellaFilter filter;
  filter.setMinimumInternalPoints(minimum_internal_points);
  filter.setNumberOfThreads(threads);
  return filterWith(filter, shape);
}

/** \brief The contract: an ICADM of input triangles in input order, with roles and
 * counts that agree with it. */
inline void
expectCertified(const Shape& input, const Filtered& result)
{
  const std::size_t count = input.vertices.size();
  ASSERT_TRUE(isIcadm(result.triangles, count));
  ASSERT_TRUE(isSubsetOf(result.triangles, input.triangles));
  const auto& report = result.report;
  EXPECT_EQ(report.output_triangles, result.triangles.size());
  EXPECT_EQ(report.components, countComponents(result.triangles));
  EXPECT_EQ(report.internal_points + report.boundary_points + report.free_points,
            count);
  std::set<pcl::index_t> used, border;
  std::map<std::pair<pcl::index_t, pcl::index_t>, int> edges;
  for (const auto& triangle : result.triangles)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      used.insert(triangle[corner]);
      ++edges[std::minmax({triangle[corner], triangle[(corner + 1) % 3]})];
    }
  for (const auto& [edge, fill] : edges)
    if (fill == 1)
      border.insert({edge.first, edge.second});
  ASSERT_EQ(result.roles.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto point_index = static_cast<pcl::index_t>(i);
    const auto expected = used.count(point_index) == 0     ? PointRole::FREE
                          : border.count(point_index) != 0 ? PointRole::BOUNDARY
                                                           : PointRole::INTERNAL;
    ASSERT_EQ(result.roles[i], expected) << "point " << i;
  }
}

/** \brief Random triangles between random points; may hold triangles twice. */
inline Shape
randomSoup(int vertex_count, std::size_t triangle_count, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<pcl::index_t> vertex(0, vertex_count - 1);
  std::uniform_real_distribution<float> coordinate(-1.0f, 1.0f);
  Shape shape;
  for (int i = 0; i < vertex_count; ++i) {
    const float x = coordinate(random), y = coordinate(random), z = coordinate(random);
    shape.vertices.emplace_back(x, y, z);
  }
  while (shape.triangles.size() < triangle_count) {
    const Triangle triangle{vertex(random), vertex(random), vertex(random)};
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
        triangle[2] != triangle[0])
      shape.triangles.push_back(triangle);
  }
  return shape;
}

/** \brief A surface with random errors: triangles lost, and as many wild ones added.
 * Its points are those of a float cloud. */
inline Shape
damaged(Shape shape, double share, unsigned int seed)
{
  for (auto& vertex : shape.vertices)
    for (auto& coordinate : vertex.reshaped()) {
      // volatile: GCC 12 drops the way to float and back when it vectorises it
      volatile const float rounded = static_cast<float>(coordinate);
      coordinate = static_cast<double>(rounded);
    }
  std::mt19937 random(seed);
  std::uniform_int_distribution<std::size_t> triangle(0, shape.triangles.size() - 1);
  std::uniform_int_distribution<std::size_t> vertex(0, shape.vertices.size() - 1);
  const auto errors =
      static_cast<std::size_t>(share * static_cast<double>(shape.triangles.size()));
  for (std::size_t i = 0; i < errors; ++i) {
    Triangle wild = shape.triangles[triangle(random)];
    wild[2] = static_cast<pcl::index_t>(vertex(random));
    if (wild[0] != wild[2] && wild[1] != wild[2])
      shape.triangles[triangle(random)] = wild;
  }
  return shape;
}

} // namespace pcl::ccaa::test
