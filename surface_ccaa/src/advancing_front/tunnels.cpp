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
ringsFor(std::size_t thin, std::size_t points)
{
  const auto first =
      tuning::AROUND.begin() +
      (static_cast<double>(thin) < tuning::THIN_ALL_OVER * static_cast<double>(points)
           ? 0
           : 1);
  return {first, tuning::AROUND.end()};
}

/** Triangles at flagged vertices, and rings around them. */
std::vector<pcl::index_t>
ringsAround(std::vector<std::uint8_t> is_chosen, int rings, const Triangles& triangles)
{
  std::vector<pcl::index_t> found = trianglesAt(is_chosen, triangles);
  for (int ring = 1; ring < rings; ++ring) {
    for (const pcl::index_t t : found)
      for (const pcl::index_t corner : triangles[static_cast<std::size_t>(t)])
        is_chosen[static_cast<std::size_t>(corner)] = 1;
    found = trianglesAt(is_chosen, triangles);
  }
  return found;
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

/** Takes what comes out without the surroundings of thin places, if it is better. */
void
growThinPlacesAnew(const PartialMesh& mesh,
                   const std::vector<std::uint8_t>& is_thin,
                   const std::vector<int>& rings_around,
                   const CompletionWithout& complete,
                   std::uint64_t most_work,
                   CompletedMesh& result,
                   CompletionReport& report)
{
  PartialMesh whole = mesh;
  whole.given = result.triangles;
  const std::vector<pcl::index_t> kept = result.kept;
  const CompletionReport first_report = report;
  for (const int rings : rings_around) {
    CompletionReport other_report;
    CompletedMesh other = complete(
        whole, ringsAround(is_thin, rings, whole.given), most_work, other_report);
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
openTunnels(const PartialMesh& mesh,
            const CompletionWithout& complete,
            std::uint64_t work,
            const LoopContext& context,
            CompletedMesh& result,
            CompletionReport& report)
{
  if (context.cancelled() || result.topology.genus.value_or(0) <= 0)
    return;
  const auto is_thin = thinPlaces(result.triangles, mesh.points, context);
  const std::size_t thin = countOf(is_thin);
  if (thin == 0 && countOf(thinPlaces(mesh.given, mesh.points, context)) == 0)
    return;
  const auto most_work =
      static_cast<std::uint64_t>(tuning::MOST_WORK_ANEW * static_cast<double>(work));
  if (thin > 0)
    growThinPlacesAnew(mesh,
                       is_thin,
                       ringsFor(thin, is_thin.size()),
                       complete,
                       most_work,
                       result,
                       report);
  report.doubtful_handles =
      static_cast<std::size_t>(std::max(0L, result.topology.genus.value_or(0)));
}

} // namespace pcl::ccaa
