// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: models and their boundaries for the tests of this room.
#pragma once

#include <pcl/surface_repair/boundary/extraction.h>
#include <pcl/surface_repair/icadm/model_assembly.h>

#include "support/shapes.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace pcl {
namespace repair {
namespace test {

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

} // namespace test
} // namespace repair
} // namespace pcl
