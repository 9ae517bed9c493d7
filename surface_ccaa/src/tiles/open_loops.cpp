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
/** What closes a loop bulges less: over half a sphere by half its extent, over what
 * scans leave open by far less. */
constexpr double CORE = 0.25;
constexpr double CORE_EDGES = 1.0;
/** Points of a sheet of triangles with equal edges in a square of such an edge. */
constexpr double POINTS_IN_SQUARE = 1.155;

/** Share of its surface's extent that the outer border of a sheet has along the two
 * longer axes. */
constexpr double BORDER_EXTENT = 0.9;
/** Length of the mean normal of a sheet; 0.5 for half a sphere. */
constexpr double SHEET_NORMAL = 0.7;

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
      if (loop.points() > double(most_points))
        loop.use = isBorderOf(components[edges_[begin].component], loop.box)
                       ? LoopUse::BORDER
                       : LoopUse::BEYOND;
    }
  }

  void
  cluster(const Tiling& tiling, std::uint64_t most_points)
  {
    DisjointSets sets(loops_.size());
    for (const Pair& pair : meeting())
      if (pair.distance < 0.0)
        sets.join(pair.one, pair.other);
    setTilesApart(sets, tiling, double(most_points));
    joinNearOnes(sets, double(most_points));
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
    double distance; /**< of their boxes; below 0: their cores meet */
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
          pairs.push_back({loops_[i].core().intersects(loops_[k].core())
                               ? -1.0
                               : loops_[i].box.exteriorDistance(loops_[k].box),
                           i,
                           k});
      });
    std::sort(pairs.begin(), pairs.end());
    return pairs;
  }

  std::map<std::size_t, double>
  pointsOf(DisjointSets& sets) const
  {
    std::map<std::size_t, double> points;
    for (std::size_t i = 0; i < loops_.size(); ++i)
      if (loops_[i].use == LoopUse::REPAIR)
        points[sets.find(i)] += loops_[i].points();
    return points;
  }

  /** Cut what is too large into what lies within one tile. */
  void
  setTilesApart(DisjointSets& sets, const Tiling& tiling, double most_points)
  {
    const std::map<std::size_t, double> points = pointsOf(sets);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> first_in;
    DisjointSets apart(loops_.size());
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      OpenLoop& loop = loops_[i];
      if (loop.use != LoopUse::REPAIR)
        continue;
      const std::size_t root = sets.find(i);
      std::size_t tile = 0;
      if (points.at(root) > most_points) {
        tile = tiling.ownerOf(edges_[loop.begin].ends[0]);
        const GridCell& cell = tiling.tiles[tile].cell;
        const Box region = loop.region();
        if (cell.distance(Position(region.min())) > 0.0 ||
            cell.distance(Position(region.max())) > 0.0) {
          loop.use = LoopUse::BEYOND;
          continue;
        }
      }
      apart.join(first_in.try_emplace({root, tile}, i).first->second, i);
    }
    sets = std::move(apart);
  }

  /** Join clusters as far as they fit, and number them. */
  void
  joinNearOnes(DisjointSets& sets, double most_points)
  {
    std::map<std::size_t, double> points = pointsOf(sets);
    for (const Pair& pair : meeting()) {
      const std::size_t one = sets.find(pair.one), other = sets.find(pair.other);
      const double sum = one == other ? 0.0 : points[one] + points[other];
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

  std::vector<OpenEdge>& edges_;
  const std::vector<WideIndex>& points_;
  const std::vector<Position>& positions_;
  std::vector<OpenLoop> loops_;
};

} // namespace

Box
OpenLoop::core() const
{
  return widened(box, CORE * box.diagonal().norm() + CORE_EDGES * edge);
}

Box
OpenLoop::region() const
{
  return widened(box, ROOM * box.diagonal().norm() + ROOM_EDGES * edge);
}

double
OpenLoop::points() const
{
  const Box around = region();
  const auto axes = longAxes(around);
  return POINTS_IN_SQUARE * around.sizes()[axes[0]] * around.sizes()[axes[1]] /
         (edge * edge);
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
             std::uint64_t most_points)
{
  LoopClusters clusters(edges, points, positions);
  clusters.findLoops(components, tiling, most_points);
  clusters.cluster(tiling, most_points);
  return clusters.take();
}

} // namespace pcl::ccaa
