// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges of a patch that have next to no length.

#include "fairing/edge_collapse.h"

#include "fairing/vertex_triangles.h"
#include "mesh/corners.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace pcl::repair {

namespace {

/** Of the mean edge: what is shorter. Meshes whose density varies 20-fold have none. */
constexpr double SHORTEST = 0.002;

using Vertices = std::set<std::size_t>;

/** Collapses edges of triangles that are not put in order meanwhile. */
class Collapsing {
public:
  explicit Collapsing(Patch& patch)
  : patch_(patch)
  , around_(patch.triangles, patch.positions.size())
  , is_there_(patch.triangles.size(), true)
  , is_gone_(patch.positions.size(), false)
  {}

  /** \return how many went */
  std::size_t
  pass(double shortest)
  {
    std::vector<std::tuple<double, std::size_t, std::size_t>> found;
    for (std::size_t t = 0; t < patch_.triangles.size(); ++t)
      for (std::size_t c = 0; is_there_[t] && c < 3; ++c) {
        const std::size_t a = corner(t, c), b = corner(t, (c + 1) % 3);
        const double length = (patch_.positions[a] - patch_.positions[b]).norm();
        if (a < b && length < shortest && !patch_.isHeld(a) && !patch_.isHeld(b))
          found.emplace_back(length, a, b);
      }
    std::sort(found.begin(), found.end());
    std::size_t gone = 0;
    for (const auto& [length, kept, other] : found)
      if (!is_gone_[kept] && !is_gone_[other] && mayCollapse(kept, other)) {
        collapse(kept, other);
        ++gone;
      }
    return gone;
  }

  void
  finish()
  {
    patch_ = keepTriangles(patch_, is_there_);
  }

private:
  std::size_t
  corner(std::size_t triangle, std::size_t c) const
  {
    return static_cast<std::size_t>(patch_.triangles[triangle][c]);
  }

  std::vector<std::size_t>
  trianglesAt(std::size_t vertex) const
  {
    if (const auto changed = changed_.find(vertex); changed != changed_.end())
      return changed->second;
    return {around_.begin(vertex), around_.end(vertex)};
  }

  Vertices
  neighborsOf(std::size_t vertex) const
  {
    Vertices neighbors;
    for (const std::size_t triangle : trianglesAt(vertex))
      for (std::size_t c = 0; is_there_[triangle] && c < 3; ++c)
        neighbors.insert(corner(triangle, c));
    neighbors.erase(vertex);
    return neighbors;
  }

  /** The link condition: the surface stays a manifold of the same topology. */
  bool
  mayCollapse(std::size_t a, std::size_t b) const
  {
    const Vertices one = neighborsOf(a), other = neighborsOf(b);
    std::vector<std::size_t> common;
    std::set_intersection(
        one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(common));
    return one.count(b) > 0 && common.size() == 2 && one.size() + other.size() > 6;
  }

  void
  collapse(std::size_t kept, std::size_t other)
  {
    std::vector<std::size_t> triangles = trianglesAt(kept);
    for (const std::size_t t : trianglesAt(other)) {
      Triangle& triangle = patch_.triangles[t];
      if (std::find(triangles.begin(), triangles.end(), t) != triangles.end()) {
        is_there_[t] = false;
        continue;
      }
      std::replace(triangle.begin(),
                   triangle.end(),
                   static_cast<pcl::index_t>(other),
                   static_cast<pcl::index_t>(kept));
      triangles.push_back(t);
    }
    changed_[kept] = std::move(triangles);
    is_gone_[other] = true;
  }

  Patch& patch_;
  VertexTriangles around_;
  std::map<std::size_t, std::vector<std::size_t>> changed_; /**< vertices' triangles */
  std::vector<bool> is_there_;                              /**< of triangles */
  std::vector<bool> is_gone_;                               /**< of vertices */
};

} // namespace

std::size_t
collapseShortEdges(Patch& patch)
{
  if (patch.triangles.empty())
    return 0;
  const double shortest =
      SHORTEST *
      ccaa::meanEdge(patch.triangles, patch.triangles.size(), patch.positions);
  Collapsing collapsing(patch);
  std::size_t gone = 0;
  for (std::size_t more = 1; more > 0; gone += more)
    more = collapsing.pass(shortest);
  if (gone > 0)
    collapsing.finish();
  return gone;
}

} // namespace pcl::repair
