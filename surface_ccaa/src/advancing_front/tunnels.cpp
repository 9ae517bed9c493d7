// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tunnels that a start algorithm made through thin places.
#include "advancing_front/tunnels.h"

#include "advancing_front/handle_opening.h"
#include "advancing_front/narrow_places.h"
#include "advancing_front/tuning.h"
#include "mesh/handle_places.h"
#include "mesh/orientation.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Flags for what is narrow or next to itself, where a handle may be none. */
std::vector<std::uint8_t>
doubtfulVertices(const CompletedMesh& mesh, std::vector<std::uint8_t> is_thin)
{
  for (const ThinNeck& neck : mesh.thin_necks)
    for (const pcl::index_t vertex : neck.around)
      if (neck.is_handle)
        is_thin[static_cast<std::size_t>(vertex)] = 1;
  addRings(tuning::AROUND_HANDLE, mesh.triangles, is_thin);
  for (std::size_t v = 0; v < is_thin.size(); ++v)
    is_thin[v] |= mesh.is_cleft[v];
  return is_thin;
}

/** Grows what is narrow anew, turns the result outward, and tells thin necks.
 * \param[in,out] is_thin flags for thin places \param[in] has_thin whether these are of
 * the result */
void
openNarrow(const Recompletion& again,
           bool has_thin,
           std::vector<std::uint8_t>& is_thin,
           CompletedMesh& result,
           CompletionReport& report)
{
  const std::vector<std::uint8_t> known =
      has_thin ? is_thin : std::vector<std::uint8_t>(is_thin.size(), 0);
  std::vector<std::uint8_t> is_narrow = smallHandles(result, is_thin.size());
  for (std::size_t v = 0; v < is_narrow.size(); ++v)
    is_narrow[v] |= known[v];
  if (countOf(is_narrow) == 0)
    return;
  const Completed first{std::move(result), report};
  Completed opened = openNarrowPlaces(again, first, known, is_narrow);
  result = std::move(opened.mesh);
  report = opened.report;
  if (opened.flaws() == first.flaws())
    return;
  const int threads = again.context.threads;
  const PointView points = again.mesh.points;
  report.sides = orientTriangles(result.triangles,
                                 result.adjacency,
                                 points,
                                 hintsOf(again.mesh, threads),
                                 *again.context.control)
                     .tally; // more is closed, so more is known
  is_thin = thinPlaces(result.triangles, points, 0.0, {threads});
  result.thin_necks = thinNecks(result.triangles, result.adjacency, points, {threads});
}

/** Tells handles that may be none. */
void
doubtHandles(bool had_thin,
             std::vector<std::uint8_t> is_thin,
             int threads,
             const CompletedMesh& mesh,
             TopologyDoubts& doubts)
{
  const long handles = mesh.topology.genus.value_or(0);
  const bool is_doubtful =
      had_thin || mesh.has_cleft_handle || countOf(is_thin) > 0 ||
      std::any_of(mesh.thin_necks.begin(),
                  mesh.thin_necks.end(),
                  [](const ThinNeck& neck) { return neck.is_handle; });
  if (handles <= 0 || !is_doubtful)
    return;
  is_thin = doubtfulVertices(mesh, std::move(is_thin));
  for (const HandlePlace& place :
       handlePlaces(mesh.triangles, mesh.adjacency, is_thin, threads))
    doubts.thin_handles.push_back(place.flagged);
  if (had_thin || !doubts.thin_handles.empty()) // else where it was given
    doubts.handles = static_cast<std::uint64_t>(handles);
}

} // namespace

void
openTunnels(PartialMesh mesh,
            const CompletionAgain& complete,
            std::uint64_t work,
            const LoopContext& context,
            CompletedMesh& result,
            CompletionReport& report)
{
  if (context.cancelled())
    return;
  const PointView points = mesh.points;
  const int threads = context.threads;
  result.thin_necks = thinNecks(result.triangles, result.adjacency, points, {threads});
  std::vector<std::uint8_t> is_thin;
  bool has_thin = false;
  if (result.topology.genus.value_or(0) > 0) {
    is_thin = thinPlaces(result.triangles, points, 0.0, context);
    has_thin = countOf(is_thin) > 0;
    if (!has_thin)
      is_thin = thinPlaces(mesh.given, points, tuning::LARGEST_RISE, context);
    mesh.given = {}; // the result takes its place
    openNarrow({mesh, complete, work, context}, has_thin, is_thin, result, report);
  }
  findNecks(points, threads, result, report);
  doubtHandles(has_thin, std::move(is_thin), threads, result, report.doubts);
}

} // namespace pcl::ccaa
