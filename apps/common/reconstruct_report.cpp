// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what pcl_ccaa_reconstruct tells about a run.
#include "reconstruct_report.h"

#include <pcl/surface_ccaa/threads.h>

#include "point_columns.h"
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>

namespace app {
namespace {

using nlohmann::json;

double
shareOf(std::size_t part, std::size_t whole)
{
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

double
totalSeconds(const ReconstructResult& result)
{
  double seconds = 0;
  for (const auto& stage : result.stages)
    seconds += stage.second;
  return seconds;
}

json
describeFilter(const pcl::UmbrellaReport& filter)
{
  return {{"input_polygons", filter.input_polygons},
          {"invalid_polygons", filter.invalid_polygons},
          {"duplicate_triangles", filter.duplicate_triangles},
          {"overfull_edges", filter.overfull_edges},
          {"overfull_triangles", filter.overfull_triangles},
          {"umbrella_triangles", filter.umbrella_triangles},
          {"small_region_triangles", filter.small_region_triangles},
          {"twist_triangles", filter.twist_triangles},
          {"output_triangles", filter.output_triangles},
          {"reversed_triangles", filter.reversed_triangles},
          {"components", filter.components},
          {"one_sided_components", filter.one_sided_components},
          {"internal_points", filter.internal_points},
          {"boundary_points", filter.boundary_points},
          {"free_points", filter.free_points}};
}

} // namespace

json
describeRun(const ReconstructSettings& settings,
            const ReconstructResult& result,
            const Warnings& warnings)
{
  const std::size_t points = pointCount(result.model.mesh.cloud);
  const std::size_t peak = peakMemoryBytes();
  const std::size_t added = peak - std::min(peak, result.memory_before);
  json report = {{"input", settings.input},
                 {"output", settings.output},
                 {"until", settings.until},
                 {"N", points},
                 {"usable_points", result.start.points},
                 {"k", shareOf(result.used_points, points)},
                 {"k_usable", shareOf(result.used_points, result.start.points)},
                 {"internal_share", nullptr},
                 {"triangles", result.model.mesh.polygons.size()},
                 {"stages", describeStages(result.stages, points)},
                 {"total_seconds", totalSeconds(result)},
                 {"peak_memory_bytes", peak},
                 {"peak_bytes_per_point", shareOf(added, points)},
                 {"threads", pcl::ccaa::resolveThreads(settings.threads)},
                 {"search", settings.search},
                 {"parameters",
                  {{"neighbors", settings.neighbors},
                   {"min_angle_degrees", settings.minimum_angle},
                   {"certified_angle_degrees", settings.certified_minimum_angle},
                   {"length_factor", settings.length_factor},
                   {"plain", settings.plain},
                   {"min_region", settings.minimum_internal_points}}},
                 {"warnings", warnings}};
  if (result.filtered) {
    report["internal_share"] = shareOf(result.filter.internal_points, points);
    report["umbrella"] = describeFilter(result.filter);
  }
  return report;
}

std::string
summarizeRun(const ReconstructSettings& settings, const ReconstructResult& result)
{
  const std::size_t points = pointCount(result.model.mesh.cloud);
  const double seconds = totalSeconds(result);
  char internal[32] = "";
  if (result.filtered)
    std::snprintf(internal,
                  sizeof(internal),
                  ", internal %.4f",
                  shareOf(result.filter.internal_points, points));
  char text[256];
  std::snprintf(text,
                sizeof(text),
                ": %zu points, %zu triangles, k %.4f%s, %.3f s (%.2f us/point)",
                points,
                result.model.mesh.polygons.size(),
                shareOf(result.used_points, points),
                internal,
                seconds,
                seconds * 1e6 / static_cast<double>(points));
  return settings.output + text;
}

} // namespace app
