// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tunnels that a start algorithm made through thin places.
#include "advancing_front/tunnels.h"

#include "advancing_front/tuning.h"
#include "mesh/vertex_normals.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Flags for the ends of edges whose ends face away from each other.
 *
 * There a start algorithm may connect two sides through the body. Such a tunnel has a
 * perfect umbrella at each point, and its edges are no sharper than those in which the
 * body ends: nothing here tells the one from the other. */
std::vector<std::uint8_t>
thinPlaces(const Triangles& triangles,
           const PointView& points,
           const LoopContext& context)
{
  const auto normals = vertexNormals(triangles, points, context);
  std::vector<std::uint8_t> is_thin(points.size(), 0);
  for (const Triangle& triangle : triangles)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto from = static_cast<std::size_t>(triangle[corner]);
      const auto to = static_cast<std::size_t>(triangle[(corner + 1) % 3]);
      if (normals[from].dot(normals[to]) < tuning::OPPOSITE)
        is_thin[from] = is_thin[to] = 1;
    }
  return is_thin;
}

std::vector<pcl::index_t>
trianglesAt(const std::vector<std::uint8_t>& is_chosen, const Triangles& triangles)
{
  std::vector<pcl::index_t> found;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (std::any_of(triangles[t].begin(), triangles[t].end(), [&](pcl::index_t v) {
          return is_chosen[static_cast<std::size_t>(v)] != 0;
        }))
      found.push_back(static_cast<pcl::index_t>(t));
  return found;
}

/** What a body is unlikely to have: handles, openings, points beside its surface. */
std::size_t
flawsOf(const CompletedMesh& mesh, const CompletionReport& report)
{
  return 2 * static_cast<std::size_t>(mesh.topology.genus.value_or(0)) +
         mesh.topology.boundary_loops + report.free_points;
}

bool
anyOf(const std::vector<std::uint8_t>& flags)
{
  return std::find(flags.begin(), flags.end(), 1) != flags.end();
}

/** Takes what comes out without the surroundings of thin places, if it is better.
 * \param[in] is_thin flags of vertices, some of them set */
void
growThinPlacesAnew(const PartialMesh& mesh,
                   const CompletionWithout& complete,
                   std::vector<std::uint8_t> is_thin,
                   const LoopContext& context,
                   CompletedMesh& result,
                   CompletionReport& report)
{
  std::vector<pcl::index_t> thin = trianglesAt(is_thin, mesh.given);
  int ring = 1;
  for (const int rings : tuning::AROUND) {
    for (; ring < rings; ++ring) {
      for (const pcl::index_t t : thin)
        for (const pcl::index_t corner : mesh.given[static_cast<std::size_t>(t)])
          is_thin[static_cast<std::size_t>(corner)] = 1;
      thin = trianglesAt(is_thin, mesh.given);
    }
    if (context.cancelled())
      return;
    CompletionReport other_report;
    CompletedMesh other = complete(thin, other_report);
    const std::size_t before = flawsOf(result, report);
    const std::size_t after = flawsOf(other, other_report);
    if (context.cancelled() || after >= before)
      return;
    result = std::move(other);
    report = other_report;
    if (2 * after > before || result.topology.genus.value_or(0) <= 0)
      return;
  }
}

} // namespace

void
openTunnels(const PartialMesh& mesh,
            const CompletionWithout& complete,
            const LoopContext& context,
            CompletedMesh& result,
            CompletionReport& report)
{
  if (context.cancelled() || result.topology.genus.value_or(0) <= 0)
    return;
  const auto is_thin = thinPlaces(mesh.given, mesh.points, context);
  const bool was_thin = anyOf(is_thin);
  if (was_thin)
    growThinPlacesAnew(mesh, complete, is_thin, context, result, report);
  const long handles = result.topology.genus.value_or(0);
  if (handles > 0 &&
      (was_thin || anyOf(thinPlaces(result.triangles, mesh.points, context))))
    report.doubtful_handles = static_cast<std::size_t>(handles);
}

} // namespace pcl::ccaa
