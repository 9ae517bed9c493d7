// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm on index triangles (thesis 3.1, 3.5).
#include "advancing_front/surface_completion.h"

#include "advancing_front/doubtful_triangles.h"
#include "advancing_front/fan_settlement.h"
#include "advancing_front/island_alignment.h"
#include "advancing_front/local_regrowth.h"
#include "advancing_front/new_islands.h"
#include "advancing_front/open_regions.h"
#include "advancing_front/partial_mesh_check.h"
#include "advancing_front/partial_surface.h"
#include "advancing_front/scattered_points.h"
#include "advancing_front/spacing.h"
#include "advancing_front/surface_growth.h"
#include "advancing_front/tunnels.h"
#include "mesh/block_loop.h"
#include "mesh/orientation.h"
#include "mesh/sort_unique.h"

#include <utility>

namespace pcl {
namespace ccaa {
namespace {

/** Open points that one thread completes in the time it takes to wake others. */
constexpr std::size_t SMALL_GAP = 100;

/** One run, step by step. */
class Completion {
public:
  /** \param[in] more_doubts given triangles that are to go beside doubtful ones */
  Completion(PartialMesh& mesh,
             const std::vector<pcl::index_t>& more_doubts,
             const NeighborSearch& search,
             const CompletionParameters& parameters,
             int threads,
             RunControl& control,
             CompletionReport& report)
  : mesh_(mesh)
  , more_doubts_(more_doubts)
  , search_(search)
  , parameters_(parameters)
  , context_{threads, &control, "partial mesh"}
  , control_(control)
  , report_(report)
  {}

  CompletedMesh
  run();

private:
  std::vector<pcl::index_t>
  openVertices() const;
  bool
  searchNeighbors(std::vector<pcl::index_t>& open);
  OrientationHints
  hints() const;
  void
  dropUselessNormals();
  void
  align(const std::vector<pcl::index_t>& open);
  ComponentRule
  componentRule() const
  {
    return {parameters_.minimum_internal_points, doubts_.typical_fold};
  }
  bool
  grow(PartialSurface& surface, std::vector<pcl::index_t>& open);
  bool
  dropCrossings(PartialSurface& surface);
  bool
  growRegions(const OpenSurface& gap,
              const NearbyTriangles& nearby,
              Triangles& triangles,
              std::vector<pcl::index_t>& obstructed);
  std::vector<pcl::index_t>
  touchedVertices(const PartialSurface& surface,
                  const std::vector<pcl::index_t>& open) const;
  OpenSurface
  openSurface(const PartialSurface& surface,
              std::vector<pcl::index_t>& open,
              std::vector<pcl::index_t>& vertices);
  void
  collect(const PartialSurface& surface, CompletedMesh& result) const;
  void
  dropSmallIslands(CompletedMesh& result);
  void
  orient(Triangles& triangles);

  PartialMesh& mesh_;
  const std::vector<pcl::index_t>& more_doubts_;
  const NeighborSearch& search_;
  const CompletionParameters& parameters_;
  LoopContext context_;
  RunControl& control_;
  CompletionReport& report_;
  TriangleAdjacency adjacency_;
  Islands islands_;
  Doubts doubts_;
  std::vector<pcl::index_t> table_;
};

CompletedMesh
Completion::run()
{
  CompletedMesh result;
  report_.given_triangles = mesh_.given.size();
  adjacency_.build(mesh_.given, mesh_.points.size(), context_.threads, &control_);
  if (control_.cancelled())
    return result;
  if (mesh_.viewpoints.empty())
    takeOrigin(mesh_.sides, mesh_.points);
  result.fault = findFault(adjacency_);
  if (result.fault != PartialMeshFault::NONE)
    return result;
  islands_ = labelIslands(adjacency_);
  const std::vector<pcl::index_t> disagreeing =
      disagreeingIslands(mesh_.given, adjacency_, islands_, context_);
  if (parameters_.keep_given && !disagreeing.empty())
    result.fault = PartialMeshFault::BADLY_ORIENTED;
  if (result.fault != PartialMeshFault::NONE || control_.cancelled())
    return result;
  doubts_ =
      doubtfulTriangles(mesh_.given, adjacency_, islands_, mesh_.points, context_);
  if (parameters_.keep_given)
    doubts_.triangles.clear();
  doubts_.triangles.insert(
      doubts_.triangles.end(), disagreeing.begin(), disagreeing.end());
  doubts_.triangles.insert(
      doubts_.triangles.end(), more_doubts_.begin(), more_doubts_.end());
  sortUnique(doubts_.triangles);
  std::vector<pcl::index_t> open = openVertices();
  report_.open_points = open.size();
  if (!searchNeighbors(open))
    return result;
  dropUselessNormals();
  align(open);
  PartialSurface surface(mesh_.given, adjacency_, mesh_.points, hints());
  for (const pcl::index_t t : doubts_.triangles)
    surface.remove(t);
  if (!grow(surface, open))
    return result;
  collect(surface, result);
  dropSmallIslands(result);
  orient(result.triangles);
  return result;
}

/** Boundary points, free points, and the corners of triangles that are to go. */
std::vector<pcl::index_t>
Completion::openVertices() const
{
  std::vector<std::uint8_t> is_open(mesh_.points.size(), 0);
  for (std::size_t v = 0; v < is_open.size(); ++v)
    is_open[v] = adjacency_.fan(static_cast<pcl::index_t>(v)) != Fan::CLOSED;
  for (const pcl::index_t t : doubts_.triangles)
    for (const pcl::index_t corner : mesh_.given[static_cast<std::size_t>(t)])
      is_open[static_cast<std::size_t>(corner)] = 1;
  std::vector<pcl::index_t> open;
  for (std::size_t v = 0; v < is_open.size(); ++v)
    if (is_open[v] != 0)
      open.push_back(static_cast<pcl::index_t>(v));
  return open;
}

bool
Completion::searchNeighbors(std::vector<pcl::index_t>& open)
{
  return control_.report("partial mesh", 0.9) &&
         search_(open, parameters_.neighbors, table_) && !control_.cancelled();
}

/** All that is known about the outer side. */
OrientationHints
Completion::hints() const
{
  OrientationHints hints;
  static_cast<SideHints&>(hints) = mesh_.sides;
  hints.normals = mesh_.normals;
  hints.viewpoints = mesh_.viewpoints;
  hints.threads = context_.threads;
  return hints;
}

/** Normals that are overruled, or that agree with each other on less than half of the
 * given surface, would only keep triangles from growing. */
void
Completion::dropUselessNormals()
{
  if (mesh_.sides.told_viewpoint || mesh_.sides.up)
    mesh_.normals = {};
  if (mesh_.normals.empty() || mesh_.given.empty())
    return;
  OrientationHints alone;
  alone.normals = mesh_.normals;
  alone.threads = context_.threads;
  const std::vector<double> sides =
      evidentSides(mesh_.given, adjacency_, mesh_.points, alone, control_);
  std::size_t clear = 0;
  for (std::size_t t = 0; t < mesh_.given.size() && !sides.empty(); ++t)
    clear += sides[islands_[t]] != 0.0 ? 1 : 0;
  if (2 * clear < mesh_.given.size())
    mesh_.normals = {};
}

/** Islands that are to be joined must agree before growth begins. */
void
Completion::align(const std::vector<pcl::index_t>& open)
{
  std::vector<IslandContact> contacts;
  const std::size_t k = parameters_.neighbors;
  for (std::size_t i = 0; i < open.size(); ++i)
    for (std::size_t j = i * k; j < (i + 1) * k && table_[j] >= 0; ++j) {
      const IslandContact contact{open[i], open[static_cast<std::size_t>(table_[j])]};
      if (adjacency_.fan(contact.one) != Fan::NONE &&
          adjacency_.fan(contact.other) != Fan::NONE)
        contacts.push_back(contact);
    }
  alignIslands(mesh_.given,
               adjacency_,
               islands_,
               mesh_.points,
               evidentSides(mesh_.given, adjacency_, mesh_.points, hints(), control_),
               contacts);
}

/** The open surface without the points that are scattered in space. Those that happen
 * to have flat neighborhoods show when the others are gone. */
OpenSurface
Completion::openSurface(const PartialSurface& surface,
                        std::vector<pcl::index_t>& open,
                        std::vector<pcl::index_t>& vertices)
{
  constexpr int LARGEST_ROUNDS = 4;
  const double usual_spacing = usualSpacing(mesh_.given, mesh_.points);
  for (int round = 0;; ++round) {
    OpenSurface gap = surface.openAt(open, {}, vertices);
    gap.neighbors = {table_.data(), parameters_.neighbors};
    if (round == LARGEST_ROUNDS)
      return gap;
    const std::vector<std::uint8_t> scattered = findScatteredPoints(gap, usual_spacing);
    std::vector<pcl::index_t> remaining;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (scattered[i] == 0)
        remaining.push_back(open[i]);
    if (remaining.size() == open.size())
      return gap;
    open = std::move(remaining);
    if (!searchNeighbors(open))
      return {};
  }
}

bool
Completion::grow(PartialSurface& surface, std::vector<pcl::index_t>& open)
{
  std::vector<pcl::index_t> vertices;
  OpenSurface gap = openSurface(surface, open, vertices);
  if (control_.cancelled())
    return false;
  for (std::size_t i = 0; i < open.size(); ++i)
    if (gap.spacings[i] <= 0.0)
      surface.noteSpacing(open[i],
                          spacingFromNeighbors(gap, static_cast<pcl::index_t>(i)));
  completeSpacings(gap);
  const NearbyTriangles nearby(
      mesh_.given, surface.aliveGiven(), mesh_.points, open, cellSize(gap));
  Triangles all = gap.rim;
  std::vector<pcl::index_t> obstructed;
  if (!growRegions(gap, nearby, all, obstructed))
    return false;
  for (Triangle made :
       largeComponents(all, gap.rim.size(), gap.positions, componentRule())) {
    for (pcl::index_t& corner : made)
      corner = vertices[static_cast<std::size_t>(corner)];
    surface.add(made);
  }
  for (pcl::index_t& point : obstructed)
    point = vertices[static_cast<std::size_t>(point)];
  LocalRegrowth regrowth(surface, gap, vertices, nearby, parameters_, componentRule());
  if (!regrowth.run(obstructed, context_) || !dropCrossings(surface))
    return false;
  settleFans(surface, touchedVertices(surface, open), parameters_.keep_given);
  return true;
}

/** New triangles are tested against those around them when they are made; among long
 * ones, as between outliers, that may have missed another new one. The later one goes.
 */
bool
Completion::dropCrossings(PartialSurface& surface)
{
  std::vector<pcl::index_t> added;
  Triangles triangles;
  for (std::size_t t = mesh_.given.size(); t < surface.triangleCount(); ++t)
    if (const auto triangle = static_cast<pcl::index_t>(t); surface.isAlive(triangle)) {
      added.push_back(triangle);
      triangles.push_back(surface[triangle]);
    }
  const SelfIntersections found =
      findSelfIntersections(triangles, mesh_.points, context_.threads, control_);
  for (const TrianglePair& pair : found.pairs)
    surface.remove(added[static_cast<std::size_t>(pair.second)]);
  return !found.cancelled;
}

/** Regions of a gap grow at the same time and know nothing of each other.
 * \param[in,out] triangles the rim; what has grown is put behind it
 * \param[out] obstructed points of the gap */
bool
Completion::growRegions(const OpenSurface& gap,
                        const NearbyTriangles& nearby,
                        Triangles& triangles,
                        std::vector<pcl::index_t>& obstructed)
{
  const auto regions = openRegions(gap, 2.0 * parameters_.support);
  const auto rims = rimOfRegions(gap, regions);
  std::vector<Triangles> made(regions.size());
  std::vector<std::vector<pcl::index_t>> stuck(regions.size());
  const bool is_small = gap.open_points < SMALL_GAP; // waking threads would take longer
  const LoopContext loop{is_small ? 1 : context_.threads, &control_, "growth", 1};
  const bool finished =
      forEachBlock(regions.size(), loop, [&](std::size_t i, std::size_t, std::size_t) {
        std::vector<pcl::index_t> vertices;
        const OpenSurface region = regionOf(gap, regions[i], rims[i], vertices);
        SurfaceGrowth growth(region, parameters_, &nearby);
        growth.run(&control_);
        const Triangles& grown = growth.surface().triangles();
        for (std::size_t t = region.rim.size(); t < grown.size(); ++t)
          made[i].push_back({vertices[static_cast<std::size_t>(grown[t][0])],
                             vertices[static_cast<std::size_t>(grown[t][1])],
                             vertices[static_cast<std::size_t>(grown[t][2])]});
        for (const pcl::index_t point : growth.obstructedPoints())
          stuck[i].push_back(vertices[static_cast<std::size_t>(point)]);
      });
  if (!finished || control_.cancelled())
    return false;
  const Triangles new_triangles = joinBlocks(made);
  triangles.insert(triangles.end(), new_triangles.begin(), new_triangles.end());
  obstructed = joinBlocks(stuck);
  return true;
}

/** The open points, and the corners of triangles that went or came. */
std::vector<pcl::index_t>
Completion::touchedVertices(const PartialSurface& surface,
                            const std::vector<pcl::index_t>& open) const
{
  std::vector<pcl::index_t> touched = open;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const auto triangle = static_cast<pcl::index_t>(t);
    if (surface.isGiven(triangle) != surface.isAlive(triangle))
      touched.insert(touched.end(), surface[triangle].begin(), surface[triangle].end());
  }
  sortUnique(touched);
  return touched;
}

void
Completion::collect(const PartialSurface& surface, CompletedMesh& result) const
{
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const auto triangle = static_cast<pcl::index_t>(t);
    if (!surface.isAlive(triangle))
      continue;
    if (surface.isGiven(triangle))
      result.kept.push_back(triangle);
    result.triangles.push_back(surface[triangle]);
  }
}

/** Growth and local regrowth may leave pieces behind that are cut off from the rest
 * (C3.4-3).
 */
void
Completion::dropSmallIslands(CompletedMesh& result)
{
  adjacency_.build(result.triangles, mesh_.points.size(), context_.threads, &control_);
  if (control_.cancelled())
    return;
  const std::vector<std::uint8_t> lasts =
      largeComponentFlags(result.triangles,
                          adjacency_,
                          parameters_.keep_given ? result.kept.size() : 0,
                          parameters_.minimum_internal_points);
  std::size_t last = 0, kept = 0;
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    if (lasts[t] == 0)
      continue;
    if (t < result.kept.size())
      result.kept[kept++] = result.kept[t];
    result.triangles[last++] = result.triangles[t];
  }
  const bool dropped = last < result.triangles.size();
  result.triangles.resize(last);
  result.kept.resize(kept);
  report_.kept_triangles = kept;
  report_.new_triangles = last - kept;
  if (dropped)
    adjacency_.build(
        result.triangles, mesh_.points.size(), context_.threads, &control_);
}

/** The whole, outward where that can be told. */
void
Completion::orient(Triangles& triangles)
{
  for (const Fan fan : adjacency_.fans())
    report_.free_points += fan == Fan::NONE;
  report_.sides =
      orientTriangles(triangles, adjacency_, mesh_.points, hints(), control_).tally;
}

} // namespace

CompletedMesh
completeSurface(PartialMesh mesh,
                const NeighborSearch& search,
                const CompletionParameters& parameters,
                int threads,
                RunControl& control,
                CompletionReport& report)
{
  const auto complete = [&](const std::vector<pcl::index_t>& more_doubts,
                            CompletionReport& counts) {
    return Completion(mesh, more_doubts, search, parameters, threads, control, counts)
        .run();
  };
  CompletedMesh result = complete({}, report);
  if (!parameters.keep_given && result.fault == PartialMeshFault::NONE)
    openTunnels(mesh, complete, {threads, &control, "partial mesh"}, result, report);
  report.cancelled = control.cancelled();
  if (report.cancelled)
    return {};
  return result;
}

} // namespace ccaa
} // namespace pcl
