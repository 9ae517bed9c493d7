// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closed pieces of a surface that touch others.
#include "mesh/contacts.h"

#include "mesh/box_tree.h"
#include "mesh/disjoint_sets.h"
#include "mesh/islands.h"
#include "mesh/near_pairs.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {
namespace {

class ContactSearch {
public:
  ContactSearch(const Triangles& triangles, const PointView& points)
  : triangles_(triangles), points_(points)
  {}

  std::vector<Contact>
  run(const TriangleAdjacency& adjacency, const LoopContext& context)
  {
    pieces_ = labelIslands(adjacency, context);
    if (pieces_.count < 2)
      return {};
    measure(adjacency);
    if (std::find(is_closed_.begin(), is_closed_.end(), 1) == is_closed_.end())
      return {};
    return search(candidates());
  }

private:
  /** Piece and mean edge length of each point, box of each piece, and whether it is
   * closed. */
  void
  measure(const TriangleAdjacency& adjacency)
  {
    piece_of_.assign(points_.size(), -1);
    reach_.assign(points_.size(), 0.0);
    std::vector<std::uint32_t> edges(points_.size(), 0);
    is_closed_.assign(pieces_.count, 1);
    boxes_.assign(pieces_.count, Box());
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const auto from = static_cast<std::size_t>(triangles_[t][corner]);
        const auto to = static_cast<std::size_t>(triangles_[t][(corner + 1) % 3]);
        reach_[from] += (points_[to] - points_[from]).norm();
        ++edges[from];
        piece_of_[from] = pieces_.of_triangle[t];
        boxes_[pieces_[t]].extend(points_[from]);
        if (adjacency.across(static_cast<pcl::index_t>(t), static_cast<int>(corner)) <
            0)
          is_closed_[pieces_[t]] = 0;
      }
    std::vector<double> longest(pieces_.count, 0.0);
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (edges[v] > 0) {
        reach_[v] /= edges[v];
        double& most = longest[static_cast<std::size_t>(piece_of_[v])];
        most = std::max(most, reach_[v]);
      }
    for (std::size_t i = 0; i < pieces_.count; ++i)
      boxes_[i] = widened(boxes_[i], longest[i]);
  }

  /** Points within the box of another piece. */
  std::vector<pcl::index_t>
  candidates() const
  {
    const BoxTree tree(boxes_);
    std::vector<pcl::index_t> found;
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (piece_of_[v] != -1 &&
          tree.anyMeeting(widened(Box(points_[v], points_[v]), reach_[v]),
                          [&](pcl::index_t piece) { return piece != piece_of_[v]; }))
        found.push_back(static_cast<pcl::index_t>(v));
    return found;
  }

  std::vector<Contact>
  search(const std::vector<pcl::index_t>& candidates) const
  {
    std::vector<Contact> contacts;
    DisjointSets joined(pieces_.count);
    const auto pieceOf = [&](pcl::index_t v) {
      return static_cast<std::size_t>(piece_of_[static_cast<std::size_t>(v)]);
    };
    const auto reachOf = [&](pcl::index_t v) {
      return is_closed_[pieceOf(v)] == 0 ? 0.0 : reach_[static_cast<std::size_t>(v)];
    };
    forNearPairs(candidates, points_, reachOf, [&](pcl::index_t v, pcl::index_t other) {
      if (joined.find(pieceOf(v)) != joined.find(pieceOf(other)))
        contacts.push_back({v, other});
      joined.join(pieceOf(v), pieceOf(other));
    });
    return contacts;
  }

  const Triangles& triangles_;
  const PointView& points_;
  Islands pieces_;
  std::vector<pcl::index_t> piece_of_; /**< of a point; -1: none */
  std::vector<double> reach_;          /**< likewise: mean length of the edges at it */
  std::vector<std::uint8_t> is_closed_;
  std::vector<Box> boxes_; /**< of the pieces, with the greatest reach around them */
};

} // namespace

std::vector<Contact>
pieceContacts(const Triangles& triangles,
              const TriangleAdjacency& adjacency,
              const PointView& points,
              const LoopContext& context)
{
  return ContactSearch(triangles, points).run(adjacency, context);
}

} // namespace pcl::ccaa
