// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: models and their boundaries for the tests of this room.
#pragma once

#include <pcl/memory.h>

#include "boundary/extraction.h"
#include "icadm/model_assembly.h"
#include "icadm/model_reading.h"
#include "support/mesh_asserts.h"
#include "support/shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace pcl::repair::test {

/** \brief A manifold shape as a model, in double precision. */
inline IncompleteModel
modelOf(const ccaa::test::Shape& shape)
{
  ccaa::test::Shape used; // vertices without a triangle left out
  std::vector<pcl::index_t> number(shape.vertices.size(), -1);
  used.triangles = shape.triangles;
  for (Triangle& triangle : used.triangles)
    for (pcl::index_t& corner : triangle) {
      pcl::index_t& vertex = number[static_cast<std::size_t>(corner)];
      if (vertex < 0) {
        vertex = static_cast<pcl::index_t>(used.vertices.size());
        used.vertices.push_back(shape.vertices[static_cast<std::size_t>(corner)]);
      }
      corner = vertex;
    }
  return assembleModel(
      std::move(used.triangles), std::move(used.vertices), ccaa::LoopContext());
}

/** \brief The shape without triangles whose centroid is where the condition holds. */
inline ccaa::test::Shape
without(ccaa::test::Shape shape, const std::function<bool(const Position&)>& condition)
{
  const auto is_removed = [&](const Triangle& t) {
    Position sum = Position::Zero();
    for (const pcl::index_t corner : t)
      sum += shape.vertices[static_cast<std::size_t>(corner)];
    return condition(sum / 3.0);
  };
  shape.triangles.erase(
      std::remove_if(shape.triangles.begin(), shape.triangles.end(), is_removed),
      shape.triangles.end());
  return shape;
}

/** \brief The triangles at a vertex of a closed shape, each next to the one before. */
inline std::vector<std::size_t>
trianglesAround(const ccaa::test::Shape& shape, pcl::index_t vertex)
{
  ccaa::TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  std::vector<std::size_t> around;
  pcl::index_t triangle = *adjacency.begin(vertex);
  do {
    around.push_back(static_cast<std::size_t>(triangle));
    const Triangle& corners = shape.triangles[around.back()];
    const auto corner = static_cast<int>(
        std::find(corners.begin(), corners.end(), vertex) - corners.begin());
    triangle =
        adjacency.across(triangle, corner); // over the edge that leaves the vertex
  }
  while (static_cast<std::size_t>(triangle) != around.front());
  return around;
}

/** \brief A sphere of 1280 triangles in which so many holes, three at most, of a
 * triangle each meet in the vertex with six triangles that comes first. */
inline ccaa::test::Shape
pinchedSphere(std::size_t holes)
{
  const ccaa::test::Shape sphere = ccaa::test::icosphere(3);
  pcl::index_t vertex = 0;
  while (trianglesAround(sphere, vertex).size() != 6)
    ++vertex;
  const std::vector<std::size_t> around = trianglesAround(sphere, vertex);
  std::vector<std::size_t> removed;
  for (std::size_t i = 0; i < holes; ++i)
    removed.push_back(around[2 * i]);
  std::sort(removed.begin(), removed.end());
  return withoutTriangles(sphere, removed);
}

/** \brief A flat square with a hole of a triangle that meets the outer border. */
inline ccaa::test::Shape
pinchedBorder()
{
  ccaa::test::Shape shape = ccaa::test::grid(8, 8);
  const auto meets = [](const Triangle& t) {
    const auto on_border = std::count_if(t.begin(), t.end(), [](pcl::index_t v) {
      return v % 8 == 0 || v % 8 == 7 || v / 8 == 0 || v / 8 == 7;
    });
    return on_border == 1;
  };
  shape.triangles.erase(
      std::find_if(shape.triangles.begin(), shape.triangles.end(), meets));
  return shape;
}

/** \brief A shape as it is read. */
inline IncompleteModel
readingOf(const ccaa::test::Shape& shape)
{
  return readModel(pcl::make_shared<pcl::PolygonMesh>(ccaa::test::toPolygonMesh(shape)),
                   nullptr,
                   ccaa::LoopContext())
      .model;
}

/** \brief Two levels, the second one lower, joined by a cliff that lacks its middle. */
inline ccaa::test::Shape
brokenCliff(double height)
{
  ccaa::test::Shape shape =
      without(ccaa::test::grid(24, 24), [](const Position& center) {
        return center.x() > 11.0 && center.x() < 12.0 &&
               std::abs(center.y() - 12.0) < 5.0;
      });
  for (Position& vertex : shape.vertices)
    if (vertex.x() > 11.5)
      vertex.z() -= height;
  return shape;
}

} // namespace pcl::repair::test
