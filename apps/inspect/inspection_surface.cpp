// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: loops, islands and free points of a survey, coloured.
#include "icadm/model_assembly.h"
#include "layer_builder.h"

#include <map>

namespace app {
namespace {

using pcl::repair::BoundaryClass;
using pcl::repair::IslandSide;
using pcl::repair::ModelSurvey;
using pcl::repair::SideRule;

std::string
withCount(const std::string& name, std::size_t count)
{
  return name + " (" + std::to_string(count) + ")";
}

void
addLoopLegend(const ModelSurvey& survey, LayerBuilder& builder)
{
  std::map<BoundaryClass, std::size_t> counts;
  for (const auto& loop_class : survey.classes)
    ++counts[loop_class.boundary_class];
  for (const auto& [boundary_class, count] : counts)
    builder.addLegend(colorOf(boundary_class),
                      withCount(describe(boundary_class), count));
}

void
addIslandLegend(const ModelSurvey& survey, LayerBuilder& builder)
{
  std::map<std::pair<SideRule, bool>, std::size_t> counts;
  for (const IslandSide& side : survey.sides)
    ++counts[{side.rule, side.flipped}];
  for (const auto& [key, count] : counts) {
    IslandSide side;
    side.rule = key.first;
    side.flipped = key.second;
    const std::string turned = side.flipped ? ", turned round" : "";
    builder.addLegend(colorOf(side), withCount(describe(side.rule) + turned, count));
  }
}

/** \brief The island of each vertex. */
std::vector<std::size_t>
islandsOfVertices(const pcl::repair::IncompleteModel& model)
{
  std::vector<std::size_t> islands(model.positions.size(), pcl::repair::NONE);
  for (std::size_t t = 0; t < model.triangles.size(); ++t)
    for (const pcl::index_t vertex : model.triangles[t])
      islands[static_cast<std::size_t>(vertex)] = model.island_of[t];
  return islands;
}

} // namespace

InspectionLayer
showLoops(const ModelSurvey& survey)
{
  LayerBuilder builder("loops.vtk", "Boundary loops by class");
  FieldArray& classes = builder.wholeField("class");
  FieldArray& confidences = builder.realField("confidence");
  FieldArray& numbers = builder.wholeField("loop");
  FieldArray& islands = builder.wholeField("island");
  for (std::size_t i = 0; i < survey.loops.size(); ++i) {
    const auto& loop = survey.loops[i];
    const auto& loop_class = survey.classes[i];
    pcl::index_t last = -1;
    for (const auto& position : loop.curve.points) {
      last = builder.addPoint(position, colorOf(loop_class.boundary_class));
      classes.append(static_cast<std::int32_t>(loop_class.boundary_class));
      confidences.append(static_cast<float>(loop_class.confidence));
      numbers.append(static_cast<std::int32_t>(i));
      islands.append(indexOrMinusOne(loop.island));
    }
    const std::size_t size = loop.curve.size();
    builder.addLine(last + 1 - static_cast<pcl::index_t>(size), size, true);
  }
  addLoopLegend(survey, builder);
  return builder.finish("class: 0 hole, 1 island rim, 2 outer border, 3 undecided; "
                        "confidence: 0 to 1; loop, island: as in the report");
}

InspectionLayer
showIslands(const ModelSurvey& survey)
{
  LayerBuilder builder("islands.vtk", "Islands by what told the outer side");
  FieldArray& normals = builder.realField("normal", 3);
  FieldArray& numbers = builder.wholeField("island");
  FieldArray& rules = builder.wholeField("rule");
  FieldArray& flips = builder.wholeField("flipped");
  const auto islands = islandsOfVertices(survey.model);
  const auto external =
      pcl::repair::externalNormals(survey.model.triangles, survey.model.positions, {});
  for (std::size_t v = 0; v < survey.model.positions.size(); ++v) {
    const IslandSide& side = survey.sides[islands[v]];
    builder.addPoint(survey.model.positions[v], colorOf(side));
    appendDirection(normals, external[v]);
    numbers.append(indexOrMinusOne(islands[v]));
    rules.append(static_cast<std::int32_t>(side.rule));
    flips.append(static_cast<std::int32_t>(side.flipped));
  }
  for (const auto& triangle : survey.model.triangles)
    builder.addFace({triangle.begin(), triangle.end()});
  addIslandLegend(survey, builder);
  return builder.finish(
      "normal: external; island: as in the report; rule: 0 given normals, 1 viewpoint, "
      "2 volume, 3 free sight, 4 field, 5 undecided, 6 one-sided, 7 viewpoint told, 8 "
      "up "
      "told, 9 up guessed, 10 origin as viewpoint; flipped: 1 when the island was "
      "turned "
      "round");
}

InspectionLayer
showFreePoints(const ModelSurvey& survey)
{
  LayerBuilder builder("free_points.pcd", "Points without a triangle");
  FieldArray& origins = builder.wholeField("cloud_index");
  for (std::size_t i = 0; i < survey.model.free_points.size(); ++i) {
    builder.addPoint(survey.model.free_points[i], FREE_POINT_VIOLET);
    origins.append(static_cast<std::int32_t>(survey.model.point_of_free_point[i]));
  }
  builder.addLegend(FREE_POINT_VIOLET,
                    withCount("free point", survey.model.free_points.size()));
  return builder.finish(
      "cloud_index: of the point in the input mesh, -1 for one of the "
      "separate cloud");
}

} // namespace app
