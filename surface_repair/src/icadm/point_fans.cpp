// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: fans that touch in one point, taken apart.

#include "icadm/point_fans.h"

#include <algorithm>
#include <cstddef>

namespace pcl::repair {

namespace {

/** Takes the fans at one vertex after the other apart. */
class FanSeparation {
public:
  FanSeparation(const ccaa::Triangles& triangles,
                const ccaa::TriangleAdjacency& adjacency,
                const ChangedEdges& changed)
  : given_(triangles), adjacency_(adjacency), changed_(changed), result_{triangles, {}}
  {}

  PointFans
  run()
  {
    std::vector<bool> is_suspect(adjacency_.vertexCount(), false);
    for (const auto& [edge, neighbor] : changed_)
      for (const int corner : {edge.second, (edge.second + 1) % 3})
        is_suspect[static_cast<std::size_t>(cornerOf(edge.first, corner))] = true;
    for (std::size_t v = 0; v < is_suspect.size(); ++v) {
      const auto vertex = static_cast<pcl::index_t>(v);
      const ccaa::Fan fan = adjacency_.fan(vertex);
      if (is_suspect[v] || fan == ccaa::Fan::SEVERAL || fan == ccaa::Fan::OVERFULL)
        separateAt(vertex);
    }
    return std::move(result_);
  }

private:
  pcl::index_t
  cornerOf(pcl::index_t triangle, int corner) const
  {
    return given_[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(corner)];
  }

  pcl::index_t
  across(pcl::index_t triangle, int corner) const
  {
    const auto found =
        changed_.empty() ? changed_.end() : changed_.find({triangle, corner});
    return found == changed_.end() ? adjacency_.across(triangle, corner)
                                   : found->second;
  }

  void
  separateAt(pcl::index_t vertex)
  {
    const pcl::index_t* begin = adjacency_.begin(vertex);
    const pcl::index_t* end = adjacency_.end(vertex);
    is_done_.assign(static_cast<std::size_t>(end - begin), false);
    for (const pcl::index_t* first = begin; first != end; ++first) {
      if (is_done_[static_cast<std::size_t>(first - begin)])
        continue;
      collectFan(*first, vertex);
      if (first != begin)
        giveVertex(vertex);
    }
  }

  /** The triangles at a vertex that edges at the vertex connect to one of them. */
  void
  collectFan(pcl::index_t first, pcl::index_t vertex)
  {
    fan_.clear();
    add(first, vertex);
    for (std::size_t i = 0; i < fan_.size(); ++i)
      for (int corner = 0; corner < 3; ++corner) {
        const pcl::index_t triangle = fan_[i];
        if (cornerOf(triangle, corner) != vertex &&
            cornerOf(triangle, (corner + 1) % 3) != vertex)
          continue;
        const pcl::index_t next = across(triangle, corner);
        if (next >= 0)
          add(next, vertex);
      }
  }

  void
  add(pcl::index_t triangle, pcl::index_t vertex)
  {
    const pcl::index_t* begin = adjacency_.begin(vertex);
    const auto place = static_cast<std::size_t>(
        std::lower_bound(begin, adjacency_.end(vertex), triangle) - begin);
    if (is_done_[place])
      return;
    is_done_[place] = true;
    fan_.push_back(triangle);
  }

  void
  giveVertex(pcl::index_t vertex)
  {
    const auto own =
        static_cast<pcl::index_t>(adjacency_.vertexCount() + result_.vertices.size());
    result_.vertices.push_back(vertex);
    for (const pcl::index_t triangle : fan_) {
      auto& corners = result_.triangles[static_cast<std::size_t>(triangle)];
      std::replace(corners.begin(), corners.end(), vertex, own);
    }
  }

  const ccaa::Triangles& given_;
  const ccaa::TriangleAdjacency& adjacency_;
  const ChangedEdges& changed_;
  PointFans result_;
  std::vector<bool> is_done_;     /**< of each triangle at the vertex */
  std::vector<pcl::index_t> fan_; /**< at the vertex */
};

} // namespace

PointFans
separateFans(const ccaa::Triangles& triangles,
             const ccaa::TriangleAdjacency& adjacency,
             const ChangedEdges& changed)
{
  return FanSeparation(triangles, adjacency, changed).run();
}

} // namespace pcl::repair
