// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the surface around holes as a mesh of its own, repaired.
#include "out_of_core/cluster_repair.h"

#include <pcl/surface_repair/force_line_hole_repair.h>

#include "cli/cli.h"
#include "decision/cut_loops.h"
#include "mesh/corners.h"
#include "mesh/islands.h"
#include "mesh/sort_unique.h"
#include "mesh/triangle_adjacency.h"
#include "out_of_core/tile_cloud.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace app {
namespace {

using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

std::array<double, 9>
storedCorners(const pcl::ccaa::Corners& corners)
{
  std::array<double, 9> stored{};
  for (std::size_t i = 0; i < stored.size(); ++i)
    stored[i] = corners[i / 3][static_cast<pcl::index_t>(i % 3)];
  return stored;
}

/** The surface around a cluster as a mesh of its own, repaired. */
class ClusterRepair {
public:
  ClusterRepair(const TilePlan& plan,
                const HoleGathering& gathering,
                const HoleCluster& cluster,
                pcl::repair::RepairParameters method,
                const StepRun& run)
  : plan_(plan)
  , gathering_(gathering)
  , cluster_(cluster)
  , method_(std::move(method))
  , run_(run)
  {
    const auto begin = cluster.points.begin();
    for (const WideTriangle& triangle : cluster.triangles) {
      given_.emplace_back();
      for (std::size_t i = 0; i < 3; ++i)
        given_.back()[i] = static_cast<pcl::index_t>(
            std::lower_bound(begin, cluster.points.end(), triangle[i]) - begin);
    }
    for (const auto& edge : cluster.edges)
      own_points_.insert(own_points_.end(), edge.begin(), edge.end());
    pcl::ccaa::sortUnique(own_points_);
  }

  /** Add what it makes. */
  void
  addTo(RepairedTile& tile)
  {
    const pcl::PolygonMesh::ConstPtr mesh = makeMesh();
    method_.survey.decisions = pcl::repair::leaveCutsOpen(
        mesh, [&](pcl::index_t from, pcl::index_t to) { return isOpen(from, to); });
    pcl::ForceLineHoleRepair repair;
    repair.setInputMesh(mesh);
    repair.setParameters(method_);
    repair.setNumberOfThreads(run_.threads);
    repair.setProgressCallback(run_.progress);
    pcl::PolygonMesh repaired;
    repair.process(repaired);
    const pcl::RepairReport& report = repair.getReport();
    if (report.cancelled)
      throw Failure(stopped_by_signal);
    if (!report.finished || report.input_triangles != given_.size())
      throw Failure("a repair failed, perhaps for lack of memory");
    take(repaired, report, tile);
  }

private:
  pcl::PolygonMesh::ConstPtr
  makeMesh() const
  {
    auto mesh = pcl::make_shared<pcl::PolygonMesh>();
    mesh->cloud = TileCloud(plan_, cluster_.points).take();
    for (const pcl::ccaa::Triangle& triangle : given_) {
      mesh->polygons.emplace_back();
      mesh->polygons.back().vertices.assign(triangle.begin(), triangle.end());
    }
    return mesh;
  }

  bool
  isOpen(pcl::index_t from, pcl::index_t to) const
  {
    std::array<WideIndex, 2> ends{cluster_.points[static_cast<std::size_t>(from)],
                                  cluster_.points[static_cast<std::size_t>(to)]};
    std::sort(ends.begin(), ends.end());
    return std::binary_search(cluster_.edges.begin(), cluster_.edges.end(), ends);
  }

  void
  take(const pcl::PolygonMesh& repaired,
       const pcl::RepairReport& report,
       RepairedTile& tile)
  {
    const std::size_t given = given_.size();
    for (const pcl::Vertices& polygon : repaired.polygons)
      triangles_.push_back(
          {polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]});
    const std::size_t points = pcl::ccaa::pointCount(repaired.cloud);
    adjacency_.build(triangles_, points);
    const pcl::ccaa::Islands islands = labelIslands(adjacency_);
    putCopiesBack(points);
    // Islands whose given triangles came out wound as they were, and the other way.
    std::vector<std::uint8_t> as_given(islands.count, 0), turned(islands.count, 0);
    for (std::size_t t = 0; t < given; ++t)
      (isAsGiven(triangles_[t], t) ? as_given : turned)[islands[t]] = 1;
    addFacts(report, tile.facts);
    tile.facts.addDoubts(report.doubts, pcl::ccaa::positionView(repaired.cloud));
    for (const std::vector<std::size_t>& patch : patches(points)) {
      const std::size_t island = islands[patch.front()];
      if (as_given[island] != 0 && turned[island] != 0)
        ++tile.facts.against;
      else if (!isKnown(repaired.cloud, patch))
        ++tile.facts.astray;
      else
        append(repaired.cloud, patch, turned[island] != 0, tile);
    }
  }

  /** The new triangles, those together that have edges in common. */
  std::vector<std::vector<std::size_t>>
  patches(std::size_t points) const
  {
    const std::size_t given = given_.size();
    const pcl::ccaa::Triangles added(
        triangles_.begin() + static_cast<std::ptrdiff_t>(given), triangles_.end());
    pcl::ccaa::TriangleAdjacency adjacency;
    adjacency.build(added, points);
    const pcl::ccaa::Islands islands = labelIslands(adjacency);
    std::vector<std::vector<std::size_t>> patches(islands.count);
    for (std::size_t t = 0; t < added.size(); ++t)
      patches[islands[t]].push_back(given + t);
    return patches;
  }

  /** Whether a given triangle came out with the same winding: a repair keeps the first
   * corner in its place. */
  bool
  isAsGiven(const pcl::ccaa::Triangle& triangle, std::size_t t) const
  {
    const pcl::ccaa::Triangle& given = given_[t];
    if (triangle != given && triangle != turnedOver(given))
      throw Failure("a repair has changed the given triangles");
    return triangle == given;
  }

  static pcl::ccaa::Triangle
  turnedOver(const pcl::ccaa::Triangle& triangle)
  {
    return {triangle[0], triangle[2], triangle[1]};
  }

  /** A point with two fans has got a copy for one of them. Other tiles do not know it,
   * and go on with one vertex. */
  void
  putCopiesBack(std::size_t points)
  {
    std::vector<pcl::index_t> point_of(points, pcl::UNAVAILABLE);
    std::iota(point_of.begin(),
              point_of.begin() + static_cast<std::ptrdiff_t>(cluster_.points.size()),
              pcl::index_t{0});
    // What one triangle tells of its copies helps to tell whether another was turned.
    for (const std::ptrdiff_t most_unknown : {1, 2, 3})
      for (std::size_t t = 0; t < given_.size(); ++t) {
        const auto isUnknown = [&](pcl::index_t corner) {
          return point_of[static_cast<std::size_t>(corner)] == pcl::UNAVAILABLE;
        };
        const auto unknown =
            std::count_if(triangles_[t].begin(), triangles_[t].end(), isUnknown);
        if (unknown > 0 && unknown <= most_unknown)
          learnCopies(triangles_[t], given_[t], point_of);
      }
    for (pcl::ccaa::Triangle& triangle : triangles_)
      for (pcl::index_t& corner : triangle)
        if (const pcl::index_t point = point_of[static_cast<std::size_t>(corner)];
            point != pcl::UNAVAILABLE)
          corner = point;
  }

  /** Else a boundary runs along a cut. */
  bool
  isOnOwnLoop(pcl::index_t point) const
  {
    return std::binary_search(own_points_.begin(),
                              own_points_.end(),
                              cluster_.points[static_cast<std::size_t>(point)]);
  }

  static void
  learnCopies(const pcl::ccaa::Triangle& triangle,
              const pcl::ccaa::Triangle& given,
              std::vector<pcl::index_t>& point_of)
  {
    for (const pcl::ccaa::Triangle& before : {given, turnedOver(given)}) {
      bool fits = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const pcl::index_t point = point_of[static_cast<std::size_t>(triangle[i])];
        fits = fits && (point == pcl::UNAVAILABLE || point == before[i]);
      }
      if (!fits)
        continue;
      for (std::size_t i = 0; i < 3; ++i)
        point_of[static_cast<std::size_t>(triangle[i])] = before[i];
      return;
    }
  }

  bool
  isKnown(const pcl::PCLPointCloud2& cloud, const std::vector<std::size_t>& patch) const
  {
    const pcl::ccaa::PointView positions = pcl::ccaa::positionView(cloud);
    return std::all_of(patch.begin(), patch.end(), [&](std::size_t t) {
      const pcl::ccaa::Corners corners = cornersOf(triangles_[t], positions);
      return std::all_of(
          corners.begin(), corners.end(), [&](const pcl::ccaa::Position& corner) {
            return gathering_.isKnown(cluster_, corner);
          });
    });
  }

  /** A patch, wound like the given triangles, with its new corners. */
  void
  append(const pcl::PCLPointCloud2& cloud,
         const std::vector<std::size_t>& patch,
         bool is_turned,
         RepairedTile& tile) const
  {
    const std::size_t bytes = plan_.layout.point_step;
    if (cloud.point_step != bytes)
      throw Failure("a repair has changed the fields of the points");
    const pcl::ccaa::PointView positions = pcl::ccaa::positionView(cloud);
    RepairedPatch made;
    made.cluster = cluster_.number;
    std::map<pcl::index_t, WideIndex> number; // of the new corners
    bool is_exposed = false;
    const std::size_t first = tile.triangles.size();
    for (const std::size_t t : patch) {
      const pcl::ccaa::Corners corners = cornersOf(triangles_[t], positions);
      is_exposed =
          is_exposed || gathering_.isNearOthers(cluster_, pcl::ccaa::boxOf(corners));
      WideTriangle triangle{};
      for (std::size_t i = 0; i < 3; ++i) {
        const pcl::index_t corner = triangles_[t][i];
        const auto place = static_cast<std::size_t>(corner);
        if (place < cluster_.points.size()) {
          triangle[i] = cluster_.points[place];
          continue;
        }
        const auto [at, is_new] =
            number.try_emplace(corner, plan_.pointsInTiles() + tile.vertices(plan_));
        triangle[i] = at->second;
        if (!is_new)
          continue;
        const auto from =
            cloud.data.begin() + static_cast<std::ptrdiff_t>(place * bytes);
        tile.records.insert(
            tile.records.end(), from, from + static_cast<std::ptrdiff_t>(bytes));
      }
      if (is_turned)
        std::swap(triangle[1], triangle[2]);
      tile.triangles.push_back(triangle);
      made.area += pcl::ccaa::areaNormal(corners).norm() / 2.0;
    }
    made.vertices = number.size();
    made.triangles = patch.size();
    addEdges(patch, made, tile);
    for (std::size_t k = 0; k < patch.size() && is_exposed; ++k)
      tile.exposed.push_back(
          {tile.patches.size(),
           tile.triangles[first + k],
           storedCorners(cornersOf(triangles_[patch[k]], positions))});
    tile.patches.push_back(made);
  }

  /** How many edges it leaves open more than before, and what it joins. */
  void
  addEdges(const std::vector<std::size_t>& patch,
           RepairedPatch& made,
           RepairedTile& tile) const
  {
    std::vector<std::uint64_t> components;
    for (const std::size_t t : patch)
      for (int corner = 0; corner < 3; ++corner) {
        const pcl::index_t other =
            adjacency_.across(static_cast<pcl::index_t>(t), corner);
        if (other < 0)
          ++made.open_edges;
        else if (static_cast<std::size_t>(other) < given_.size()) {
          --made.open_edges;
          components.push_back(cluster_.components[static_cast<std::size_t>(other)]);
        }
      }
    pcl::ccaa::sortUnique(components);
    for (std::size_t i = 1; i < components.size(); ++i)
      tile.joined.push_back({tile.patches.size(), components[0], components[i]});
  }

  void
  addFacts(const pcl::RepairReport& report, TileRepairFacts& facts) const
  {
    for (const pcl::RepairedHole& hole : report.holes) {
      const auto reason = static_cast<std::size_t>(hole.open);
      if (hole.open == pcl::OpenReason::NONE)
        ++facts.closed;
      else if (isOnOwnLoop(hole.point))
        ++(hole.shortfall ? facts.shortfalls : facts.kept)[reason];
    }
  }

  const TilePlan& plan_;
  const HoleGathering& gathering_;
  const HoleCluster& cluster_;
  pcl::repair::RepairParameters method_;
  const StepRun& run_;
  pcl::ccaa::Triangles given_;        /**< of the cluster's points */
  std::vector<WideIndex> own_points_; /**< on its loops, ascending */
  pcl::ccaa::Triangles triangles_; /**< of the result: the given ones, then the new */
  pcl::ccaa::TriangleAdjacency adjacency_; /**< of these */
};

} // namespace

void
repairCluster(const TilePlan& plan,
              const HoleGathering& gathering,
              const HoleCluster& cluster,
              const pcl::repair::RepairParameters& method,
              const StepRun& run,
              RepairedTile& tile)
{
  ClusterRepair(plan, gathering, cluster, method, run).addTo(tile);
}

} // namespace app
