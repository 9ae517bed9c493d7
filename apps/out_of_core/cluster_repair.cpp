// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the surface around some holes as a mesh of its own,
// repaired.
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
#include <numeric>
#include <utility>

namespace app {
namespace {

using pcl::ccaa::WideIndex;
using pcl::ccaa::WideTriangle;

/** Points in those of a tile that a cluster may have: where surfaces lie close to each
 * other it has more than the one that the loops are of. */
constexpr std::uint64_t CROWD = 2;

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
  {}

  /** Add what it makes. */
  void
  addTo(RepairedTile& tile)
  {
    if (cluster_.points.size() > CROWD * plan_.most_points) {
      tile.facts.crowded += cluster_.loops;
      return;
    }
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
    if (!report.finished || report.input_triangles != cluster_.triangles.size())
      throw Failure("a repair failed, perhaps for lack of memory");
    take(repaired, report, tile);
  }

private:
  pcl::PolygonMesh::ConstPtr
  makeMesh() const
  {
    auto mesh = pcl::make_shared<pcl::PolygonMesh>();
    mesh->cloud = TileCloud(plan_, cluster_.points).take();
    for (std::size_t t = 0; t < cluster_.triangles.size(); ++t) {
      const pcl::ccaa::Triangle triangle = givenTriangle(t);
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
    const std::size_t given = cluster_.triangles.size();
    pcl::ccaa::Triangles triangles;
    for (const pcl::Vertices& polygon : repaired.polygons)
      triangles.push_back(
          {polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]});
    pcl::ccaa::TriangleAdjacency adjacency;
    adjacency.build(triangles, pcl::ccaa::pointCount(repaired.cloud));
    const pcl::ccaa::Islands islands = labelIslands(adjacency);
    putCopiesBack(pcl::ccaa::pointCount(repaired.cloud), triangles);
    // Islands whose given triangles came out wound as they were, and the other way.
    std::vector<std::uint8_t> as_given(islands.count, 0), turned(islands.count, 0);
    for (std::size_t t = 0; t < given; ++t)
      (isAsGiven(triangles[t], t) ? as_given : turned)[islands[t]] = 1;
    std::vector<std::uint8_t> keeps(islands.count, 1), is_new(islands.count, 0);
    for (std::size_t t = given; t < triangles.size(); ++t)
      is_new[islands[t]] = 1;
    for (std::size_t i = 0; i < islands.count; ++i)
      if (as_given[i] != 0 && turned[i] != 0) {
        keeps[i] = 0;
        tile.facts.against += is_new[i];
      }
    const pcl::ccaa::PointView positions = pcl::ccaa::positionView(repaired.cloud);
    for (std::size_t t = given; t < triangles.size(); ++t)
      for (const pcl::index_t corner : triangles[t])
        if (keeps[islands[t]] != 0 &&
            !gathering_.mayHold(cluster_,
                                positions[static_cast<std::size_t>(corner)])) {
          keeps[islands[t]] = 0;
          ++tile.facts.astray;
        }
    append(repaired, triangles, islands, keeps, turned, tile);
    joinComponents(islands, keeps, tile);
    addFacts(triangles, islands, keeps, report, tile.facts);
    for (std::size_t t = given; t < triangles.size(); ++t)
      if (keeps[islands[t]] != 0)
        tile.facts.area +=
            pcl::ccaa::areaNormal(cornersOf(triangles[t], positions)).norm() / 2.0;
  }

  pcl::ccaa::Triangle
  givenTriangle(std::size_t t) const
  {
    pcl::ccaa::Triangle triangle{};
    for (std::size_t i = 0; i < 3; ++i)
      triangle[i] =
          static_cast<pcl::index_t>(std::lower_bound(cluster_.points.begin(),
                                                     cluster_.points.end(),
                                                     cluster_.triangles[t][i]) -
                                    cluster_.points.begin());
    return triangle;
  }

  /** Whether a given triangle came out with the same winding: a repair keeps the first
   * corner in its place. */
  bool
  isAsGiven(const pcl::ccaa::Triangle& triangle, std::size_t t) const
  {
    const pcl::ccaa::Triangle given = givenTriangle(t);
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
  putCopiesBack(std::size_t points, pcl::ccaa::Triangles& triangles) const
  {
    std::vector<pcl::index_t> point_of(points, pcl::UNAVAILABLE);
    std::iota(point_of.begin(),
              point_of.begin() + static_cast<std::ptrdiff_t>(cluster_.points.size()),
              pcl::index_t{0});
    // What one triangle tells of its copies helps to tell whether another was turned.
    for (const std::ptrdiff_t most_unknown : {1, 2, 3})
      for (std::size_t t = 0; t < cluster_.triangles.size(); ++t) {
        const auto isUnknown = [&](pcl::index_t corner) {
          return point_of[static_cast<std::size_t>(corner)] == pcl::UNAVAILABLE;
        };
        const auto unknown =
            std::count_if(triangles[t].begin(), triangles[t].end(), isUnknown);
        if (unknown > 0 && unknown <= most_unknown)
          learnCopies(triangles[t], givenTriangle(t), point_of);
      }
    for (pcl::ccaa::Triangle& triangle : triangles)
      for (pcl::index_t& corner : triangle)
        if (const pcl::index_t point = point_of[static_cast<std::size_t>(corner)];
            point != pcl::UNAVAILABLE)
          corner = point;
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

  /** The new triangles that stay, wound like the given ones, and their new corners. */
  void
  append(const pcl::PolygonMesh& repaired,
         const pcl::ccaa::Triangles& triangles,
         const pcl::ccaa::Islands& islands,
         const std::vector<std::uint8_t>& keeps,
         const std::vector<std::uint8_t>& turned,
         RepairedTile& tile) const
  {
    const std::size_t points = cluster_.points.size();
    const std::size_t bytes = plan_.layout.point_step;
    if (repaired.cloud.point_step != bytes)
      throw Failure("a repair has changed the fields of the points");
    const pcl::ccaa::Tile& last = plan_.tiling.tiles.back();
    std::vector<WideIndex> number(pcl::ccaa::pointCount(repaired.cloud) - points,
                                  WideIndex(-1));
    const auto numberOf = [&](pcl::index_t corner) {
      const auto place = static_cast<std::size_t>(corner);
      if (place < points)
        return cluster_.points[place];
      WideIndex& wide = number[place - points];
      if (wide == WideIndex(-1)) {
        wide = last.first + last.count + tile.records.size() / bytes;
        const auto from =
            repaired.cloud.data.begin() + static_cast<std::ptrdiff_t>(place * bytes);
        tile.records.insert(
            tile.records.end(), from, from + static_cast<std::ptrdiff_t>(bytes));
        ++tile.facts.vertices;
      }
      return wide;
    };
    for (std::size_t t = cluster_.triangles.size(); t < triangles.size(); ++t) {
      if (keeps[islands[t]] == 0)
        continue;
      WideTriangle triangle{};
      for (std::size_t i = 0; i < 3; ++i)
        triangle[i] = numberOf(triangles[t][i]);
      if (turned[islands[t]] != 0)
        std::swap(triangle[1], triangle[2]);
      tile.triangles.push_back(triangle);
      ++tile.facts.triangles;
    }
  }

  /** Components of the whole that have come to be one island. */
  void
  joinComponents(const pcl::ccaa::Islands& islands,
                 const std::vector<std::uint8_t>& keeps,
                 RepairedTile& tile) const
  {
    std::vector<std::vector<std::uint64_t>> components(islands.count);
    for (std::size_t t = 0; t < cluster_.triangles.size(); ++t)
      if (keeps[islands[t]] != 0)
        components[islands[t]].push_back(cluster_.components[t]);
    for (std::vector<std::uint64_t>& one : components) {
      pcl::ccaa::sortUnique(one);
      for (std::size_t i = 1; i < one.size(); ++i)
        tile.joined.push_back({one[0], one[i]});
    }
  }

  void
  addFacts(const pcl::ccaa::Triangles& triangles,
           const pcl::ccaa::Islands& islands,
           const std::vector<std::uint8_t>& keeps,
           const pcl::RepairReport& report,
           TileRepairFacts& facts) const
  {
    for (const pcl::RepairedHole& hole : report.holes) {
      facts.closed += hole.open == pcl::OpenReason::NONE ? 1 : 0;
      if (hole.open != pcl::OpenReason::NONE && hole.shortfall &&
          hole.open != pcl::OpenReason::NOT_WANTED)
        ++facts.shortfalls[static_cast<std::size_t>(hole.open)];
    }
    for (const pcl::RepairDoubt& doubt : report.doubts)
      ++facts.doubts[static_cast<std::size_t>(doubt.reason)];
    facts.open_edges += openEdges(triangles, islands, keeps) -
                        static_cast<std::int64_t>(cluster_.edges.size());
  }

  /** Open edges of what stays; cuts are none. */
  std::int64_t
  openEdges(const pcl::ccaa::Triangles& triangles,
            const pcl::ccaa::Islands& islands,
            const std::vector<std::uint8_t>& keeps) const
  {
    pcl::ccaa::Triangles left;
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (t < cluster_.triangles.size() || keeps[islands[t]] != 0)
        left.push_back(triangles[t]);
    const auto points = static_cast<pcl::index_t>(cluster_.points.size());
    std::size_t vertices = cluster_.points.size();
    for (const pcl::ccaa::Triangle& triangle : left)
      for (const pcl::index_t corner : triangle)
        vertices = std::max(vertices, static_cast<std::size_t>(corner) + 1);
    pcl::ccaa::TriangleAdjacency adjacency;
    adjacency.build(left, vertices);
    std::int64_t open = 0;
    for (std::size_t t = 0; t < left.size(); ++t)
      for (int corner = 0; corner < 3; ++corner) {
        if (adjacency.across(static_cast<pcl::index_t>(t), corner) >= 0)
          continue;
        const pcl::index_t from = left[t][static_cast<std::size_t>(corner)];
        const pcl::index_t to = left[t][static_cast<std::size_t>((corner + 1) % 3)];
        const bool is_new =
            t >= cluster_.triangles.size() || from >= points || to >= points;
        open += is_new || isOpen(from, to) ? 1 : 0;
      }
    return open;
  }

  const TilePlan& plan_;
  const HoleGathering& gathering_;
  const HoleCluster& cluster_;
  pcl::repair::RepairParameters method_;
  const StepRun& run_;
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
