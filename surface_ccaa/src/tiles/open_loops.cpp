// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the boundary loops of a surface that runs through many
// tiles.
#include "tiles/open_loops.h"

#include "mesh/disjoint_sets.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace pcl::ccaa {
namespace {

/** What a repair has to know around a loop: half its extent, which is as far as lines
 * run over a gap between two that are as large, and edges that it is faired against. */
constexpr double ROOM = 0.5;
constexpr double ROOM_EDGES = 4.0;
/** Share of its surface's extent that the outer border of a sheet has along the two
 * longer axes. */
constexpr double BORDER_EXTENT = 0.9;
/** Length of the mean normal of a sheet; 0.5 for half a sphere, of which nothing tells
 * whether it is one. */
constexpr double SHEET_NORMAL = 0.55;

/** The two greatest extents of a box, the greater one first. */
std::array<Eigen::Index, 2>
longAxes(const Box& box)
{
  std::array<Eigen::Index, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](Eigen::Index a, Eigen::Index b) {
    return box.sizes()[a] > box.sizes()[b];
  });
  return {axes[0], axes[1]};
}

/** Whether a loop runs around a sheet. */
bool
isBorderOf(const SideSums& surface, const Box& loop)
{
  if (surface.normals.norm() < SHEET_NORMAL * surface.area)
    return false;
  const auto axes = longAxes(surface.box);
  return std::all_of(axes.begin(), axes.end(), [&](Eigen::Index axis) {
    return loop.sizes()[axis] >= BORDER_EXTENT * surface.box.sizes()[axis];
  });
}

class LoopClusters {
public:
  LoopClusters(std::vector<OpenEdge>& edges,
               const std::vector<WideIndex>& points,
               const std::vector<Position>& positions)
  : edges_(edges), points_(points), positions_(positions)
  {}

  void
  findLoops(const std::vector<SideSums>& components,
            const Tiling& tiling,
            const std::function<std::uint64_t(const Box&)>& points_in,
            std::uint64_t most_points)
  {
    DisjointSets sets(points_.size());
    for (const OpenEdge& edge : edges_)
      sets.join(placeOf(edge.ends[0]), placeOf(edge.ends[1]));
    std::stable_sort(
        edges_.begin(), edges_.end(), [&](const OpenEdge& a, const OpenEdge& b) {
          return sets.find(placeOf(a.ends[0])) < sets.find(placeOf(b.ends[0]));
        });
    for (std::size_t begin = 0, end = 0; begin < edges_.size(); begin = end) {
      const std::size_t root = sets.find(placeOf(edges_[begin].ends[0]));
      while (end < edges_.size() && sets.find(placeOf(edges_[end].ends[0])) == root)
        ++end;
      addLoop(begin, end, tiling);
      OpenLoop& loop = loops_.back();
      loop.points = points_in(loop.region());
      if (loop.points > most_points)
        loop.use = isBorderOf(components[edges_[begin].component], loop.box)
                       ? LoopUse::BORDER
                       : LoopUse::BEYOND;
    }
  }

  /** Join loops as far as they fit, and number what comes out. */
  void
  cluster(std::uint64_t most_points)
  {
    std::vector<std::uint64_t> points;
    for (const OpenLoop& loop : loops_)
      points.push_back(loop.points);
    DisjointSets sets(loops_.size());
    for (const Pair& pair : meeting()) {
      const std::size_t one = sets.find(pair.one), other = sets.find(pair.other);
      const std::uint64_t sum = points[one] + points[other];
      if (one == other || sum > most_points)
        continue;
      sets.join(one, other);
      points[sets.find(one)] = sum;
    }
    std::map<std::size_t, std::uint64_t> numbers;
    for (std::size_t i = 0; i < loops_.size(); ++i)
      if (loops_[i].use == LoopUse::REPAIR)
        loops_[i].cluster =
            numbers.try_emplace(sets.find(i), std::uint64_t{numbers.size()})
                .first->second;
  }

  std::vector<OpenLoop>
  take()
  {
    return std::move(loops_);
  }

private:
  std::size_t
  placeOf(WideIndex point) const
  {
    return static_cast<std::size_t>(
        std::lower_bound(points_.begin(), points_.end(), point) - points_.begin());
  }

  void
  addLoop(std::size_t begin, std::size_t end, const Tiling& tiling)
  {
    OpenLoop loop;
    loop.begin = begin;
    loop.end = end;
    for (std::size_t i = begin; i < end; ++i) {
      const Position& a = positions_[placeOf(edges_[i].ends[0])];
      const Position& b = positions_[placeOf(edges_[i].ends[1])];
      loop.box.extend(a).extend(b);
      loop.edge += (b - a).norm() / double(end - begin);
    }
    const Tile& tile = tiling.tiles[tiling.ownerOf(edges_[begin].ends[0])];
    loop.edge = std::min(loop.edge, tile.spacing());
    loops_.push_back(loop);
  }

  /** Two loops whose regions meet. */
  struct Pair {
    double distance; /**< of their boxes */
    std::size_t one, other;

    bool
    operator<(const Pair& next) const
    {
      return std::tie(distance, one, other) <
             std::tie(next.distance, next.one, next.other);
    }
  };

  /** Those that are to be repaired, the near ones first. */
  std::vector<Pair>
  meeting() const
  {
    std::vector<Box> regions;
    for (const OpenLoop& loop : loops_)
      regions.push_back(loop.use == LoopUse::REPAIR ? loop.region() : Box());
    const BoxTree tree(regions);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < loops_.size(); ++i)
      tree.forEachMeeting(regions[i], [&](pcl::index_t other) {
        const auto k = static_cast<std::size_t>(other);
        if (k > i && regions[i].intersects(regions[k]))
          pairs.push_back({loops_[i].box.exteriorDistance(loops_[k].box), i, k});
      });
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  std::vector<OpenEdge>& edges_;
  const std::vector<WideIndex>& points_;
  const std::vector<Position>& positions_;
  std::vector<OpenLoop> loops_;
};

} // namespace

Box
OpenLoop::region() const
{
  return widened(box, ROOM * box.diagonal().norm() + ROOM_EDGES * edge);
}

std::vector<OpenEdge>
openEdges(const std::vector<TilePieces>& tiles, const Sides& sides)
{
  std::vector<OpenEdge> edges;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile)
    for (const CutEdge& edge : tiles[tile].edges)
      edges.push_back({edge.ends, sides.components_of[tile][edge.piece]});
  std::sort(edges.begin(), edges.end(), [](const OpenEdge& a, const OpenEdge& b) {
    return a.ends < b.ends;
  });
  std::vector<OpenEdge> open;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_shared = (i > 0 && edges[i - 1].ends == edges[i].ends) ||
                           (i + 1 < edges.size() && edges[i + 1].ends == edges[i].ends);
    if (!is_shared)
      open.push_back(edges[i]);
  }
  return open;
}

std::vector<OpenLoop>
clusterLoops(std::vector<OpenEdge>& edges,
             const std::vector<WideIndex>& points,
             const std::vector<Position>& positions,
             const std::vector<SideSums>& components,
             const Tiling& tiling,
             const std::function<std::uint64_t(const Box&)>& points_in,
             std::uint64_t most_points)
{
  LoopClusters clusters(edges, points, positions);
  clusters.findLoops(components, tiling, points_in, most_points);
  clusters.cluster(most_points);
  return clusters.take();
}

} // namespace pcl::ccaa
