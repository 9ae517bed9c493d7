// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: through which parts of a surface its handles pass.
#include "mesh/handle_places.h"

#include "mesh/disjoint_sets.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <map>

namespace pcl::ccaa {
namespace {

/** Parts of a surface, and what lies between them: the rest, connected by its vertices,
 * also along where the surface ends, as if closed there. So each loop around a part
 * leads to one component of the rest. An edge of a triangle is 3 t + corner from which
 * it leads. */
class PartGraph {
public:
  PartGraph(const Triangles& triangles,
            const TriangleAdjacency& adjacency,
            const std::vector<std::uint8_t>& is_flagged)
  : triangles_(triangles)
  , adjacency_(adjacency)
  , is_flagged_(is_flagged)
  , inside_(triangles.size())
  , loops_(3 * triangles.size())
  , outside_(is_flagged.size())
  {
    for (const Triangle& triangle : triangles)
      is_part_.push_back(std::any_of(triangle.begin(),
                                     triangle.end(),
                                     [&](auto corner) { return isFlagged(corner); }));
    for (std::size_t edge = 0; edge < 3 * triangles.size(); ++edge) {
      if (!is_part_[edge / 3] || !hasAcross(edge))
        outside_.join(std::size_t(startOf(edge)), std::size_t(startOf(after(edge))));
      if (is_part_[edge / 3] && isCut(edge))
        loops_.join(edge, nextCut(edge));
      else if (is_part_[edge / 3])
        inside_.join(edge / 3, across(edge));
    }
    gatherParts();
  }

  std::vector<pcl::index_t>
  handlePlaces()
  {
    std::vector<const Part*> order;
    for (const auto& [root, part] : parts_)
      order.push_back(&part);
    std::stable_sort(order.begin(), order.end(), [](const Part* a, const Part* b) {
      return a->triangles > b->triangles;
    });
    DisjointSets nodes(triangles_.size() + is_flagged_.size());
    std::vector<pcl::index_t> places;
    for (const Part* part : order) {
      bool has_handle = part->genus() > 0;
      for (const std::size_t loop : part->loops) {
        const std::size_t rest =
            triangles_.size() + outside_.find(std::size_t(startOf(loop)));
        has_handle = has_handle || nodes.find(part->root) == nodes.find(rest);
        nodes.join(part->root, rest);
      }
      if (has_handle)
        places.push_back(part->flagged);
    }
    std::sort(places.begin(), places.end());
    return places;
  }

private:
  struct Part {
    std::size_t root = 0;
    pcl::index_t flagged = -1; /**< the lowest one */
    std::size_t triangles = 0, cut_edges = 0;
    std::vector<pcl::index_t> vertices, cut_vertices;
    std::vector<std::size_t> loops; /**< an edge of each */

    /** Of 2 - 2 g = V - E + F + loops. A vertex at which several fans of the part meet
     * counts for each: as often as cut edges lead from it. */
    long
    genus() const
    {
      const std::size_t corners = vertices.size() - cut_vertices.size() + cut_edges;
      const std::size_t edges = (3 * triangles + cut_edges) / 2;
      return 1 - (static_cast<long>(corners + triangles + loops.size()) -
                  static_cast<long>(edges)) /
                     2;
    }
  };

  bool
  isFlagged(pcl::index_t vertex) const
  {
    return is_flagged_[static_cast<std::size_t>(vertex)] != 0;
  }

  static std::size_t
  after(std::size_t edge)
  {
    return edge % 3 == 2 ? edge - 2 : edge + 1;
  }

  pcl::index_t
  startOf(std::size_t edge) const
  {
    return triangles_[edge / 3][edge % 3];
  }

  bool
  hasAcross(std::size_t edge) const
  {
    return adjacency_.across(static_cast<pcl::index_t>(edge / 3), int(edge % 3)) >= 0;
  }

  std::size_t
  across(std::size_t edge) const
  {
    return static_cast<std::size_t>(
        adjacency_.across(static_cast<pcl::index_t>(edge / 3), int(edge % 3)));
  }

  /** Whether it is one between a part and the rest, or the surface ends there. */
  bool
  isCut(std::size_t edge) const
  {
    return !hasAcross(edge) || is_part_[edge / 3] != is_part_[across(edge)];
  }

  /** The cut edge that follows around the same part. */
  std::size_t
  nextCut(std::size_t edge) const
  {
    for (edge = after(edge); !isCut(edge);) {
      const pcl::index_t vertex = startOf(edge);
      const std::size_t t = across(edge);
      edge = 3 * t + static_cast<std::size_t>(cornerOf(triangles_[t], vertex));
    }
    return edge;
  }

  void
  gatherParts()
  {
    for (std::size_t edge = 0; edge < 3 * triangles_.size(); ++edge) {
      if (!is_part_[edge / 3])
        continue;
      Part& part = parts_[inside_.find(edge / 3)];
      part.triangles += edge % 3 == 0 ? 1 : 0;
      part.vertices.push_back(startOf(edge));
      if (!isCut(edge))
        continue;
      ++part.cut_edges;
      part.cut_vertices.push_back(startOf(edge));
      part.loops.push_back(loops_.find(edge));
    }
    for (auto& [root, part] : parts_) {
      part.root = root;
      sortUnique(part.vertices);
      sortUnique(part.cut_vertices);
      sortUnique(part.loops);
      part.flagged = *std::find_if(part.vertices.begin(),
                                   part.vertices.end(),
                                   [&](pcl::index_t v) { return isFlagged(v); });
    }
  }

  const Triangles& triangles_;
  const TriangleAdjacency& adjacency_;
  const std::vector<std::uint8_t>& is_flagged_;
  std::vector<bool> is_part_;
  DisjointSets inside_;  /**< triangles: the parts */
  DisjointSets loops_;   /**< edges around these */
  DisjointSets outside_; /**< vertices: the components of the rest */
  std::map<std::size_t, Part> parts_;
};

} // namespace

std::vector<pcl::index_t>
handlePlaces(const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const std::vector<std::uint8_t>& is_flagged)
{
  return PartGraph(triangles, adjacency, is_flagged).handlePlaces();
}

} // namespace pcl::ccaa
