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

std::size_t
countOf(const std::vector<std::uint8_t>& flags)
{
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
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

/** What a body is unlikely to have: handles, openings, points beside its surface, more
 * pieces than one. */
std::size_t
flawsOf(const CompletedMesh& mesh, const CompletionReport& report)
{
  const SurfaceTopology& topology = mesh.topology;
  return 2 * static_cast<std::size_t>(topology.genus.value_or(0)) +
         2 * (std::max<std::size_t>(topology.pieces, 1) - 1) + topology.boundary_loops +
         report.free_points;
}

/** The numbers of rings that are tried: few do little for a body that is thin all over.
 */
std::vector<int>
ringsFor(const std::vector<std::uint8_t>& is_thin)
{
  const double share =
      static_cast<double>(countOf(is_thin)) / static_cast<double>(is_thin.size());
  return {tuning::AROUND.begin() + (share < tuning::THIN_ALL_OVER ? 0 : 1),
          tuning::AROUND.end()};
}

/** Flags all corners of the triangles at flagged vertices. */
void
addRing(std::vector<std::uint8_t>& is_chosen, const Triangles& triangles)
{
  for (const pcl::index_t t : trianglesAt(is_chosen, triangles))
    for (const pcl::index_t corner : triangles[static_cast<std::size_t>(t)])
      is_chosen[static_cast<std::size_t>(corner)] = 1;
}

/** The completion of a result as that of what the result was completed from.
 * \param[in] kept of that */
void
countFrom(const std::vector<pcl::index_t>& kept,
          const CompletionReport& before,
          CompletedMesh& after,
          CompletionReport& report)
{
  std::vector<pcl::index_t> kept_after;
  for (const pcl::index_t t : after.kept)
    if (static_cast<std::size_t>(t) < kept.size())
      kept_after.push_back(kept[static_cast<std::size_t>(t)]);
  after.kept = std::move(kept_after);
  report.given_triangles = before.given_triangles;
  report.open_points = before.open_points;
  report.kept_triangles = after.kept.size();
  report.new_triangles = after.triangles.size() - after.kept.size();
}

/** Takes what comes out without the surroundings of thin places, if it is better.
 * \param[in] is_thin flags of vertices of the result */
void
growThinPlacesAnew(PartialMesh mesh,
                   std::vector<std::uint8_t> is_thin,
                   const CompletionWithout& complete,
                   std::uint64_t most_work,
                   CompletedMesh& result,
                   CompletionReport& report)
{
  mesh.given = result.triangles;
  const std::vector<pcl::index_t> kept = result.kept;
  const CompletionReport first_report = report;
  int ring = 1;
  for (const int rings : ringsFor(is_thin)) {
    for (; ring < rings; ++ring)
      addRing(is_thin, mesh.given);
    CompletionReport other_report;
    CompletedMesh other =
        complete(mesh, trianglesAt(is_thin, mesh.given), most_work, other_report);
    const std::size_t before = flawsOf(result, report);
    const std::size_t after = flawsOf(other, other_report);
    if (other_report.cancelled || other.fault != PartialMeshFault::NONE ||
        after >= before)
      return;
    countFrom(kept, first_report, other, other_report);
    result = std::move(other);
    report = other_report;
    if (2 * after > before || after == 0)
      return;
  }
}

} // namespace

void
openTunnels(PartialMesh mesh,
            const CompletionWithout& complete,
            std::uint64_t work,
            const LoopContext& context,
            CompletedMesh& result,
            CompletionReport& report)
{
  if (context.cancelled() || result.topology.genus.value_or(0) <= 0)
    return;
  auto is_thin = thinPlaces(result.triangles, mesh.points, context);
  const bool has_thin = countOf(is_thin) > 0;
  if (!has_thin && countOf(thinPlaces(mesh.given, mesh.points, context)) == 0)
    return;
  const auto most_work =
      static_cast<std::uint64_t>(tuning::MOST_WORK_ANEW * static_cast<double>(work));
  if (has_thin)
    growThinPlacesAnew(
        std::move(mesh), std::move(is_thin), complete, most_work, result, report);
  report.doubtful_handles =
      static_cast<std::size_t>(std::max(0L, result.topology.genus.value_or(0)));
}

} // namespace pcl::ccaa
