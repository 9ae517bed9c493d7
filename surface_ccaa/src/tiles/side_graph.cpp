// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the outer side of surfaces that run through many tiles.
#include "tiles/side_graph.h"

#include "mesh/corners.h"
#include "mesh/label_votes.h"
#include "mesh/outward_votes.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Volume that a surface has over its own centroid, as a share of (twice its area)^1.5:
 * 0.07 for a half sphere; below this it is flat, or curved both ways. */
constexpr double LEAST_BULGE = 0.005;

/** An edge as one of the tiles has it. */
struct Half {
  const CutEdge* edge;
  std::size_t tile;
  pcl::index_t label;
};

/** An edge that two pieces have. */
struct Common {
  std::array<WideIndex, 2> ends;
  std::array<pcl::index_t, 2> labels;
  bool is_against; /**< wound as they are, the pieces do not agree */
};

class SideGraph {
public:
  explicit SideGraph(const std::vector<TilePieces>& tiles) : tiles_(tiles)
  {
    for (const TilePieces& tile : tiles) {
      first_.push_back(static_cast<pcl::index_t>(sums_.size()));
      for (const SideSums& sums : tile.sums) {
        sums_.push_back(sums);
        labels_.add();
      }
    }
  }

  Sides
  decide(bool guess_plane)
  {
    joinPieces();
    std::vector<SideSums> whole(sums_.size());
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const pcl::index_t state = rootOf(i);
      whole[static_cast<std::size_t>(state >> 1)].add(sums_[i], signOf(state));
    }
    const int axis = guess_plane ? planeAxis() : -1;
    std::vector<std::uint8_t> turn(sums_.size(), 0);
    std::vector<std::uint64_t> number(sums_.size(), 0);
    for (std::size_t i = 0; i < sums_.size(); ++i)
      if (static_cast<std::size_t>(rootOf(i) >> 1) == i) {
        number[i] = sides_.components;
        turn[i] = settle(whole[i], axis);
      }
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
      sides_.doubts.add(tiles_[tile].doubts);
      sides_.turn.emplace_back();
      sides_.components_of.emplace_back();
      for (std::size_t piece = 0; piece < tiles_[tile].sums.size(); ++piece) {
        const auto i = static_cast<std::size_t>(first_[tile]) + piece;
        const pcl::index_t state = rootOf(i);
        const bool is_turned = turn[static_cast<std::size_t>(state >> 1)] != 0;
        sides_.turn.back().push_back(is_turned != ((state & 1) != 0) ? 1 : 0);
        sides_.components_of.back().push_back(
            number[static_cast<std::size_t>(state >> 1)]);
      }
    }
    return std::move(sides_);
  }

private:
  pcl::index_t
  rootOf(std::size_t piece)
  {
    return labels_.find(2 * static_cast<pcl::index_t>(piece));
  }

  static double
  signOf(pcl::index_t state)
  {
    return (state & 1) != 0 ? -1.0 : 1.0;
  }

  /** Edges that two pieces have. */
  std::vector<Common>
  commonEdges() const
  {
    std::vector<Half> halves;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
      for (const CutEdge& edge : tiles_[tile].edges)
        halves.push_back(
            {&edge, tile, first_[tile] + static_cast<pcl::index_t>(edge.piece)});
    std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
      return std::tie(a.edge->ends, a.tile, a.edge->piece) <
             std::tie(b.edge->ends, b.tile, b.edge->piece);
    });
    std::vector<Common> common;
    for (std::size_t i = 1; i < halves.size(); ++i) {
      const Half &one = halves[i - 1], &other = halves[i];
      if (one.edge->ends == other.edge->ends)
        common.push_back({one.edge->ends,
                          {one.label, other.label},
                          one.edge->falls == other.edge->falls});
    }
    return common;
  }

  /** Two triangles on an edge are wound alike when they run through it both ways. Those
   * pieces come first that most edges tell about: a few may be those of a handle that
   * turns the surface over. */
  void
  joinPieces()
  {
    const std::vector<Common> common = commonEdges();
    std::vector<LabelVote> votes;
    for (const Common& edge : common)
      votes.push_back({edge.labels, edge.is_against ? -1.0 : 1.0});
    joinClearest(std::move(votes), labels_);
    for (const Common& edge : common) {
      const pcl::index_t one = labels_.find(2 * edge.labels[0]);
      const pcl::index_t other = labels_.find(2 * edge.labels[1]);
      if (((one ^ other) & 1) != (edge.is_against ? 1 : 0)) {
        sides_.torn.push_back(edge.ends);
        continue;
      }
      for (const pcl::index_t label : edge.labels)
        --sums_[static_cast<std::size_t>(label)].open_edges;
    }
  }

  /** Axis that the plane most of all triangles follow lies across, or -1. */
  int
  planeAxis() const
  {
    Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
    for (const SideSums& sums : sums_)
      tensor += sums.tensor;
    Eigen::Vector3d normal;
    return axisOfPlane(tensor, normal);
  }

  /** \return 1 when the surface has to be turned */
  std::uint8_t
  settle(const SideSums& sums, int axis)
  {
    OutwardRule rule = OutwardRule::UNDECIDED;
    double side = 0.0;
    for (std::size_t i = 0; i < sums.given.size() && side == 0.0; ++i)
      if (sums.given[i].margin() >= VOTE_MARGIN) {
        rule = static_cast<OutwardRule>(i);
        side = sums.given[i].sum;
      }
    if (side == 0.0 && sums.open_edges == 0 && enclosesVolume(sums.volume, sums.area)) {
      rule = OutwardRule::VOLUME;
      side = sums.volume;
    }
    if (side == 0.0 && axis >= 0 &&
        std::abs(sums.normals[axis]) >= LEAST_TERRAIN_MARGIN * sums.projected[axis]) {
      rule = OutwardRule::PLANE;
      side = sums.normals[axis];
      sides_.tally.guessed_axis = axis;
    }
    const double bulge =
        sums.area > 0.0 ? sums.volume - sums.moment.dot(sums.normals) / sums.area : 0.0;
    if (side == 0.0 && std::abs(bulge) > LEAST_BULGE * std::pow(sums.area, 1.5)) {
      rule = OutwardRule::BULGE;
      side = bulge;
    }
    sides_.tally.triangles[static_cast<std::size_t>(rule)] += sums.triangles;
    ++sides_.components;
    sides_.open_edges += static_cast<std::uint64_t>(sums.open_edges);
    return side < 0.0 ? 1 : 0;
  }

  const std::vector<TilePieces>& tiles_;
  std::vector<pcl::index_t> first_; /**< number of the first piece of each tile */
  std::vector<SideSums> sums_;
  LabelSets labels_;
  Sides sides_;
};

/** Whether a triangle, wound like its piece, runs from the higher end of the edge
 * behind a corner to the lower. */
bool
falls(const Triangle& triangle, std::size_t corner, bool is_turned)
{
  return (triangle[corner] > triangle[(corner + 1) % 3]) != is_turned;
}

/** Whether two triangles of a piece run through the edge behind a corner alike. */
bool
disagree(const Triangles& triangles,
         const Winding& winding,
         std::size_t t,
         std::size_t corner,
         std::size_t other)
{
  if (!winding.components()[winding.componentOf(t)].one_sided)
    return false;
  const auto endsOf = [](const Triangle& triangle, std::size_t i) {
    return std::minmax({triangle[i], triangle[(i + 1) % 3]});
  };
  for (std::size_t i = 0; i < 3; ++i)
    if (endsOf(triangles[other], i) == endsOf(triangles[t], corner))
      return falls(triangles[t], corner, winding.isTurned(t)) ==
             falls(triangles[other], i, winding.isTurned(other));
  return false;
}

/** The edges of the pieces with one triangle, and, twice, those over which the windings
 * of one that is one-sided do not agree. */
std::vector<CutEdge>
openEdges(const Triangles& triangles,
          const TriangleAdjacency& adjacency,
          const std::vector<WideIndex>& wide,
          const Winding& winding)
{
  std::vector<CutEdge> edges;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      const auto at = static_cast<std::size_t>(corner);
      const pcl::index_t other = adjacency.across(static_cast<pcl::index_t>(t), corner);
      if (other >= 0 &&
          !disagree(triangles, winding, t, at, static_cast<std::size_t>(other)))
        continue;
      CutEdge edge;
      edge.ends = {wide[static_cast<std::size_t>(triangles[t][at])],
                   wide[static_cast<std::size_t>(triangles[t][(at + 1) % 3])]};
      edge.piece = static_cast<std::uint32_t>(winding.componentOf(t));
      edge.falls = falls(triangles[t], at, winding.isTurned(t)) ? 1 : 0;
      std::sort(edge.ends.begin(), edge.ends.end());
      edges.push_back(edge);
    }
  return edges;
}

} // namespace

void
SideSums::add(const SideSums& other, double sign)
{
  for (std::size_t i = 0; i < given.size(); ++i)
    given[i].add(other.given[i], sign);
  volume += sign * other.volume;
  area += other.area;
  moment += other.moment;
  normals += sign * other.normals;
  projected += other.projected;
  tensor += other.tensor;
  box.extend(other.box);
  triangles += other.triangles;
  open_edges += other.open_edges;
}

TilePieces
sumUpSides(Triangles& triangles,
           const std::vector<WideIndex>& wide,
           const PointView& positions,
           const Position& origin,
           const OrientationHints& hints,
           RunControl& control,
           std::vector<std::uint32_t>& piece_of)
{
  TilePieces pieces;
  TriangleAdjacency adjacency;
  adjacency.build(triangles, positions.size(), hints.threads, &control);
  Winding winding;
  if (control.cancelled() ||
      !winding.find(triangles, adjacency, hints.threads, control))
    return pieces;
  // Where no winding suits, what is found depends on where one begins.
  const auto& found = winding.components();
  if (std::any_of(
          found.begin(), found.end(), [](const auto& one) { return one.one_sided; }))
    winding.find(triangles, adjacency, 1, control);
  const LoopContext context{hints.threads, &control, "sides"};
  const auto add = [&](std::size_t, std::size_t t, SideSums& sums) {
    const Corners c = cornersOf(triangles[t], positions);
    const Eigen::Vector3d area = winding.sign(t) * areaNormal(c);
    const Position centroid = (c[0] + c[1] + c[2]) / 3.0 - origin;
    ++sums.triangles;
    if (!area.allFinite() || area.isZero(0.0))
      return;
    sums.volume += area.dot(centroid);
    sums.area += area.norm();
    sums.moment += area.norm() * centroid;
    sums.normals += area;
    sums.projected += area.cwiseAbs();
    sums.tensor += area * area.transpose() / area.norm();
    sums.box.extend(centroid);
  };
  const ComponentFlags all(winding.components().size(), 1);
  pieces.sums = sumByComponent<SideSums>(winding, triangles.size(), all, context, add);
  const auto evidence =
      collectEvidence({triangles, positions, winding}, hints, context);
  for (std::size_t i = 0; i < evidence.size(); ++i)
    pieces.sums[i].given = evidence[i].given;
  pieces.edges = openEdges(triangles, adjacency, wide, winding);
  for (const CutEdge& edge : pieces.edges)
    ++pieces.sums[edge.piece].open_edges;
  piece_of.clear();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    piece_of.push_back(static_cast<std::uint32_t>(winding.componentOf(t)));
    if (winding.isTurned(t))
      adjacency.turn(static_cast<pcl::index_t>(t), triangles);
  }
  return pieces;
}

Sides
decideSides(const std::vector<TilePieces>& tiles, bool guess_plane)
{
  return SideGraph(tiles).decide(guess_plane);
}

std::vector<SideSums>
sumUpComponents(const std::vector<TilePieces>& tiles, const Sides& sides)
{
  std::vector<SideSums> components(sides.components);
  for (std::size_t tile = 0; tile < tiles.size(); ++tile)
    for (std::size_t piece = 0; piece < tiles[tile].sums.size(); ++piece)
      components[sides.components_of[tile][piece]].add(
          tiles[tile].sums[piece], sides.turn[tile][piece] != 0 ? -1.0 : 1.0);
  return components;
}

} // namespace pcl::ccaa
