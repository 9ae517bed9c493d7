// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which parts of a surface are necks between others.
#include "mesh/neck_parts.h"

#include "mesh/corners.h"
#include "mesh/part_graph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace pcl::ccaa {
namespace {

/** What is wide has so many times the area of a disc as large as the loops that lead to
 * it: a sphere, if these are at most 0.8 of its radius wide. With three the ear of
 * Bunny in 1 900 points is joined by a neck, with six one of 16 pairs of bodies that
 * were glued is not told that is with three. */
constexpr double WIDE = 6.0;

/** Edges around an opening that connects what is beside it, as if it were closed: where
 * bodies are glued by a strip there are openings of up to 50 edges beside it. Where
 * none connects, five of ten scans of Bunny from one side have a neck. */
constexpr std::size_t CONNECTING = 64;

/** Nodes that are gone through to find what a part alone connects: in noise nothing may
 * be large. Of 33 pairs of bodies that were glued the same are told as without a limit.
 */
constexpr std::size_t MOST_NODES = 200;

/** Edges around a part, relative to a place near them. */
struct Rim {
  double length = 0.0;
  Position moment = Position::Zero();
  double squares = 0.0; /**< of distances */

  void
  add(const Position& from, const Position& to)
  {
    const double edge = (to - from).norm();
    const Position middle = 0.5 * (from + to);
    add({edge, edge * middle, edge * middle.squaredNorm()});
  }

  void
  add(const Rim& other)
  {
    length += other.length;
    moment += other.moment;
    squares += other.squares;
  }

  /** Of a disc whose rim is as far from its middle as these edges, which may go to and
   * fro: their length tells less. */
  double
  discArea() const
  {
    return length > 0.0 ? M_PI * (squares - moment.squaredNorm() / length) / length
                        : 0.0;
  }
};

/** What a part alone connects. */
struct Side {
  std::set<std::size_t> nodes;
  double area = 0.0;
  bool is_whole = true; /**< not if it has the largest component or too many nodes */
};

class NeckFinder {
public:
  NeckFinder(const Triangles& triangles, PartGraph& graph, const PointView& points)
  : graph_(graph)
  , points_(points)
  , areas_(graph.nodeCount(), 0.0)
  , pieces_(graph.nodeCount())
  {
    measure(triangles);
    for (const auto& [root, part] : graph_.parts())
      for (const std::size_t edge : part.cut_edges) {
        if (graph_.isBorder(edge))
          continue;
        const std::size_t component = graph_.nodeBehind(edge);
        beside_[component].insert(root);
        beside_[root].insert(component);
        pieces_.join(component, root);
      }
    for (std::size_t node = 0; node < areas_.size(); ++node)
      if (areas_[node] > 0.0)
        addTo(piece_at_[pieces_.find(node)], node);
  }

  bool
  isNeck(const PartGraph::Part& part)
  {
    std::map<std::size_t, Rim> rims; // towards a component
    const Position origin = points_[part.flagged];
    for (const std::size_t edge : part.cut_edges)
      if (!graph_.isBorder(edge))
        rims[graph_.nodeBehind(edge)].add(points_[graph_.startOf(edge)] - origin,
                                          points_[graph_.endOf(edge)] - origin);
    if (rims.size() < 2)
      return false;
    const Piece& piece = piece_at_[pieces_.find(part.root)];
    double left = piece.area - areas_[part.root]; // what is not gone through
    Rim to_left;
    while (!rims.empty()) {
      const Side side = sideOf(part, rims.begin()->first, piece.largest);
      const Rim rim = takeRims(side, rims);
      if (!side.is_whole)
        to_left.add(rim);
      else if (areBothWide(side.area, piece.area - side.area, rim))
        return true;
      else
        left -= side.area;
    }
    return to_left.length > 0.0 && areBothWide(left, piece.area - left, to_left);
  }

private:
  struct Piece {
    double area = 0.0;
    std::size_t largest = 0; /**< of its components */
    double largest_area = 0.0;
  };

  void
  measure(const Triangles& triangles)
  {
    const auto areaOf = [&](const Triangle& triangle) {
      return 0.5 * areaNormal(cornersOf(triangle, points_)).norm();
    };
    for (const Triangle& triangle : triangles)
      if (!graph_.isPart(triangle))
        areas_[graph_.nodeOf(triangle[0])] += areaOf(triangle);
    for (std::size_t i = 0; i < graph_.triangles().size(); ++i)
      areas_[graph_.nodeAt(i)] +=
          areaOf(triangles[static_cast<std::size_t>(graph_.triangles()[i])]);
  }

  bool
  isComponent(std::size_t node) const
  {
    return node >= graph_.triangles().size();
  }

  void
  addTo(Piece& piece, std::size_t node) const
  {
    piece.area += areas_[node];
    if (!isComponent(node) || areas_[node] <= piece.largest_area)
      return;
    piece.largest = node;
    piece.largest_area = areas_[node];
  }

  /** What is connected to a component without a part; nothing is looked for behind the
   * largest component: it is the side of most parts. */
  Side
  sideOf(const PartGraph::Part& part, std::size_t component, std::size_t largest)
  {
    Side side;
    std::vector<std::size_t> open{component};
    side.nodes.insert(component);
    while (!open.empty() && side.is_whole) {
      const std::size_t node = open.back();
      open.pop_back();
      side.is_whole = node != largest && side.nodes.size() <= MOST_NODES;
      side.area += areas_[node];
      for (const std::size_t next : beside_[node])
        if (next != part.root && side.nodes.insert(next).second)
          open.push_back(next);
    }
    return side;
  }

  /** The sum of those of a side, which are removed. */
  static Rim
  takeRims(const Side& side, std::map<std::size_t, Rim>& rims)
  {
    Rim sum;
    for (auto each = rims.begin(); each != rims.end();) {
      const bool is_among = side.nodes.count(each->first) > 0;
      if (is_among)
        sum.add(each->second);
      each = is_among ? rims.erase(each) : std::next(each);
    }
    return sum;
  }

  static bool
  areBothWide(double one, double other, const Rim& rim)
  {
    return std::min(one, other) >= WIDE * rim.discArea();
  }

  PartGraph& graph_;
  PointView points_;
  std::vector<double> areas_;                           /**< of nodes */
  DisjointSets pieces_;                                 /**< of nodes */
  std::map<std::size_t, std::set<std::size_t>> beside_; /**< of nodes */
  std::map<std::size_t, Piece> piece_at_;
};

} // namespace

std::vector<std::vector<pcl::index_t>>
neckParts(const Triangles& triangles,
          const TriangleAdjacency& adjacency,
          const PointView& points,
          const std::vector<std::uint8_t>& is_flagged,
          int threads)
{
  PartGraph graph(triangles, adjacency, is_flagged, threads);
  std::vector<std::vector<pcl::index_t>> necks;
  const auto mayBeNeck = [&](const PartGraph::Part& part) {
    return part.loops.size() > 1 ||
           std::any_of(part.cut_edges.begin(), part.cut_edges.end(), [&](auto edge) {
             return graph.isBorder(edge);
           });
  };
  if (std::none_of(graph.parts().begin(), graph.parts().end(), [&](const auto& entry) {
        return mayBeNeck(entry.second);
      }))
    return necks;
  graph.connectRest(CONNECTING);
  NeckFinder finder(triangles, graph, points);
  for (const auto& [root, part] : graph.parts())
    if (mayBeNeck(part) && finder.isNeck(part))
      necks.push_back(part.vertices);
  std::sort(necks.begin(), necks.end());
  return necks;
}

} // namespace pcl::ccaa
