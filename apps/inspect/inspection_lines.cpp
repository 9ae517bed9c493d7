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
    const std::string count = " (" + std::to_string(counts[end]) + ")";
    if (line_end == LineEnd::BRIDGE) {
      builder.addLegend(colorOfBridge(1.0), "strong bridge");
      builder.addLegend(colorOfBridge(0.0), "weak bridge; in all" + count);
    }
    else
      builder.addLegend(colorOf(line_end), describe(line_end) + count);
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
  LayerBuilder builder("lines.vtk", "Force lines by end and strength");
  FieldArray& normals = builder.realField("line_normal", 3);
  FieldArray& numbers = builder.wholeField("line");
  FieldArray& ends = builder.wholeField("end");
  FieldArray& qualities = builder.realField("quality");
  const std::vector<ForceLine> lines = visibleLines(survey);
  const double strong_quality = strongQuality(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ForceLine& line = lines[i];
    pcl::index_t last = -1;
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      last = builder.addPoint(line.points[k], colorOfLine(line, strong_quality));
      appendDirection(normals, line.normals[k]);
      numbers.append(static_cast<std::int32_t>(i));
      ends.append(static_cast<std::int32_t>(line.end));
      qualities.append(static_cast<float>(line.quality));
    }
    const std::size_t size = line.points.size();
    builder.addLine(last + 1 - static_cast<pcl::index_t>(size), size, false);
  }
  addLineLegend(lines, builder);
  return builder.finish(
      "line_normal: external normal along the line; line: number; "
      "end: 0 bridge, 1 repelled, 2 no field, 3 out of reach, 4 too "
      "long, 5 crosses the surface, 6 wrong side; quality: mean force");
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
  LayerBuilder builder("line_points.pcd", "Points of the bridges");
  FieldArray& normals = builder.realField("normal", 3);
  FieldArray& curvatures = builder.realField("curvature");
  FieldArray& numbers = builder.wholeField("line");
  const std::vector<ForceLine> lines = visibleLines(survey);
  const double strong_quality = strongQuality(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const ForceLine& line = lines[i];
    for (std::size_t k = 0; line.end == LineEnd::BRIDGE && k < line.points.size();
         ++k) {
      builder.addPoint(line.points[k], colorOfLine(line, strong_quality));
      appendDirection(normals, line.normals[k]);
      curvatures.append(static_cast<float>(line.quality));
      numbers.append(static_cast<std::int32_t>(i));
    }
  }
  return builder.finish(
      "normal_x ...: external normal; curvature: quality of the line; "
      "line: as in lines.vtk");
}

InspectionLayer
showOrigins(const ModelSurvey& survey)
{
  LayerBuilder builder("origins.pcd", "Boundary points that the field acts on");
  FieldArray& normals = builder.realField("normal", 3);
  FieldArray& forces = builder.realField("curvature");
  FieldArray& outward = builder.realField("outward");
  FieldArray& holes = builder.wholeField("hole");
  for (const SurveyedField* field : allFields(survey))
    for (const auto& place : field->origins) {
      const auto& force = place.force;
      builder.addPoint(place.origin.point.position,
                       force.outward > 0.0 ? ATTRACTED : REPELLED);
      appendDirection(normals, force.normal);
      forces.append(static_cast<float>(force.force.norm()));
      outward.append(static_cast<float>(force.outward));
      holes.append(indexOrMinusOne(field->hole));
    }
  builder.addLegend(ATTRACTED, "attracted: a line can begin here");
  builder.addLegend(REPELLED, "repelled");
  return builder.finish(
      "normal_x ...: normal of the line that begins here; curvature: |f|; "
      "outward: share of it away from the surface; hole: the loop, "
      "for lines within a hole, else -1");
}

} // namespace app
