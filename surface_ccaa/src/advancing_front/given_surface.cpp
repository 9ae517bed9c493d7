// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the given triangles before a surface grows from them.
#include "advancing_front/given_surface.h"

#include "advancing_front/island_alignment.h"
#include "mesh/given_votes.h"
#include "mesh/sort_unique.h"
#include "mesh/winding.h"

#include <algorithm>
#include <limits>

namespace pcl::ccaa {
namespace {

/** The first fault of edges or vertices; windings are not looked at. */
PartialMeshFault
findFault(const TriangleAdjacency& adjacency)
{
  if (!adjacency.overfullEdges().empty())
    return PartialMeshFault::NON_MANIFOLD_EDGE;
  for (const Fan fan : adjacency.fans())
    if (fan == Fan::SEVERAL || fan == Fan::OVERFULL)
      return PartialMeshFault::NON_MANIFOLD_VERTEX;
  return PartialMeshFault::NONE;
}

/** Triangles, ascending, of the islands in which neighbors are wound differently. */
std::vector<pcl::index_t>
disagreeingIslands(const Triangles& triangles,
                   const TriangleAdjacency& adjacency,
                   const Islands& islands,
                   const LoopContext& context)
{
  const std::vector<std::uint8_t> disagrees =
      findDisagreements(triangles, adjacency, context);
  std::vector<std::uint8_t> in_island(islands.count, 0);
  for (std::size_t t = 0; t < disagrees.size(); ++t)
    if (disagrees[t] != 0)
      in_island[islands[t]] = 1;
  std::vector<pcl::index_t> found;
  for (std::size_t t = 0; t < disagrees.size(); ++t)
    if (in_island[islands[t]] != 0)
      found.push_back(static_cast<pcl::index_t>(t));
  return found;
}

/** Whether normals agree with each other on at least half of the given surface. */
bool
areNormalsClear(const PartialMesh& mesh,
                const GivenSurface& given,
                const LoopContext& context)
{
  OrientationHints alone;
  alone.normals = mesh.normals;
  alone.threads = context.threads;
  const std::vector<double> sides =
      evidentSides(mesh.given, given.adjacency, mesh.points, alone, *context.control);
  std::size_t clear = 0;
  for (std::size_t t = 0; t < mesh.given.size() && !sides.empty(); ++t)
    clear += sides[given.islands[t]] != 0.0 ? 1 : 0;
  return 2 * clear >= mesh.given.size();
}

/** Open points of one part of an island beside those of another. */
std::vector<PartContact>
contactsOf(const GivenSurface& given,
           const Islands& parts,
           const std::vector<pcl::index_t>& open,
           const std::vector<pcl::index_t>& table)
{
  constexpr std::size_t NO_PART = std::numeric_limits<std::size_t>::max();
  const TriangleAdjacency& adjacency = given.adjacency;
  const std::vector<pcl::index_t>& doubts = given.doubts.triangles;
  std::vector<PartPoint> points;
  for (const pcl::index_t vertex : open) {
    const auto* found = std::find_if(
        adjacency.begin(vertex), adjacency.end(vertex), [&](pcl::index_t t) {
          return !std::binary_search(doubts.begin(), doubts.end(), t);
        });
    points.push_back({vertex,
                      found == adjacency.end(vertex)
                          ? NO_PART
                          : parts[static_cast<std::size_t>(*found)]});
  }
  const std::size_t k = open.empty() ? 0 : table.size() / open.size();
  std::vector<PartContact> contacts;
  for (std::size_t i = 0; i < open.size(); ++i)
    for (std::size_t j = i * k; j < (i + 1) * k && table[j] >= 0; ++j) {
      const PartPoint &one = points[i],
                      &other = points[static_cast<std::size_t>(table[j])];
      if (one.part != NO_PART && other.part != NO_PART && other.part != one.part)
        contacts.push_back({one, other});
    }
  return contacts;
}

} // namespace

GivenSurface
readGiven(PartialMesh& mesh,
          const Reopening& reopening,
          bool keep_given,
          const LoopContext& context)
{
  GivenSurface surface;
  surface.adjacency = std::move(mesh.adjacency);
  if (reopening.is_again) {
    surface.doubts.triangles = reopening.triangles;
    surface.doubts.typical_fold = reopening.typical_fold;
    if (!reopening.isWound())
      surface.islands = labelIslands(surface.adjacency, {context.threads});
    return surface;
  }
  if (surface.adjacency.vertexCount() == 0)
    surface.adjacency.build(
        mesh.given, mesh.points.size(), context.threads, context.control);
  if (context.cancelled())
    return surface;
  surface.fault = findFault(surface.adjacency);
  if (surface.fault != PartialMeshFault::NONE)
    return surface;
  surface.islands = labelIslands(surface.adjacency, {context.threads});
  const std::vector<pcl::index_t> disagreeing =
      disagreeingIslands(mesh.given, surface.adjacency, surface.islands, context);
  if (keep_given && !disagreeing.empty())
    surface.fault = PartialMeshFault::BADLY_ORIENTED;
  if (surface.fault != PartialMeshFault::NONE || context.cancelled())
    return surface;
  surface.doubts = doubtfulTriangles(
      mesh.given, surface.adjacency, surface.islands, mesh.points, context);
  std::vector<pcl::index_t>& doubts = surface.doubts.triangles;
  if (keep_given) {
    doubts.clear();
    surface.doubts.folded.clear();
  }
  doubts.insert(doubts.end(), disagreeing.begin(), disagreeing.end());
  sortUnique(doubts);
  return surface;
}

std::vector<pcl::index_t>
openVertices(const PartialMesh& mesh,
             const GivenSurface& given,
             const Reopening& reopening)
{
  std::vector<std::uint8_t> is_open(mesh.points.size(), 0);
  for (std::size_t v = 0; v < is_open.size(); ++v) {
    const Fan fan = given.adjacency.fan(static_cast<pcl::index_t>(v));
    is_open[v] = reopening.alone ? fan == Fan::NONE : fan != Fan::CLOSED;
  }
  for (const pcl::index_t t : given.doubts.triangles)
    for (const pcl::index_t corner : mesh.given[static_cast<std::size_t>(t)])
      is_open[static_cast<std::size_t>(corner)] = 1;
  for (const pcl::index_t vertex : reopening.handles)
    is_open[static_cast<std::size_t>(vertex)] = 1;
  std::vector<pcl::index_t> open;
  for (std::size_t v = 0; v < is_open.size(); ++v)
    if (is_open[v] != 0 && !mesh.isCut(static_cast<pcl::index_t>(v)))
      open.push_back(static_cast<pcl::index_t>(v));
  return open;
}

OrientationHints
hintsOf(const PartialMesh& mesh, int threads)
{
  OrientationHints hints;
  static_cast<SideHints&>(hints) = mesh.sides;
  hints.normals = mesh.normals;
  hints.viewpoints = mesh.viewpoints;
  hints.threads = threads;
  return hints;
}

void
alignGiven(PartialMesh& mesh,
           GivenSurface& given,
           const std::vector<pcl::index_t>& open,
           const std::vector<pcl::index_t>& table,
           const LoopContext& context)
{
  if (mesh.sides.told_viewpoint || mesh.sides.up ||
      (!mesh.normals.empty() && !areNormalsClear(mesh, given, context)))
    mesh.normals = {};
  const OrientationHints hints = hintsOf(mesh, context.threads);
  const std::vector<pcl::index_t>& doubts = given.doubts.triangles;
  const Islands parts = doubts.empty()
                            ? given.islands
                            : labelIslands(given.adjacency, {context.threads}, doubts);
  const IslandVotes votes = askNeighbors(mesh.given,
                                         given.adjacency,
                                         given.islands,
                                         parts,
                                         mesh.points,
                                         contactsOf(given, parts, open, table));
  if (votes.between.empty() && !GivenVotes(hints).any())
    return; // a guess from the shape is better made of the finished surface
  alignIslands(
      mesh.given,
      given.adjacency,
      parts,
      votes,
      evidentSides(mesh.given, given.adjacency, mesh.points, hints, *context.control));
}

} // namespace pcl::ccaa
