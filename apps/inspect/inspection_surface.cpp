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

void
addLoopLegend(const ModelSurvey& survey, LayerBuilder& builder)
{
  std::map<BoundaryClass, std::size_t> counts;
  for (const auto& loop_class : survey.classes)
    ++counts[loop_class.boundary_class];
  for (const auto& [boundary_class, count] : counts)
    builder.addLegend(colorOf(boundary_class), describe(boundary_class), count);
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
    builder.addLegend(colorOf(side), describe(side.rule) + turned, count);
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
  LayerBuilder builder("loops.vtk",
                       "Boundary loops by class",
                       {"class", "confidence", "loop", "island"});
  for (std::size_t i = 0; i < survey.loops.size(); ++i) {
    const auto& loop = survey.loops[i];
    const auto& decided = survey.classes[i];
    builder.addCurve(loop.curve.size(), true, [&](std::size_t k) {
      builder.addPoint(loop.curve.points[k],
                       colorOf(decided.boundary_class),
                       decided.boundary_class,
                       decided.confidence,
                       i,
                       loop.island);
    });
  }
  addLoopLegend(survey, builder);
  return builder.finish("class: 0 hole, 1 island rim, 2 outer border, 3 undecided; "
                        "confidence: 0 to 1; loop, island: as in the report");
}

InspectionLayer
showIslands(const ModelSurvey& survey)
{
  LayerBuilder builder("islands.vtk",
                       "Islands by what told the outer side",
                       {"normal", "island", "rule", "flipped"});
  const auto islands = islandsOfVertices(survey.model);
  const auto external =
      pcl::repair::externalNormals(survey.model.triangles, survey.model.positions, {});
  for (std::size_t v = 0; v < survey.model.positions.size(); ++v) {
    const IslandSide& side = survey.sides[islands[v]];
    builder.addPoint(survey.model.positions[v],
                     colorOf(side),
                     Eigen::Vector3d(external[v]),
                     islands[v],
                     side.rule,
                     side.flipped);
  }
  for (const auto& triangle : survey.model.triangles)
    builder.addFace({triangle.begin(), triangle.end()});
  addIslandLegend(survey, builder);
  return builder.finish(
      "normal: external; island: as in the report; rule: 0 given normals, 1 viewpoint, "
      "2 volume, 3 free sight, 4 field, 5 undecided, 6 one-sided, 7 viewpoint told, 8 "
      "up told, 9 up guessed, 10 origin as viewpoint; flipped: 1 when the island was "
      "turned round");
}

InspectionLayer
showFreePoints(const ModelSurvey& survey)
{
  LayerBuilder builder("free_points.pcd", "Points without a triangle", {"cloud_index"});
  const auto& model = survey.model;
  for (std::size_t i = 0; i < model.free_points.size(); ++i)
    builder.addPoint(
        model.free_points[i], FREE_POINT_VIOLET, model.point_of_free_point[i]);
  builder.addLegend(FREE_POINT_VIOLET, "free point", model.free_points.size());
  return builder.finish(
      "cloud_index: of the point in the input mesh, -1 for one of the separate cloud");
}

} // namespace app
