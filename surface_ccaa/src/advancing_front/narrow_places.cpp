// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: where a completed mesh is thin or narrow.
#include "advancing_front/narrow_places.h"

#include "advancing_front/tuning.h"
#include "mesh/clefts.h"
#include "mesh/contacts.h"
#include "mesh/facing_ends.h"
#include "mesh/handle_places.h"
#include "mesh/sharp_edges.h"
#include "mesh/vertex_normals.h"

#include <algorithm>
#include <cmath>

namespace pcl::ccaa {

std::vector<pcl::index_t>
trianglesAt(const std::vector<std::uint8_t>& flags, const Triangles& triangles)
{
  std::vector<pcl::index_t> found;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (std::any_of(triangles[t].begin(), triangles[t].end(), [&](pcl::index_t v) {
          return flags[static_cast<std::size_t>(v)] != 0;
        }))
      found.push_back(static_cast<pcl::index_t>(t));
  return found;
}

void
addRings(int count, const Triangles& triangles, std::vector<std::uint8_t>& flags)
{
  for (int ring = 0; ring < count; ++ring)
    for (const pcl::index_t t : trianglesAt(flags, triangles))
      for (const pcl::index_t corner : triangles[static_cast<std::size_t>(t)])
        flags[static_cast<std::size_t>(corner)] = 1;
}

std::vector<std::uint8_t>
thinPlaces(const Triangles& triangles,
           const PointView& points,
           double least_rise,
           const LoopContext& context)
{
  const auto normals = vertexNormals(triangles, points, context);
  std::vector<std::uint8_t> is_thin(points.size(), 0);
  for (const Triangle& triangle : triangles)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto from = static_cast<std::size_t>(triangle[corner]);
      const auto to = static_cast<std::size_t>(triangle[(corner + 1) % 3]);
      if (normals[from].dot(normals[to]) >= tuning::OPPOSITE)
        continue;
      const Position edge = points[to] - points[from];
      const double rise = std::max(std::abs(edge.dot(normals[from].cast<double>())),
                                   std::abs(edge.dot(normals[to].cast<double>())));
      if (rise >= least_rise * edge.norm())
        is_thin[from] = is_thin[to] = 1;
    }
  return is_thin;
}

std::vector<std::uint8_t>
smallHandles(const CompletedMesh& mesh, std::size_t vertex_count)
{
  std::vector<std::uint8_t> is_there(vertex_count, 0);
  for (const ThinNeck& neck : mesh.thin_necks)
    if (neck.is_handle)
      is_there[static_cast<std::size_t>(neck.vertex)] = 1;
  return is_there;
}

void
findNecks(const PointView& points,
          int threads,
          CompletedMesh& mesh,
          CompletionReport& report)
{
  const TriangleAdjacency& adjacency = mesh.adjacency;
  const SharpEdges edges = findSharpEdges(mesh.triangles, adjacency, points, {threads});
  mesh.is_cleft =
      cleftVertices(edges.concave, mesh.triangles, adjacency, points, {threads});
  mesh.has_cleft_handle =
      mesh.topology.genus.value_or(0) > 0 &&
      !handlePlaces(mesh.triangles, adjacency, mesh.is_cleft, threads).empty();
  report.doubts.thin_necks = neckVertices(
      mesh.thin_necks, mesh.is_cleft, mesh.triangles, adjacency, points, threads);
  report.doubts.touching_pieces =
      facingEnds(edges.convex, mesh.triangles, adjacency, points);
  if (mesh.topology.pieces > 1)
    for (const Contact& contact :
         pieceContacts(mesh.triangles, adjacency, points, {threads}))
      report.doubts.touching_pieces.push_back(contact);
}

} // namespace pcl::ccaa
