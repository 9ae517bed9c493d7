// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tunnels that a start algorithm made through thin places.
#include "advancing_front/tunnels.h"

#include "advancing_front/handle_opening.h"
#include "advancing_front/narrow_places.h"
#include "advancing_front/tuning.h"
#include "mesh/handle_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace pcl::ccaa {
namespace {

/** The adjacency of a completed mesh, and with it where it is narrow. */
TriangleAdjacency
readNecks(const PointView& points,
          int threads,
          CompletedMesh& mesh,
          CompletionReport& report)
{
  TriangleAdjacency adjacency;
  adjacency.build(mesh.triangles, points.size(), threads);
  findNecks(adjacency, points, {threads}, mesh, report);
  return adjacency;
}

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

} // namespace

void
openTunnels(PartialMesh mesh,
            const CompletionAgain& complete,
            std::uint64_t work,
            const LoopContext& context,
            CompletedMesh& result,
            CompletionReport& report)
{
  if (context.cancelled() || result.topology.genus.value_or(0) <= 0)
    return;
  const PointView points = mesh.points;
  auto is_thin = thinPlaces(result.triangles, points, 0.0, context);
  const bool has_thin = countOf(is_thin) > 0;
  if (!has_thin)
    is_thin = thinPlaces(mesh.given, points, tuning::LARGEST_RISE, context);
  mesh.given = {}; // the result takes its place
  const std::vector<std::uint8_t> known =
      has_thin ? is_thin : std::vector<std::uint8_t>(is_thin.size(), 0);
  std::vector<std::uint8_t> is_narrow = smallHandles(result, points.size());
  for (std::size_t v = 0; v < is_narrow.size(); ++v)
    is_narrow[v] |= known[v];
  std::optional<TriangleAdjacency> adjacency;
  if (countOf(is_narrow) > 0) {
    const Completed first{std::move(result), report};
    Completed opened = openNarrowPlaces(
        mesh, complete, work, context.threads, first, known, is_narrow);
    result = std::move(opened.mesh);
    report = opened.report;
    if (opened.flaws() < first.flaws()) {
      adjacency = readNecks(points, context.threads, result, report);
      is_thin = thinPlaces(result.triangles, points, 0.0, context);
    }
  }
  const long handles = result.topology.genus.value_or(0);
  const bool is_doubtful =
      has_thin || result.has_cleft_handle || countOf(is_thin) > 0 ||
      std::any_of(result.thin_necks.begin(),
                  result.thin_necks.end(),
                  [](const ThinNeck& neck) { return neck.is_handle; });
  if (handles <= 0 || !is_doubtful)
    return;
  if (!adjacency)
    adjacency.emplace().build(result.triangles, points.size(), context.threads);
  is_thin = doubtfulVertices(result, std::move(is_thin));
  report.doubts.handles = static_cast<std::uint64_t>(handles);
  report.doubts.thin_handles.clear();
  for (const HandlePlace& place :
       handlePlaces(result.triangles, *adjacency, is_thin, context.threads))
    report.doubts.thin_handles.push_back(place.flagged);
  if (!has_thin && report.doubts.thin_handles.empty())
    report.doubts.handles = 0; // the given triangles had such places elsewhere
}

} // namespace pcl::ccaa
