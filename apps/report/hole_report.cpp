// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is told about a repair.
#include "hole_report.h"

#include "io/point_columns.h"
#include "io/position_check.h"
#include "io/wording.h"
#include "mesh/cloud_access.h"
#include "repair_details.h"
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace app {
namespace {

using nlohmann::json;
using pcl::OpenReason;
using pcl::RepairBridge;
using pcl::RepairedHole;
using pcl::RepairReport;

json
describeIslands(const RepairReport& report)
{
  json list = json::array();
  for (const pcl::RepairedIsland& island : report.islands) {
    list.push_back({{"triangles", island.triangles},
                    {"area", island.area},
                    {"closed", island.closed},
                    {"one_sided", island.one_sided}});
    addSide(island.side, list.back());
  }
  return list;
}

json
describeLoops(const RepairReport& report)
{
  json list = json::array();
  for (const pcl::RepairedLoop& loop : report.loops) {
    list.push_back({{"island", indexOrMinusOne(loop.island)},
                    {"edges", loop.edges},
                    {"length", loop.length},
                    {"point", loop.point}});
    addClass(loop.decided, list.back());
  }
  return list;
}

double
lengthOf(const RepairBridge& bridge)
{
  double length = 0.0;
  for (std::size_t k = 1; k < bridge.points.size(); ++k)
    length += (bridge.points[k] - bridge.points[k - 1]).norm();
  return length;
}

json
describeJunctions(const RepairReport& report)
{
  json list = json::array();
  for (const pcl::RepairJunction& junction : report.junctions) {
    list.push_back({{"pass", junction.pass},
                    {"points", junction.points},
                    {"islands", junction.islands},
                    {"lines", junction.lines},
                    {"between_mouths", junction.between_mouths}});
    addJunction(junction.verdict, junction.confidence, junction.evidence, list.back());
  }
  return list;
}

json
describeBridges(const RepairReport& report)
{
  json list = json::array();
  for (const RepairBridge& bridge : report.bridges)
    list.push_back({{"begin", bridge.begin},
                    {"end", bridge.end},
                    {"begin_island", indexOrMinusOne(bridge.begin_island)},
                    {"end_island", indexOrMinusOne(bridge.end_island)},
                    {"points", bridge.points.size()},
                    {"length", lengthOf(bridge)},
                    {"quality", bridge.quality},
                    {"within_hole", bridge.within_hole}});
  return list;
}

json
describeHoles(const RepairReport& report)
{
  json list = json::array();
  for (const RepairedHole& hole : report.holes)
    list.push_back({{"edges", hole.edges},
                    {"length", hole.length},
                    {"point", hole.point},
                    {"islands", hole.islands},
                    {"bridges", hole.bridges},
                    {"closed", hole.open == OpenReason::NONE},
                    {"shortfall", hole.shortfall},
                    {"why", describe(hole.open)},
                    {"filling", hole.filling},
                    {"triangles", hole.triangles},
                    {"tries", hole.tries},
                    {"free_points", hole.free_points}});
  return list;
}

json
describeDoubts(const RepairReport& report)
{
  json list = json::array();
  for (const pcl::RepairDoubt& doubt : report.doubts)
    list.push_back({{"reason", nameOf(doubt.reason)},
                    {"why", describe(doubt.reason)},
                    {"points", doubt.points},
                    {"ratio", doubt.ratio}});
  return list;
}

json
describeState(const pcl::repair::IcmCounts& counts,
              pcl::repair::IcmClass icm_class,
              const pcl::ccaa::SurfaceTopology& topology)
{
  json state = {{"class", nameOf(icm_class)},
                {"islands", counts.islands},
                {"simple_holes", counts.simple_holes},
                {"complex_holes", counts.complex_holes}};
  state.update(describeTopology(topology));
  return state;
}

json
describeTriangles(const RepairReport& report)
{
  json triangles = {{"input", report.input_triangles}, {"new", report.new_triangles}};
  for (const pcl::TriangleOrigin origin : {pcl::TriangleOrigin::FAN,
                                           pcl::TriangleOrigin::MINIMUM_WEIGHT,
                                           pcl::TriangleOrigin::COMPLETION}) {
    std::string name = describe(origin);
    std::replace(name.begin(), name.end(), ' ', '_');
    triangles[name] = std::count(report.origins.begin(), report.origins.end(), origin);
  }
  return triangles;
}

/** \brief Whether it is open because the user wants it so. */
bool
isAskedFor(const RepairedHole& hole)
{
  return !hole.shortfall &&
         (hole.open == OpenReason::TOO_LARGE || hole.open == OpenReason::NOT_WANTED);
}

} // namespace

std::string
placeOf(pcl::index_t number, const pcl::PolygonMesh& mesh)
{
  if (number < 0)
    return "";
  const auto point = static_cast<std::size_t>(number);
  std::string place = "at point " + std::to_string(number);
  if (point >= pointCount(mesh.cloud))
    return place;
  return place + ", " + placeIn(mesh.cloud, pcl::ccaa::positionView(mesh.cloud)[point]);
}

json
describeRepair(const RepairReport& report)
{
  return {
      {"complete", report.complete()},
      {"shortfalls", report.shortfalls},
      {"before",
       describeState(report.counts_before, report.class_before, report.before)},
      {"after", describeState(report.counts_after, report.class_after, report.after)},
      {"reading", describeReading(report.reading)},
      {"islands", describeIslands(report)},
      {"loops", describeLoops(report)},
      {"junctions", describeJunctions(report)},
      {"bridges", describeBridges(report)},
      {"holes", describeHoles(report)},
      {"doubts", describeDoubts(report)},
      {"triangles", describeTriangles(report)},
      {"new_vertices", report.new_vertices},
      {"free_points", report.free_points},
      {"steps",
       describeStages(report.seconds,
                      std::max<std::size_t>(report.input_triangles, 1))},
      {"seconds", totalSeconds(report.seconds)}};
}

std::string
summarizeRepair(const RepairReport& report)
{
  Tally fillings;
  std::size_t closed = 0;
  std::size_t borders = 0;
  std::size_t wanted = 0;
  for (const RepairedHole& hole : report.holes) {
    closed += hole.open == OpenReason::NONE ? 1 : 0;
    wanted += isAskedFor(hole) ? 1 : 0;
    borders +=
        hole.open != OpenReason::NONE && !hole.shortfall && !isAskedFor(hole) ? 1 : 0;
    if (!hole.filling.empty())
      fillings.add(hole.filling);
  }
  std::string text = std::string(nameOf(report.class_before)) + " -> " +
                     nameOf(report.class_after) + ", " +
                     plural(report.islands.size(), "island") + " -> " +
                     std::to_string(report.counts_after.islands) + ", " +
                     plural(report.bridges.size(), "bridge") + ", " +
                     plural(closed, "hole") + " closed";
  if (closed > 0)
    text += " (" + fillings.text() + ")";
  if (report.shortfalls > 0)
    text += ", " + std::to_string(report.shortfalls) + " left open";
  if (borders > 0)
    text += ", " + plural(borders, "border") + " kept";
  if (wanted > 0)
    text += ", " + std::to_string(wanted) + " left open as asked for";
  if (report.reading.dropped_islands > 0)
    text += ", " + plural(report.reading.dropped_islands, "small island") + " dropped";
  return text + ", " + std::to_string(report.input_triangles) + " + " +
         plural(report.new_triangles, "triangle") + ", " +
         summarizeTopology(report.after) +
         formatted("; %.3f s", totalSeconds(report.seconds));
}

std::string
tellShortfalls(const RepairReport& report, const pcl::PolygonMesh& mesh)
{
  std::map<OpenReason, std::vector<const RepairedHole*>> groups;
  for (const RepairedHole& hole : report.holes)
    if (hole.shortfall)
      groups[hole.open].push_back(&hole);
  std::string text;
  for (const auto& [reason, holes] : groups) {
    const std::string place = placeOf(holes.front()->point, mesh);
    const bool is_one = holes.size() == 1;
    text += (text.empty() ? "" : ". ") + pluralIs(holes.size(), "boundary loop") +
            " left open" + (is_one ? " because " : ", each because ") +
            describe(reason);
    if (!place.empty())
      text += std::string(" (") + (is_one ? "" : "one is ") + place + ")";
  }
  std::map<pcl::DoubtReason, std::vector<const pcl::RepairDoubt*>> doubts;
  for (const pcl::RepairDoubt& doubt : report.doubts)
    doubts[doubt.reason].push_back(&doubt);
  for (const auto& [reason, alike] : doubts) {
    const pcl::RepairDoubt& first = *alike.front();
    text += (text.empty() ? "" : ". ") + std::string(describe(reason));
    if (reason == pcl::DoubtReason::UNSUPPORTED)
      text += formatted(" (%.0f %%)", 100.0 * first.ratio);
    else
      text +=
          (alike.size() == 1 ? " (" : formatted(" (%zu times, once ", alike.size())) +
          placeOf(first.points[0], mesh) +
          (first.points[1] < 0 ? "" : " and " + placeOf(first.points[1], mesh)) + ")";
  }
  return text;
}

FaceProperty
originProperty(const RepairReport& report)
{
  FaceProperty property;
  property.name = "origin";
  for (const pcl::TriangleOrigin origin : report.origins)
    property.values.push_back(static_cast<std::int32_t>(origin));
  return property;
}

} // namespace app
