// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what pcl_repair_holes tells about a model.
#include "repair_report.h"

#include "cli/run_facts.h"
#include "hole_report.h"
#include "io/wording.h"
#include "repair_details.h"
#include "run/threads.h"
#include <nlohmann/json.hpp>

namespace app {
namespace {

using nlohmann::json;
using pcl::repair::LineEnd;
using pcl::repair::ModelSurvey;
using pcl::repair::ReadingReport;

json
describeIslands(const ModelSurvey& survey)
{
  json list = json::array();
  for (std::size_t i = 0; i < survey.model.islands.size(); ++i) {
    const auto& island = survey.model.islands[i];
    const auto& side = survey.sides[i];
    list.push_back({{"triangles", island.triangles},
                    {"area", island.area},
                    {"closed", island.closed}});
    addSide(side, list.back());
  }
  return list;
}

json
describeLoops(const ModelSurvey& survey)
{
  json list = json::array();
  for (std::size_t i = 0; i < survey.loops.size(); ++i) {
    const auto& loop = survey.loops[i];
    const auto& loop_class = survey.classes[i];
    list.push_back({{"island", indexOrMinusOne(loop.island)},
                    {"edges", loop.curve.size()},
                    {"length", loop.length}});
    addClass(loop_class, list.back());
  }
  return list;
}

json
describeEnd(const pcl::repair::BoundaryPoint& point, const Eigen::Vector3d& shift)
{
  return {{"curve", indexOrMinusOne(point.curve)},
          {"edge", point.edge},
          {"share", point.share},
          {"position", describePosition(point.position + shift)}};
}

/** \brief The lines of one step, each with the hole it lies in or -1. */
void
appendLines(const pcl::repair::SurveyedField& field,
            const Eigen::Vector3d& shift,
            json& list)
{
  for (const auto& line : field.lines) {
    json description = {{"hole", indexOrMinusOne(field.hole)},
                        {"origin", describeEnd(line.origin, shift)},
                        {"target", nullptr},
                        {"quality", line.quality},
                        {"length", line.length},
                        {"bridge", line.end == LineEnd::BRIDGE},
                        {"end", describe(line.end)}};
    if (line.end == LineEnd::BRIDGE)
      description["target"] = describeEnd(line.target, shift);
    list.push_back(std::move(description));
  }
}

json
describeLines(const ModelSurvey& survey)
{
  json list = json::array();
  const Eigen::Vector3d& shift = survey.reading.global_shift;
  appendLines(survey.between_islands, shift, list);
  for (const auto& field : survey.in_holes)
    appendLines(field, shift, list);
  return list;
}

json
describeJunctions(const ModelSurvey& survey)
{
  json list = json::array();
  for (const auto& junction : survey.joined.junctions) {
    list.push_back({{"loops",
                     {survey.joined.loops[junction.curves[0]],
                      survey.joined.loops[junction.curves[1]]}},
                    {"lines", junction.lines.size()}});
    addJunction(junction.verdict, junction.confidence, junction.evidence, list.back());
  }
  return list;
}

/** \brief Bridges that would join the islands, and how many holes they leave. */
json
describeBridges(const ModelSurvey& survey)
{
  const auto& joined = survey.joined;
  const Eigen::Vector3d& shift = survey.reading.global_shift;
  json list = json::array();
  for (const auto& bridge : joined.bridges)
    list.push_back({{"from_loop", joined.loops[bridge.begin.curve]},
                    {"to_loop", joined.loops[bridge.end.curve]},
                    {"from", describePosition(bridge.begin.position + shift)},
                    {"to", describePosition(bridge.end.position + shift)},
                    {"quality", bridge.quality}});
  return {{"list", std::move(list)},
          {"deleted", joined.holes.removed_bridges},
          {"holes_left", joined.holes.contours.size()}};
}

std::string
row(const char* name, std::size_t count, const std::string& details)
{
  return formatted("  %-12s %7zu", name, count) +
         (details.empty() ? "" : "  (" + details + ")") + "\n";
}

std::string
tellIslands(const ModelSurvey& survey)
{
  Tally rules;
  std::size_t flipped = 0;
  for (const auto& side : survey.sides) {
    rules.add(describe(side.rule));
    flipped += side.flipped ? 1 : 0;
  }
  return row("islands",
             survey.sides.size(),
             "outer side by: " + rules.text() + "; " + std::to_string(flipped) +
                 " turned round");
}

std::string
tellLoops(const ModelSurvey& survey)
{
  Tally classes;
  for (const auto& loop_class : survey.classes) {
    const bool is_undecided =
        loop_class.boundary_class == pcl::repair::BoundaryClass::UNDECIDED;
    classes.add(describe(loop_class.boundary_class) +
                std::string(is_undecided ? " loop" : ""));
  }
  return row("loops", survey.classes.size(), classes.nouns());
}

std::string
tellLines(const ModelSurvey& survey)
{
  Tally ends;
  std::size_t count = 0;
  const auto add = [&](const pcl::repair::SurveyedField& field) {
    for (const auto& line : field.lines)
      ends.add(describe(line.end));
    count += field.lines.size();
  };
  add(survey.between_islands);
  for (const auto& field : survey.in_holes)
    add(field);
  return row("force lines", count, ends.text());
}

std::string
tellBridges(const ModelSurvey& survey)
{
  const auto& joined = survey.joined;
  if (joined.bridges.empty())
    return "";
  return row("bridges",
             joined.bridges.size() - joined.holes.removed_bridges.size(),
             "would join islands and leave " +
                 plural(joined.holes.contours.size(), "hole") + "; " +
                 std::to_string(joined.holes.removed_bridges.size()) + " deleted");
}

/** \brief What was not taken as it is; empty if nothing. */
std::string
tellReading(const ReadingReport& reading)
{
  std::string text;
  const auto tell = [&](std::size_t count, const char* word, const char* what) {
    if (count > 0)
      addToList(text, plural(count, word) + " " + what);
  };
  tell(reading.invalid_polygons, "invalid polygon", "left out");
  tell(reading.non_finite_points, "point", "left out: not finite");
  tell(reading.repeated_triangles, "repeated triangle", "left out");
  tell(reading.overfull_edges, "edge", "of three or more triangles cut");
  tell(reading.separated_fans, "point", "given to fans and sheets that touch");
  tell(reading.twist_triangles, "twisted triangle", "left out");
  tell(reading.dropped_islands, "small island", "dropped");
  tell(reading.reversed_triangles, "triangle", "wound the other way");
  return text.empty() ? "" : "  on reading: " + text + "\n";
}

} // namespace

json
describeSurvey(const RepairSettings& settings,
               const ModelSurvey& survey,
               const Warnings& warnings)
{
  const std::size_t points = survey.model.positions.size();
  return {{"class", nameOf(survey.icm_class)},
          {"triangles", survey.model.triangles.size()},
          {"vertices", points},
          {"free_points", survey.model.free_points.size()},
          {"simple_holes", survey.counts.simple_holes},
          {"complex_holes", survey.counts.complex_holes},
          {"source_spacing", survey.spacing},
          {"reading", describeReading(survey.reading)},
          {"islands", describeIslands(survey)},
          {"loops", describeLoops(survey)},
          {"origins", survey.between_islands.origins.size()},
          {"lines", describeLines(survey)},
          {"junctions", describeJunctions(survey)},
          {"bridges", describeBridges(survey)},
          {"parameters", describeParameters(settings.method)},
          {"stages", describeStages(survey.seconds, points)},
          {"total_seconds", totalSeconds(survey.seconds)},
          {"peak_memory_bytes", peakMemoryBytes()},
          {"threads", pcl::ccaa::resolveThreads(settings.threads)},
          {"warnings", warnings}};
}

json
describeRun(const RepairSettings& settings,
            const pcl::RepairReport& report,
            const Warnings& warnings)
{
  json description = describeRepair(report);
  description["parameters"] = describeParameters(settings.method);
  description["peak_memory_bytes"] = peakMemoryBytes();
  description["threads"] = pcl::ccaa::resolveThreads(settings.threads);
  description["warnings"] = warnings;
  return description;
}

std::string
summarizeSurvey(const RepairSettings& settings, const ModelSurvey& survey)
{
  std::string text = summaryName(settings.files.input(), "standard input") + ": " +
                     nameOf(survey.icm_class) + ", " +
                     plural(survey.counts.islands, "island") + ", " +
                     plural(survey.counts.simple_holes, "simple hole") + ", " +
                     plural(survey.counts.complex_holes, "complex hole") + "\n";
  text += row("triangles", survey.model.triangles.size(), "");
  text +=
      tellIslands(survey) + tellLoops(survey) + tellLines(survey) + tellBridges(survey);
  text += row("free points", survey.model.free_points.size(), "");
  text += tellReading(survey.reading);
  return text + formatted("  %.3f s", totalSeconds(survey.seconds));
}

} // namespace app
