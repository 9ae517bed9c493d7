// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges and sets for the checks of meshes: slow and simple on
// purpose, and nothing of the library's.
#pragma once

#include "shapes.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl::ccaa::test {

using Edge = std::pair<index_t, index_t>; /**< the lower end first */

/** \brief The edge from corner k to the next one. */
inline Edge
edgeOf(const Triangle& triangle, std::size_t k)
{
  return std::minmax(triangle[k], triangle[(k + 1) % 3]);
}

/** \brief Triangles of each edge. */
inline std::map<Edge, std::vector<std::size_t>>
trianglesOfEdges(const Triangles& triangles)
{
  std::map<Edge, std::vector<std::size_t>> triangles_of;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      triangles_of[edgeOf(triangles[t], k)].push_back(t);
  return triangles_of;
}

/** \brief Sets of the numbers below a count, which can be joined. */
class Sets {
public:
  explicit Sets(std::size_t count) : parent_(count)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /** \brief The lowest number of the set. */
  std::size_t
  find(std::size_t i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void
  join(std::size_t a, std::size_t b)
  {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::size_t> parent_;
};

} // namespace pcl::ccaa::test
