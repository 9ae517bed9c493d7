// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the part of the mesh facts that needs no positions.
#include "mesh/mesh_topology.h"

#include "mesh/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl::ccaa {
namespace {

constexpr std::uint32_t NO_LOOP = std::numeric_limits<std::uint32_t>::max();

/** \brief One triangle's use of an edge. Corners are numbered 3 * triangle + 0, 1, 2;
 * the edge runs from its corner to the next one of the triangle. */
struct EdgeUse {
  pcl::index_t low;
  pcl::index_t high;
  std::uint32_t corner;
  bool upward; /**< runs from the lower vertex to the higher one */
};

std::uint32_t
nextCorner(std::uint32_t corner)
{
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

std::vector<EdgeUse>
sortedEdgeUses(const Triangles& triangles)
{
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const pcl::index_t from = triangles[i][k], to = triangles[i][(k + 1) % 3];
      uses.push_back({std::min(from, to),
                      std::max(from, to),
                      static_cast<std::uint32_t>(3 * i + k),
                      from < to});
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    if (a.low != b.low)
      return a.low < b.low;
    return a.high != b.high ? a.high < b.high : a.corner < b.corner;
  });
  return uses;
}

/** \brief Collects what the edges tell, one edge after the other. */
class TopologyCounter {
public:
  TopologyCounter(const Triangles& triangles, MeshFacts& facts)
  : triangles_(triangles)
  , facts_(facts)
  , components_(triangles.size())
  , sides_(2 * triangles.size())
  , fans_(3 * triangles.size())
  , at_rim_(facts.vertices, 0)
  {}

  void
  countEdges(const std::vector<EdgeUse>& uses)
  {
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
      while (end < uses.size() && uses[end].low == uses[begin].low &&
             uses[end].high == uses[begin].high)
        ++end;
      for (std::size_t i = begin + 1; i < end; ++i)
        joinOverEdge(uses[i - 1], uses[i]);
      countEdge(&uses[begin], end - begin);
    }
  }

  void
  countComponents()
  {
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
      facts_.components += components_.isRoot(i) ? 1u : 0u;
      if (sides_.find(i) == sides_.find(i + triangles_.size()))
        facts_.orientable = false;
    }
  }

  void
  countVertices()
  {
    std::vector<std::uint32_t> fan_counts(facts_.vertices, 0);
    for (std::size_t corner = 0; corner < 3 * triangles_.size(); ++corner)
      if (fans_.isRoot(corner))
        ++fan_counts[vertexAt(corner)];
    for (std::size_t i = 0; i < fan_counts.size(); ++i) {
      facts_.used_vertices += fan_counts[i] > 0 ? 1u : 0u;
      facts_.non_manifold_vertices += fan_counts[i] > 1 ? 1u : 0u;
      facts_.internal_vertices += fan_counts[i] == 1 && at_rim_[i] == 0 ? 1u : 0u;
    }
    facts_.boundary_vertices = facts_.used_vertices - facts_.internal_vertices;
    facts_.free_vertices = facts_.vertices - facts_.used_vertices;
  }

  /** \brief Boundary edges whose ends lie in the same fan follow each other. */
  void
  countLoops(const PointView& positions)
  {
    DisjointSets loops(rim_.size());
    std::vector<std::uint32_t> first_at_fan(3 * triangles_.size(), NO_LOOP);
    for (std::size_t i = 0; i < rim_.size(); ++i)
      for (const std::uint32_t corner : {rim_[i].corner, nextCorner(rim_[i].corner)}) {
        std::uint32_t& first = first_at_fan[fans_.find(corner)];
        if (first == NO_LOOP)
          first = static_cast<std::uint32_t>(i);
        loops.join(first, i);
      }
    std::vector<BoundaryLoopFacts> sums(rim_.size());
    for (std::size_t i = 0; i < rim_.size(); ++i) {
      BoundaryLoopFacts& loop = sums[loops.find(i)];
      const double length = (positions[rim_[i].high] - positions[rim_[i].low]).norm();
      ++loop.edges;
      loop.length += std::isfinite(length) ? length : 0.0;
    }
    for (const BoundaryLoopFacts& loop : sums)
      if (loop.edges > 0)
        facts_.boundary_loops.push_back(loop);
    std::stable_sort(facts_.boundary_loops.begin(),
                     facts_.boundary_loops.end(),
                     [](const BoundaryLoopFacts& a, const BoundaryLoopFacts& b) {
                       return a.edges != b.edges ? a.edges > b.edges
                                                 : a.length > b.length;
                     });
  }

private:
  std::size_t
  vertexAt(std::size_t corner) const
  {
    return static_cast<std::size_t>(triangles_[corner / 3][corner % 3]);
  }

  /** \brief Two triangles on an edge belong to one component, and at both ends of the
   * edge to one fan. */
  void
  joinOverEdge(const EdgeUse& a, const EdgeUse& b)
  {
    const bool same = a.upward == b.upward;
    const std::uint32_t b_next = nextCorner(b.corner);
    components_.join(a.corner / 3, b.corner / 3);
    fans_.join(a.corner, same ? b.corner : b_next);
    fans_.join(nextCorner(a.corner), same ? b_next : b.corner);
  }

  void
  countEdge(const EdgeUse* uses, std::size_t count)
  {
    ++facts_.edges;
    if (count == 2)
      countManifoldEdge(uses[0], uses[1]);
    else
      at_rim_[static_cast<std::size_t>(uses->low)] =
          at_rim_[static_cast<std::size_t>(uses->high)] = 1;
    if (count == 1)
      rim_.push_back(*uses);
    if (count > 2)
      ++facts_.non_manifold_edges;
    facts_.boundary_edges = rim_.size();
  }

  /** \brief Which side of a goes with which side of b: sides i and i + n are the front
   * and the back of triangle i. Both in one set: the surface is one-sided. */
  void
  countManifoldEdge(const EdgeUse& a, const EdgeUse& b)
  {
    const bool same = a.upward == b.upward;
    const std::size_t n = triangles_.size(), i = a.corner / 3, j = b.corner / 3;
    facts_.misoriented_edges += same ? 1u : 0u;
    sides_.join(i, same ? j + n : j);
    sides_.join(i + n, same ? j : j + n);
  }

  const Triangles& triangles_;
  MeshFacts& facts_;
  DisjointSets components_;
  DisjointSets sides_;
  DisjointSets fans_;
  std::vector<unsigned char> at_rim_; /**< of vertex: an edge has not two triangles */
  std::vector<EdgeUse> rim_;
};

} // namespace

void
measureTopology(const Triangles& valid_triangles,
                const PointView& positions,
                MeshFacts& facts)
{
  TopologyCounter counter(valid_triangles, facts);
  counter.countEdges(sortedEdgeUses(valid_triangles));
  counter.countComponents();
  counter.countVertices();
  counter.countLoops(positions);
  facts.euler_characteristic = static_cast<long>(facts.used_vertices) -
                               static_cast<long>(facts.edges) +
                               static_cast<long>(valid_triangles.size());
  if (facts.triangles > 0 && facts.non_manifold_edges == 0 &&
      facts.non_manifold_vertices == 0 && facts.orientable)
    facts.genus =
        static_cast<long>(facts.components) -
        (facts.euler_characteristic + static_cast<long>(facts.boundary_loops.size())) /
            2;
}

} // namespace pcl::ccaa
