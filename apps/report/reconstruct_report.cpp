// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what pcl_ccaa_reconstruct tells about a run.
#include "reconstruct_report.h"

#include "cli/repair_run.h"
#include "hole_report.h"
#include "io/point_columns.h"
#include "io/remarks.h"
#include "io/wording.h"
#include "mesh/cloud_access.h"
#include "repair_details.h"
#include "run/threads.h"
#include <nlohmann/json.hpp>

#include <algorithm>

namespace app {
namespace {

using nlohmann::json;

double
shareOf(std::size_t part, std::size_t whole)
{
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

/** Keys as the thesis has them (3.1, 3.5); seconds, and seconds a point. */
json
describeSpeedup(const pcl::SpeedupReport& speedup)
{
  return {{"t_A", speedup.base_seconds},
          {"t_BA", speedup.chain_seconds},
          {"S", speedup.speedup},
          {"c_A", speedup.base_cost},
          {"c_B", speedup.start_cost},
          {"c_F", speedup.filter_cost},
          {"k", speedup.connected_share},
          {"condition_holds", speedup.is_advantageous}};
}

/** Where the topology of the reconstruction is in doubt, as doubts about a repair are
 * told. */
json
describeDoubts(const pcl::TopologyDoubts& doubts)
{
  json list = json::array();
  for (const pcl::index_t point : doubts.thin_handles)
    list.push_back({{"reason", "THIN_HANDLE"}, {"points", {point}}});
  for (const auto& contact : doubts.touching_pieces)
    list.push_back({{"reason", "TOUCHING_PIECES"}, {"points", contact}});
  for (const pcl::index_t point : doubts.thin_necks)
    list.push_back({{"reason", "THIN_NECK"}, {"points", {point}}});
  return list;
}

/** What is known only of the stages that were run. */
void
describeLaterStages(const ReconstructSettings& settings,
                    const ReconstructResult& result,
                    json& report)
{
  const pcl::ConsecutiveReport& chain = result.chain;
  if (settings.hasFilter()) {
    report["internal_share"] = chain.internalShare();
    report["c_F"] = chain.filterCost();
    report["umbrella"] = describeFilter(result.filter);
  }
  if (settings.until == "base") {
    report["base_seconds"] = chain.base_seconds;
    report["base_seconds_per_open_point"] = chain.baseCost();
  }
  if (result.topology)
    report.update(describeTopology(*result.topology));
  if (result.repair)
    report["repair"] = describeRepair(*result.repair);
  if (result.speedup)
    report["speedup"] = describeSpeedup(*result.speedup);
  for (const pcl::ChainStageReport& stage : chain.stages)
    report["triangles_by_stage"][stage.name] = stage.triangles;
}

/** How many points are finite, and the box around them. */
std::pair<std::size_t, Eigen::AlignedBox3f>
extentOf(const Model& model)
{
  std::pair<std::size_t, Eigen::AlignedBox3f> extent;
  for (const Eigen::Vector3f& position : readPositions(model.mesh.cloud, model.shift))
    if (position.allFinite()) {
      extent.second.extend(position);
      ++extent.first;
    }
  return extent;
}

/** Triangles by what told their outer side; nothing where none are wound alike. */
json
describeSides(const ReconstructResult& result)
{
  json sides = json::object();
  for (std::size_t i = 0; i < pcl::ccaa::OUTWARD_RULES; ++i)
    if (result.sides.triangles[i] > 0)
      sides[describe(static_cast<pcl::ccaa::OutwardRule>(i))] =
          result.sides.triangles[i];
  return sides;
}

/** What of a cloud the outer side will be asked first. */
std::string
outerSideBy(const pcl::ccaa::SideHints& told, const Model& model)
{
  using pcl::ccaa::OutwardRule;
  if (told.told_viewpoint)
    return describe(OutwardRule::TOLD_VIEWPOINT);
  if (told.up)
    return describe(OutwardRule::UP);
  if (!pcl::ccaa::normalView(model.mesh.cloud).empty())
    return "normals";
  if (!pcl::ccaa::viewpointView(model.mesh.cloud).empty())
    return "viewpoints of points";
  const Eigen::Vector3d offset = model.shift.offset();
  auto hints = relativeTo(offset, sidesOf(told, model.viewpoint));
  takeOrigin(hints, pcl::ccaa::positionView(model.mesh.cloud).relativeTo(offset));
  if (hints.viewpoint_is_origin)
    return describe(OutwardRule::ORIGIN);
  return hints.viewpoint ? "the viewpoint" : "the shape";
}

} // namespace

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

json
describeCleaning(const CleanReport& cleaning)
{
  return {{"input_points", cleaning.input_points},
          {"skipped_points", cleaning.skipped_points},
          {"grid_points", cleaning.grid_points},
          {"outliers", cleaning.outliers},
          {"in_two_sheets", cleaning.in_two_sheets},
          {"output_points", cleaning.output_points},
          {"spacing", cleaning.spacing},
          {"radius", cleaning.radius},
          {"moved", cleaning.moved},
          {"moved_most", cleaning.moved_most},
          {"moved_together", cleaning.moved_together}};
}

std::string
tellCleaning(const CleanReport& cleaning)
{
  if (cleaning.output_points == 0)
    return "cleaning: nothing done";
  return "cleaning: " + plural(cleaning.input_points, "point") + ", " +
         std::to_string(cleaning.grid_points) + " after the grid, " +
         plural(cleaning.outliers, "outlier") +
         formatted(" away, the others moved by %.3g (at most %.3g) onto patches of "
                   "radius %.3g; ",
                   cleaning.moved,
                   cleaning.moved_most,
                   cleaning.radius) +
         plural(cleaning.output_points, "point") +
         formatted(" left, at least %.3g apart", cleaning.spacing);
}

json
describeRun(const ReconstructSettings& settings,
            const ReconstructResult& result,
            const Warnings& warnings)
{
  const std::size_t points = pointCount(result.model.mesh.cloud);
  const std::size_t peak = peakMemoryBytes();
  const std::size_t added = peak - std::min(peak, result.memory_before);
  json report = {
      {"until", settings.until},
      {"N", points},
      {"usable_points", result.start.points},
      {"k", result.chain.connectedShare()},
      {"k_usable", shareOf(result.chain.connected_points, result.start.points)},
      {"internal_share", nullptr},
      {"free_points", result.chain.free_points},
      {"doubtful_handles", result.chain.doubts.handles},
      {"touching_pieces", result.chain.doubts.touching_pieces.size()},
      {"thin_necks", result.chain.doubts.thin_necks.size()},
      {"doubts", describeDoubts(result.chain.doubts)},
      {"triangles", result.model.mesh.polygons.size()},
      {"pieces", nullptr},
      {"boundary_loops", nullptr},
      {"outer_side", describeSides(result)},
      {"outer_side_by", describe(result.sides)},
      {"euler_characteristic", nullptr},
      {"genus", nullptr},
      {"watertight", nullptr},
      {"c_B", result.chain.startCost()},
      {"c_F", nullptr},
      {"base_seconds", nullptr},
      {"stages", describeStages(result.stages, points)},
      {"total_seconds", totalSeconds(result.stages)},
      {"peak_memory_bytes", peak},
      {"peak_bytes_per_point", shareOf(added, points)},
      {"threads", pcl::ccaa::resolveThreads(settings.threads)},
      {"start", result.has_grid_start ? "grid" : "greedy"},
      {"line_gap", result.start.line_gap},
      {"search", settings.search},
      {"parameters",
       {{"neighbors", settings.neighbors},
        {"min_angle_degrees", settings.minimum_angle},
        {"certified_angle_degrees", settings.certified_minimum_angle},
        {"length_factor", settings.length_factor},
        {"plain", settings.plain},
        {"min_region", settings.minimum_internal_points}}},
      {"warnings", warnings}};
  if (result.cleaning)
    report["cleaning"] = describeCleaning(*result.cleaning);
  describeLaterStages(settings, result, report);
  return report;
}

json
describeInput(const ReconstructSettings& settings, const Model& model)
{
  const pcl::PCLPointCloud2& cloud = model.mesh.cloud;
  const auto [finite, box] = extentOf(model);
  json fields = json::array();
  for (const pcl::PCLPointField& field : cloud.fields)
    fields.push_back(field.name);
  const Eigen::Vector3f sizes =
      finite == 0 ? Eigen::Vector3f::Zero().eval() : box.sizes().eval();
  return {{"dry_run", true},
          {"N", pointCount(cloud)},
          {"finite_points", finite},
          {"fields", fields},
          {"width", cloud.width},
          {"height", cloud.height},
          {"extent", {sizes.x(), sizes.y(), sizes.z()}},
          {"outer_side_by", outerSideBy(settings.sides, model)},
          {"warnings", model.warnings}};
}

std::string
summarizeInput(const ReconstructSettings& settings, const Model& model)
{
  const pcl::PCLPointCloud2& cloud = model.mesh.cloud;
  std::string fields;
  for (const pcl::PCLPointField& field : cloud.fields)
    fields += " " + field.name;
  const std::string units = namedUnits(model.remarks);
  const std::string name = settings.files.inputs.size() > 1
                               ? settings.inputName()
                               : summaryName(settings.files.input(), "standard input");
  return name + ": " + plural(pointCount(cloud), "point") + ", " +
         std::to_string(extentOf(model).first) + " of them finite; fields" + fields +
         "; outer side by " + outerSideBy(settings.sides, model) +
         (units.empty() ? "" : "; units " + units);
}

std::string
summarizeRun(const ReconstructSettings& settings, const ReconstructResult& result)
{
  const std::size_t count = pointCount(result.model.mesh.cloud);
  const auto points = static_cast<double>(count);
  const double seconds = totalSeconds(result.stages);
  std::string line = summaryName(settings.files.output) + ": " +
                     plural(count, "point") + ", " +
                     std::to_string(result.chain.free_points) + " free, " +
                     plural(result.model.mesh.polygons.size(), "triangle");
  if (result.repair)
    line += ", " + std::to_string(result.repair->new_triangles) + " of them by repair";
  if (result.topology)
    line += ", " + plural(result.topology->boundary_loops, "boundary loop") + ", " +
            summarizeTopology(*result.topology);
  if (result.has_grid_start)
    line += ", begun with the grid of the cloud";
  if (const std::string sides = describe(result.sides); !sides.empty())
    line += "; outer side by " + sides;
  std::string stages;
  for (const auto& [stage, stage_seconds] : result.stages)
    addToList(stages,
              formatted("%s %.2f", stage.c_str(), stage_seconds * 1e6 / points));
  return line +
         formatted("; k %.4f, internal %.4f; %.3f s, us/point: %.2f (",
                   result.chain.connectedShare(),
                   result.chain.internalShare(),
                   seconds,
                   seconds * 1e6 / points) +
         stages + ")";
}

std::string
tabulateSpeedup(const pcl::SpeedupReport& speedup)
{
  const std::string row =
      formatted("%9zu %7.4f %9.4f %9.4f %7.2f %8.3f %8.3f %8.3f  %s",
                speedup.points,
                speedup.connected_share,
                speedup.base_seconds,
                speedup.chain_seconds,
                speedup.speedup,
                speedup.base_cost * 1e6,
                speedup.start_cost * 1e6,
                speedup.filter_cost * 1e6,
                speedup.is_advantageous ? "yes" : "no");
  return "        N       k   t_A [s]  t_BA [s]       S c_A [us] c_B [us] c_F [us]  k "
         "c_A > c_B + c_F\n" +
         row;
}

} // namespace app
