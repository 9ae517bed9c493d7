// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: force lines of a survey and their origins, coloured.
#include "force_line/force_line_tracker.h"
#include "layer_builder.h"

#include <algorithm>
#include <array>

namespace app {
namespace {

using pcl::repair::ForceLine;
using pcl::repair::LineEnd;
using pcl::repair::ModelSurvey;
using pcl::repair::SurveyedField;

constexpr Rgb ATTRACTED{20, 140, 90};
constexpr Rgb REPELLED{150, 150, 150};

/** \brief The quality that a tenth of the bridges exceed: the one drawn as strongest.
 */
double
strongQuality(const std::vector<ForceLine>& lines)
{
  std::vector<double> qualities;
  for (const ForceLine& line : lines)
    if (line.end == LineEnd::BRIDGE)
      qualities.push_back(line.quality);
  if (qualities.empty())
    return 1.0;
  std::sort(qualities.begin(), qualities.end());
  return std::max(qualities[qualities.size() * 9 / 10], 1e-300);
}

Rgb
colorOfLine(const ForceLine& line, double strong_quality)
{
  return line.end == LineEnd::BRIDGE ? colorOfBridge(line.quality / strong_quality)
                                     : colorOf(line.end);
}

void
addLineLegend(const std::vector<ForceLine>& lines, LayerBuilder& builder)
{
  std::array<std::size_t, pcl::repair::LINE_ENDS> counts{};
  for (const ForceLine& line : lines)
    ++counts[static_cast<std::size_t>(line.end)];
  for (std::size_t end = 0; end < counts.size(); ++end) {
    if (counts[end] == 0)
      continue;
    const auto line_end = static_cast<LineEnd>(end);
    if (line_end == LineEnd::BRIDGE) {
      builder.addLegend(colorOfBridge(1.0), "strong bridge");
      builder.addLegend(colorOfBridge(0.0), "weak bridge; in all", counts[end]);
    }
    else
      builder.addLegend(colorOf(line_end), describe(line_end), counts[end]);
  }
}

/** \brief The fields between islands and within holes, in that order. */
std::vector<const SurveyedField*>
allFields(const ModelSurvey& survey)
{
  std::vector<const SurveyedField*> fields{&survey.between_islands};
  for (const SurveyedField& field : survey.in_holes)
    fields.push_back(&field);
  return fields;
}

/** \brief Hairs on a line: so many at most, that they do not hide it. */
constexpr std::size_t HAIRS = 8;

/** \brief Length of hairs that are seen in a picture of the whole model. */
double
visibleLength(const ModelSurvey& survey)
{
  Eigen::AlignedBox3d box;
  for (const auto& island : survey.model.islands)
    box.extend(island.box);
  return 0.015 * box.sizes().norm();
}

} // namespace

std::vector<ForceLine>
visibleLines(const ModelSurvey& survey)
{
  std::vector<ForceLine> lines;
  for (const SurveyedField* field : allFields(survey))
    for (const ForceLine& line : field->lines)
      if (line.points.size() > 1 && line.length > 0.0)
        lines.push_back(resampled(line, survey.spacing));
  return lines;
}

InspectionLayer
showLines(const ModelSurvey& survey)
{
  LayerBuilder builder("lines.vtk",
                       "Force lines by end and strength",
                       {"line_normal", "line", "end", "quality"});
  const std::vector<ForceLine> lines = visibleLines(survey);
  const double strong_quality = strongQuality(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ForceLine& line = lines[i];
    const Rgb color = colorOfLine(line, strong_quality);
    builder.addCurve(line.points.size(), false, [&](std::size_t k) {
      builder.addPoint(
          line.points[k], color, line.normals[k], i, line.end, line.quality);
    });
  }
  addLineLegend(lines, builder);
  return builder.finish(
      "line_normal: external normal along the line; line: number; end: 0 bridge, 1 "
      "repelled, 2 no field, 3 out of reach, 4 too long, 5 crosses the surface, 6 "
      "wrong side; quality: mean force");
}

InspectionLayer
showLineNormals(const ModelSurvey& survey)
{
  LayerBuilder builder("line_normals.vtk", "External normals on the bridges");
  const double longest = visibleLength(survey);
  for (const ForceLine& line : visibleLines(survey)) {
    if (line.end != LineEnd::BRIDGE)
      continue;
    const double length = std::min(longest, 0.3 * line.length);
    const std::size_t stride = 1 + line.points.size() / HAIRS;
    for (std::size_t k = stride / 2; k < line.points.size(); k += stride) {
      const auto root = builder.addPoint(line.points[k], NORMAL_BLUE);
      builder.addPoint(line.points[k] + length * line.normals[k], NORMAL_BLUE);
      builder.addLine(root, 2, false);
    }
  }
  builder.addLegend(NORMAL_BLUE, "normal along a bridge");
  return builder.finish("");
}

InspectionLayer
showLinePoints(const ModelSurvey& survey)
{
  LayerBuilder builder(
      "line_points.pcd", "Points of the bridges", {"normal", "curvature", "line"});
  const std::vector<ForceLine> lines = visibleLines(survey);
  const double strong_quality = strongQuality(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ForceLine& line = lines[i];
    const std::size_t points = line.end == LineEnd::BRIDGE ? line.points.size() : 0;
    for (std::size_t k = 0; k < points; ++k)
      builder.addPoint(line.points[k],
                       colorOfLine(line, strong_quality),
                       line.normals[k],
                       line.quality,
                       i);
  }
  return builder.finish("normal_x ...: external normal; curvature: quality of the "
                        "line; line: as in lines.vtk");
}

InspectionLayer
showOrigins(const ModelSurvey& survey)
{
  LayerBuilder builder("origins.pcd",
                       "Boundary points that the field acts on",
                       {"normal", "curvature", "outward", "hole"});
  for (const SurveyedField* field : allFields(survey))
    for (const auto& place : field->origins) {
      const auto& force = place.force;
      builder.addPoint(place.origin.point.position,
                       force.outward > 0.0 ? ATTRACTED : REPELLED,
                       Eigen::Vector3d(force.normal),
                       force.force.norm(),
                       force.outward,
                       field->hole);
    }
  builder.addLegend(ATTRACTED, "attracted: a line can begin here");
  builder.addLegend(REPELLED, "repelled");
  return builder.finish("normal_x ...: normal of the line that begins here; curvature: "
                        "|f|; outward: share of it away from the surface; hole: the "
                        "loop, for lines within a hole, else -1");
}

} // namespace app
