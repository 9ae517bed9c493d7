// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the working data and the steps of one umbrella filter run.
#include "umbrella/filter_run.h"

#include "mesh/polygon_access.h"
#include "umbrella/chain_elimination.h"
#include "umbrella/edge_repair.h"
#include "umbrella/region_growth.h"
#include "umbrella/twist_cut.h"

#include <limits>
#include <utility>

namespace pcl::ccaa {
namespace {

/** The adjacency counts edge ends, three to a triangle, in 32 bits. */
constexpr std::size_t MAXIMUM_TRIANGLES = std::numeric_limits<std::uint32_t>::max() / 3;

/** \brief Triples in the order of vertices; nothing of nothing. */
Positions
gather(const PointView& points,
       const std::vector<pcl::index_t>& point_of_vertex,
       const LoopContext& context)
{
  Positions gathered(points.empty() ? 0 : point_of_vertex.size());
  const auto copy = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      gathered[i] = points[point_of_vertex[i]];
  };
  forEachBlock(gathered.size(), context, copy);
  return gathered;
}

} // namespace

FilterOutcome
FilterRun::filter()
{
  if (triangles_.size() > MAXIMUM_TRIANGLES)
    return FilterOutcome::TOO_MANY_TRIANGLES;
  const auto steps = {&FilterRun::buildAdjacency,
                      &FilterRun::repairEdges,
                      &FilterRun::eliminate,
                      &FilterRun::dropDeleted,
                      &FilterRun::orient};
  for (const auto step : steps)
    if (!control_.cancelled())
      (this->*step)();
  return control_.cancelled() ? FilterOutcome::CANCELLED : FilterOutcome::DONE;
}

void
FilterRun::read(const PolygonView& polygons)
{
  auto mesh = readPolygons(polygons, views_.points, stage("reading polygons"));
  if (control_.cancelled())
    return;
  report_.input_polygons = polygons.size();
  report_.invalid_polygons = mesh.invalid_polygons;
  triangles_ = std::move(mesh.triangles);
  point_of_vertex_ = std::move(mesh.point_of_vertex);
  positions_ = gather(views_.points, point_of_vertex_, stage("reading points"));
}

void
FilterRun::buildAdjacency()
{
  adjacency_.build(triangles_, positions_.size(), settings_.threads, &control_);
  alive_.assign(triangles_.size(), 1);
  fans_ = adjacency_.fans();
}

/** Brings the mesh to C3.4-1. */
void
FilterRun::repairEdges()
{
  const auto repaired = repairNonManifoldEdges(
      triangles_, adjacency_, positions_, stage("edge repair"), alive_);
  report_.duplicate_triangles = repaired.duplicate_triangles;
  report_.overfull_edges = repaired.overfull_edges;
  report_.overfull_triangles = repaired.overfull_triangles;
  if (control_.cancelled() ||
      repaired.duplicate_triangles + repaired.overfull_triangles == 0)
    return;
  triangles_ = liveTriangles(triangles_, alive_, stage("edge repair"));
  buildAdjacency();
}

/** Table T3.4-1 and C3.4-3. */
void
FilterRun::eliminate()
{
  report_.umbrella_triangles += eliminateChains(
      triangles_, adjacency_, positions_, stage("umbrella"), alive_, fans_);
  if (control_.cancelled())
    return;
  const auto regions = removeSmallRegions(
      triangles_, settings_.minimum_internal_points, stage("regions"), alive_, fans_);
  report_.small_region_triangles += regions.triangles_removed;
  report_.components = regions.regions_kept;
}

void
FilterRun::dropDeleted()
{
  if (report_.umbrella_triangles + report_.small_region_triangles +
          report_.twist_triangles >
      0) {
    triangles_ = liveTriangles(triangles_, alive_, stage("regions"));
    if (settings_.consistent_orientation)
      adjacency_.follow(
          alive_, triangles_, positions_.size(), settings_.threads, &control_);
  }
  alive_ = AliveFlags(); // {} would keep the memory
  report_.output_triangles = triangles_.size();
}

void
FilterRun::orient()
{
  if (settings_.consistent_orientation) {
    if (views_.viewpoints.empty())
      takeOrigin(settings_.sides, positions_);
    OrientationReport oriented = windOutward(true);
    while (oriented.oneSided() > 0 && cutTwistedRegions())
      oriented = windOutward(true); // until nothing is cut: filtering twice is once
    if (oriented.oneSided() > 0)
      oriented = windOutward(false);
    report_.reversed_triangles = oriented.reversed;
    report_.one_sided_components = oriented.oneSided();
    tally_ = oriented.tally;
  }
  else
    adjacency_.clear(); // it has not followed what went
  positions_ = Positions();
}

OrientationReport
FilterRun::windOutward(bool only_if_two_sided)
{
  const LoopContext context = stage("reading hints");
  OrientationHints hints;
  static_cast<SideHints&>(hints) = settings_.sides;
  const auto normals = gather(views_.normals, point_of_vertex_, context);
  const auto viewpoints = gather(views_.viewpoints, point_of_vertex_, context);
  hints.normals = normals;
  hints.viewpoints = viewpoints;
  hints.stop_if_one_sided = only_if_two_sided;
  hints.threads = settings_.threads;
  return orientTriangles(triangles_, adjacency_, positions_, hints, control_);
}

/** The points around a cut are examined like those around any other deletion.
 * \return whether anything was cut */
bool
FilterRun::cutTwistedRegions()
{
  const std::vector<index_t> twists = findTwists(
      triangles_, adjacency_, positions_, settings_.twist_limits, stage("twists"));
  if (twists.empty() || control_.cancelled())
    return false;
  report_.twist_triangles += twists.size();
  alive_.assign(triangles_.size(), 1);
  for (const index_t twist : twists) {
    alive_[static_cast<std::size_t>(twist)] = 0;
    for (const index_t corner : triangles_[static_cast<std::size_t>(twist)])
      fans_[static_cast<std::size_t>(corner)] = Fan::SEVERAL; // to be looked at
  }
  eliminate();
  dropDeleted();
  return !control_.cancelled();
}

bool
FilterRun::write(TriangleHandoff* handoff, std::vector<pcl::Vertices>& polygons)
{
  handOut(std::move(triangles_),
          point_of_vertex_,
          stage("writing polygons"),
          handoff,
          polygons);
  return !control_.cancelled();
}

std::vector<PointRole>
FilterRun::pointRoles()
{
  std::vector<PointRole> roles(views_.points.size(), PointRole::FREE);
  for (std::size_t vertex = 0; vertex < fans_.size(); ++vertex) {
    auto& role = roles[static_cast<std::size_t>(point_of_vertex_[vertex])];
    if (fans_[vertex] == Fan::CLOSED) {
      role = PointRole::INTERNAL;
      ++report_.internal_points;
    }
    else if (fans_[vertex] == Fan::OPEN) {
      role = PointRole::BOUNDARY;
      ++report_.boundary_points;
    }
  }
  report_.free_points =
      roles.size() - report_.internal_points - report_.boundary_points;
  return roles;
}

} // namespace pcl::ccaa
