// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges along which surfaces touch without being joined.

#pragma once

#include "icadm/incomplete_model.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace pcl::repair {

/** \brief Edges between two points of the cloud that are edges between different
 * vertices: surfaces touch along them, or the mesh was cut there. */
class Seams {
public:
  explicit Seams(const IncompleteModel& model)
  {
    const std::vector<bool> is_shared = sharedPoints(model);
    if (is_shared.empty())
      return;
    std::vector<std::array<pcl::index_t, 4>> edges; // points, then their vertices
    for (const Triangle& triangle : model.triangles)
      for (std::size_t c = 0; c < 3; ++c) {
        pcl::index_t a = triangle[c];
        pcl::index_t b = triangle[(c + 1) % 3];
        if (pointOf(model, a) > pointOf(model, b))
          std::swap(a, b);
        if (isIn(is_shared, pointOf(model, a)) && isIn(is_shared, pointOf(model, b)))
          edges.push_back({pointOf(model, a), pointOf(model, b), a, b});
      }
    std::sort(edges.begin(), edges.end());
    for (std::size_t i = 1; i < edges.size(); ++i) {
      const auto& [from, to, a, b] = edges[i];
      if (edges[i - 1][0] != from || edges[i - 1][1] != to || edges[i - 1] == edges[i])
        continue;
      edges_.insert({from, to});
      points_.insert(from);
      points_.insert(to);
    }
  }

  bool
  containPoint(pcl::index_t point) const
  {
    return points_.count(point) > 0;
  }

  bool
  containEdge(pcl::index_t a, pcl::index_t b) const
  {
    return edges_.count(std::minmax(a, b)) > 0;
  }

  static pcl::index_t
  pointOf(const IncompleteModel& model, pcl::index_t vertex)
  {
    const auto place = static_cast<std::size_t>(vertex);
    return place < model.point_of_vertex.size() ? model.point_of_vertex[place]
                                                : pcl::UNAVAILABLE;
  }

private:
  /** \brief Of each point: several vertices have it; empty if none is. */
  static std::vector<bool>
  sharedPoints(const IncompleteModel& model)
  {
    std::vector<bool> is_used;
    std::vector<bool> is_shared;
    for (const pcl::index_t point : model.point_of_vertex) {
      if (point == pcl::UNAVAILABLE)
        continue;
      const auto place = static_cast<std::size_t>(point);
      if (place >= is_used.size())
        is_used.resize(2 * place + 1, false);
      if (is_used[place]) {
        is_shared.resize(std::max(is_shared.size(), place + 1), false);
        is_shared[place] = true;
      }
      is_used[place] = true;
    }
    return is_shared;
  }

  static bool
  isIn(const std::vector<bool>& points, pcl::index_t point)
  {
    return point >= 0 && static_cast<std::size_t>(point) < points.size() &&
           points[static_cast<std::size_t>(point)];
  }

  std::set<std::pair<pcl::index_t, pcl::index_t>> edges_;
  std::set<pcl::index_t> points_;
};

} // namespace pcl::repair
