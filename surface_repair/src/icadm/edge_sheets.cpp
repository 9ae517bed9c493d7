// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: surfaces that meet in an edge, taken apart.

#include "icadm/edge_sheets.h"

#include "mesh/winding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>
#include <utility>

namespace pcl::repair {

namespace {

/** More triangles on one edge are no sheets that meet. */
constexpr std::ptrdiff_t MOST_ON_EDGE = 32;
/** Bends are compared in steps of this (of their cosine), against rounding. */
constexpr double BEND_STEP = 1e-4;

/** Sheets that were found so far, and which triangles have to be turned for them. */
class Sheets {
public:
  Sheets(const Triangles& triangles, const ccaa::TriangleAdjacency& adjacency)
  : part_of_(ccaa::labelIslands(adjacency)), is_turned_(triangles.size(), 0)
  {
    std::vector<std::size_t> sizes(part_of_.count, 0);
    std::vector<std::size_t> turned(part_of_.count, 0);
    std::vector<bool> is_seen(triangles.size(), false);
    for (std::size_t seed = 0; seed < triangles.size(); ++seed)
      if (!is_seen[seed])
        windPart(static_cast<pcl::index_t>(seed), triangles, adjacency, is_seen);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      ++sizes[part_of_[t]];
      turned[part_of_[t]] += is_turned_[t];
    }
    for (std::size_t part = 0; part < part_of_.count; ++part)
      parts_.push_back({part, 2 * turned[part] > sizes[part]});
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (parts_[part_of_[t]].is_turned)
        is_turned_[t] ^= 1;
    for (Part& part : parts_)
      part.is_turned = false;
  }

  /** As most of its part is wound. */
  bool
  isTurned(pcl::index_t triangle) const
  {
    return is_turned_[static_cast<std::size_t>(triangle)] != 0;
  }

  /** Make two triangles neighbours over an edge.
   * \param[in] agree they run through it in opposite directions, turned as said
   * \return false where that would make their sheet one-sided */
  bool
  join(pcl::index_t first, pcl::index_t second, bool agree)
  {
    const Part a = find(first);
    const Part b = find(second);
    const bool differ = a.is_turned != b.is_turned;
    if (a.parent == b.parent)
      return differ != agree;
    parts_[std::max(a.parent, b.parent)] = {std::min(a.parent, b.parent),
                                            differ == agree};
    return true;
  }

private:
  /** Of disjoint sets, and whether it is turned against its parent. */
  struct Part {
    std::size_t parent;
    bool is_turned;
  };

  void
  windPart(pcl::index_t seed,
           const Triangles& triangles,
           const ccaa::TriangleAdjacency& adjacency,
           std::vector<bool>& is_seen)
  {
    std::vector<pcl::index_t> stack{seed};
    is_seen[static_cast<std::size_t>(seed)] = true;
    while (!stack.empty()) {
      const pcl::index_t t = stack.back();
      stack.pop_back();
      for (int corner = 0; corner < 3; ++corner) {
        const pcl::index_t other = adjacency.across(t, corner);
        if (other < 0 || is_seen[static_cast<std::size_t>(other)])
          continue;
        const bool turns = ccaa::disagreesAcross(triangles, adjacency, t, corner);
        is_turned_[static_cast<std::size_t>(other)] = static_cast<std::uint8_t>(
            is_turned_[static_cast<std::size_t>(t)] ^ (turns ? 1 : 0));
        is_seen[static_cast<std::size_t>(other)] = true;
        stack.push_back(other);
      }
    }
  }

  Part
  find(pcl::index_t triangle)
  {
    Part part{part_of_[static_cast<std::size_t>(triangle)], false};
    while (parts_[part.parent].parent != part.parent) {
      Part& link = parts_[part.parent];
      const Part& next = parts_[link.parent];
      link = {next.parent, link.is_turned != next.is_turned}; // shorter next time
      part = {link.parent, part.is_turned != link.is_turned};
    }
    return part;
  }

  ccaa::Islands part_of_;
  std::vector<std::uint8_t> is_turned_;
  std::vector<Part> parts_;
};

/** A triangle on an edge, and how it lies there. */
struct Wing {
  TriangleEdge edge;
  int is_single;    /**< nothing but edges of three triangles and more holds it */
  bool runs_upward; /**< from the lower vertex of the edge, turned as said */
  Eigen::Vector3d direction; /**< of the triangle, away from the edge; 0: no area */
  Eigen::Vector3d normal;    /**< turned as said, any length */
};

/** Two of them, the better ones first. */
struct WingPair {
  int singles;
  bool disagree;
  std::int64_t bend; /**< of the cosine: least for a flat pair */
  bool is_hollow;
  TriangleEdge first;
  TriangleEdge second;

  bool
  operator<(const WingPair& other) const
  {
    const auto key = [](const WingPair& p) {
      return std::tie(p.singles, p.disagree, p.bend, p.is_hollow, p.first, p.second);
    };
    return key(*this) < key(other);
  }
};

Wing
wingOf(pcl::index_t triangle,
       const ccaa::TriangleAdjacency::Edge& edge,
       const Triangles& triangles,
       const ccaa::TriangleAdjacency& adjacency,
       const Positions& positions,
       const Sheets& sheets)
{
  const Triangle& corners = triangles[static_cast<std::size_t>(triangle)];
  const auto place = [&](pcl::index_t vertex) -> const Position& {
    return positions[static_cast<std::size_t>(vertex)];
  };
  std::size_t opposite = 0;
  while (corners[opposite] == edge[0] || corners[opposite] == edge[1])
    ++opposite;
  Wing wing;
  wing.edge = {triangle, static_cast<int>((opposite + 1) % 3)};
  wing.is_single = 1;
  for (int corner = 0; corner < 3; ++corner)
    if (adjacency.across(triangle, corner) >= 0)
      wing.is_single = 0;
  const bool is_turned = sheets.isTurned(triangle);
  wing.runs_upward = (corners[(opposite + 1) % 3] == edge[0]) != is_turned;
  const Eigen::Vector3d along = (place(edge[1]) - place(edge[0])).normalized();
  const Eigen::Vector3d arm = place(corners[opposite]) - place(edge[0]);
  wing.direction = (arm - along * along.dot(arm)).normalized();
  wing.normal = along.cross(wing.direction) * (wing.runs_upward ? 1.0 : -1.0);
  return wing;
}

WingPair
pairOf(const Wing& a, const Wing& b)
{
  WingPair pair;
  pair.singles = a.is_single + b.is_single;
  pair.disagree = a.runs_upward == b.runs_upward;
  pair.bend = std::llround(a.direction.dot(b.direction) / BEND_STEP);
  pair.is_hollow = a.normal.dot(b.direction) > 0.0;
  pair.first = std::min(a.edge, b.edge);
  pair.second = std::max(a.edge, b.edge);
  return pair;
}

using VertexEdge = std::array<pcl::index_t, 2>;

VertexEdge
verticesOf(const TriangleEdge& edge, const Triangles& triangles)
{
  const Triangle& corners = triangles[static_cast<std::size_t>(edge.first)];
  const auto at = static_cast<std::size_t>(edge.second);
  const auto ends = std::minmax(corners[at], corners[(at + 1) % 3]);
  return {ends.first, ends.second};
}

/** Cuts along further edges until no two sheets come to the same one. */
class FurtherCuts {
public:
  FurtherCuts(const Triangles& triangles,
              const ccaa::TriangleAdjacency& adjacency,
              ChangedEdges changed)
  : triangles_(triangles), adjacency_(adjacency), changed_(std::move(changed))
  {}

  PointFans
  run()
  {
    for (;;) {
      PointFans split = separateFans(triangles_, adjacency_, changed_);
      const std::vector<TriangleEdge> crowded = crowdedEdges(split.triangles);
      if (crowded.empty())
        return split;
      for (const TriangleEdge& edge : crowded)
        cutFree(edge);
    }
  }

private:
  /** Both triangles of a pair, or the one that ends there, by the lowest. */
  pcl::index_t
  sheetOf(const TriangleEdge& edge) const
  {
    const pcl::index_t neighbor = changed_.at(edge);
    return neighbor >= 0 ? std::min(edge.first, neighbor) : edge.first;
  }

  /** Edges of the sheets but one, a pair if there is one, at each edge that several
   * sheets still have. */
  std::vector<TriangleEdge>
  crowdedEdges(const Triangles& split) const
  {
    std::vector<std::tuple<VertexEdge, bool, pcl::index_t, TriangleEdge>> sheets;
    for (const auto& [edge, neighbor] : changed_)
      sheets.emplace_back(verticesOf(edge, split), neighbor < 0, sheetOf(edge), edge);
    std::sort(sheets.begin(), sheets.end());
    std::vector<TriangleEdge> crowded;
    std::size_t first = 0;
    for (std::size_t i = 1; i < sheets.size(); ++i) {
      if (std::get<0>(sheets[i]) != std::get<0>(sheets[first]))
        first = i;
      else if (std::get<2>(sheets[i]) != std::get<2>(sheets[first]))
        crowded.push_back(std::get<3>(sheets[i]));
    }
    return crowded;
  }

  /** Part a triangle from its sheet beside one end of an edge. */
  void
  cutFree(const TriangleEdge& edge)
  {
    const pcl::index_t vertex = verticesOf(edge, triangles_)[0];
    for (int corner = 0; corner < 3; ++corner) {
      const TriangleEdge beside{edge.first, corner};
      const VertexEdge ends = verticesOf(beside, triangles_);
      if (corner != edge.second && (ends[0] == vertex || ends[1] == vertex))
        cut(beside);
    }
  }

  void
  cut(const TriangleEdge& edge)
  {
    const auto found = changed_.find(edge);
    const pcl::index_t other = found != changed_.end()
                                   ? found->second
                                   : adjacency_.across(edge.first, edge.second);
    changed_[edge] = ccaa::TriangleAdjacency::NONE;
    if (other < 0)
      return;
    const VertexEdge ends = verticesOf(edge, triangles_);
    for (int corner = 0; corner < 3; ++corner)
      if (verticesOf({other, corner}, triangles_) == ends)
        changed_[{other, corner}] = ccaa::TriangleAdjacency::NONE;
  }

  const Triangles& triangles_;
  const ccaa::TriangleAdjacency& adjacency_;
  ChangedEdges changed_;
};

} // namespace

ChangedEdges
pairSheets(const Triangles& triangles,
           const ccaa::TriangleAdjacency& adjacency,
           const Positions& positions)
{
  ChangedEdges changed;
  if (adjacency.overfullEdges().empty())
    return changed;
  Sheets sheets(triangles, adjacency);
  std::vector<WingPair> pairs;
  for (std::size_t e = 0; e < adjacency.overfullEdges().size(); ++e) {
    std::vector<Wing> wings;
    for (const auto* t = adjacency.beginOverfull(e); t != adjacency.endOverfull(e); ++t)
      wings.push_back(wingOf(
          *t, adjacency.overfullEdges()[e], triangles, adjacency, positions, sheets));
    const bool are_sheets =
        adjacency.endOverfull(e) - adjacency.beginOverfull(e) <= MOST_ON_EDGE;
    for (std::size_t i = 0; i < wings.size(); ++i) {
      changed[wings[i].edge] = ccaa::TriangleAdjacency::NONE;
      for (std::size_t k = i + 1; are_sheets && k < wings.size(); ++k)
        pairs.push_back(pairOf(wings[i], wings[k]));
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const WingPair& pair : pairs) {
    pcl::index_t& first = changed[pair.first];
    pcl::index_t& second = changed[pair.second];
    if (first < 0 && second < 0 &&
        sheets.join(pair.first.first, pair.second.first, !pair.disagree)) {
      first = pair.second.first;
      second = pair.first.first;
    }
  }
  return changed;
}

PointFans
cutAtFaults(const Triangles& triangles,
            const ccaa::TriangleAdjacency& adjacency,
            const Positions& positions)
{
  return FurtherCuts(triangles, adjacency, pairSheets(triangles, adjacency, positions))
      .run();
}

} // namespace pcl::repair
