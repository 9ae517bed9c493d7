// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the stages of the method as the viewer draws them.
#include "viewer/stages.h"

#include "inspect/inspection.h"
#include "inspect/inspection_colors.h"
#include "io/point_columns.h"
#include "render/drawing.h"
#include "render/mesh_parts.h"
#include "render/stage_builder.h"
#include "viewer/viewer_run.h"

namespace app {
namespace {

using pcl::TriangleOrigin;
using pcl::repair::ModelSurvey;

/** \brief What most stages show below their own. */
struct Background {
  vtkSmartPointer<vtkPolyData> surface; /**< the islands, wound outward */
  vtkSmartPointer<vtkPolyData> boundary;
  InspectionLayer free_points;
};

Background
makeBackground(const ModelSurvey& survey)
{
  Background background;
  background.surface = makePart(showIslands(survey));
  background.boundary = makePart(showLoops(survey));
  background.free_points = showFreePoints(survey);
  return background;
}

void
addBackground(const Background& background, StageBuilder& stage)
{
  stage.addSurface(background.surface, OUTER_SIDE_PALE, INNER_SIDE_PALE);
}

void
addThinBoundary(const Background& background, StageBuilder& stage)
{
  stage.addMarks(Layer::LINES, background.boundary, BOUNDARY_GREY, THIN, "");
  if (background.boundary->GetNumberOfLines() > 0)
    stage.addLegend(Layer::LINES, BOUNDARY_GREY, "boundary");
}

Stage
boundaryStage(const ModelSurvey& survey, const Background& background)
{
  StageBuilder stage("boundaries",
                     "Boundaries by class",
                     "Each boundary is told by itself: a hole, the rim of an island, "
                     "or the outer border of the surface.");
  addBackground(background, stage);
  stage.addLayer(Layer::LINES, showLoops(survey), THICK);
  stage.addLegend(Layer::INNER_SIDE, INNER_SIDE_PALE, "inner side");
  if (survey.loops.empty())
    stage.setText("The surface is closed: it has no boundary.");
  return stage.finish();
}

Stage
lineStage(const ModelSurvey& survey, const Background& background)
{
  StageBuilder stage("lines",
                     "Force lines",
                     "From the boundaries lines run along the pull of the others. "
                     "Those that reach one may become bridges.");
  addBackground(background, stage);
  const InspectionLayer lines = showLines(survey);
  stage.addLayer(Layer::LINES, lines, MEDIUM);
  stage.addLayer(Layer::NORMALS, showLineNormals(survey), THIN);
  stage.addLayer(Layer::POINTS, background.free_points, DOT);
  addThinBoundary(background, stage);
  if (pointCount(lines.cloud) == 0)
    stage.setText("There are no force lines: no two islands, and no hole that is too "
                  "large to be closed as it is.");
  return stage.finish();
}

Stage
bridgeStage(const ViewerRun& run, const Background& background)
{
  StageBuilder stage(
      "bridges",
      "Bridges",
      "The best lines become bridges. They join islands and divide large holes.");
  addBackground(background, stage);
  stage.addLayer(Layer::LINES, showBridges(run.repair.bridges, run.input.shift), THICK);
  stage.addLayer(Layer::POINTS, background.free_points, DOT);
  addThinBoundary(background, stage);
  if (run.repair.bridges.empty())
    stage.setText("No bridge was needed, or none was found.");
  return stage.finish();
}

Stage
holeStage(const ViewerRun& run, const Background& background)
{
  StageBuilder stage("holes",
                     "Holes after bridging",
                     "Boundaries and bridges enclose holes. Each is closed by itself, "
                     "or left open for a reason.");
  addBackground(background, stage);
  stage.addLayer(Layer::LINES, showContours(run.repair, run.result), THICK);
  stage.addLayer(Layer::POINTS, background.free_points, DOT);
  if (run.repair.holes.empty())
    stage.setText("The surface is closed: it has no hole.");
  return stage.finish();
}

Stage
resultStage(const ViewerRun& run)
{
  StageBuilder stage("result",
                     "Result",
                     "All that was given is kept. What is new is as dense as the "
                     "surface around it, and smooth.");
  for (const TriangleOrigin origin : {TriangleOrigin::INPUT,
                                      TriangleOrigin::FAN,
                                      TriangleOrigin::MINIMUM_WEIGHT,
                                      TriangleOrigin::COMPLETION}) {
    std::vector<pcl::Vertices> triangles;
    for (std::size_t t = 0; t < run.result.polygons.size(); ++t)
      if (run.repair.origins[t] == origin)
        triangles.push_back(run.result.polygons[t]);
    if (triangles.empty())
      continue;
    const std::string meaning = origin == TriangleOrigin::INPUT
                                    ? "given triangles"
                                    : std::string("new: ") + describe(origin);
    stage.addSurface(takeApart(run.result.cloud, triangles, run.input.shift).faces,
                     origin == TriangleOrigin::INPUT ? OUTER_SIDE_PALE
                                                     : colorOf(origin),
                     meaning);
  }
  stage.addLegend(Layer::INNER_SIDE, INNER_SIDE_PALE, "inner side");
  const MeshParts parts = takeApart(run.result, run.input.shift);
  stage.addMarks(
      Layer::LINES, parts.boundaries, BOUNDARY_GREY, MEDIUM, "boundary edges");
  stage.addMarks(
      Layer::POINTS, parts.free_points, FREE_POINT_VIOLET, DOT, "free points");
  if (run.repair.new_triangles == 0)
    stage.setText("Nothing was closed: the result is the surface that was given.");
  return stage.finish();
}

/** \brief A stage that did not come about, with the reason. */
Stage
missingStage(const std::string& name, const std::string& reason)
{
  return StageBuilder(name, "Nothing to see", reason).finish();
}

} // namespace

const std::vector<std::string>&
stageNames()
{
  static const std::vector<std::string> names{"cloud",
                                              "start",
                                              "filter",
                                              "base",
                                              "boundaries",
                                              "lines",
                                              "bridges",
                                              "holes",
                                              "result",
                                              "mesh"};
  return names;
}

std::vector<Stage>
makeStages(const ViewerRun& run, const Eigen::Vector3d& view)
{
  std::vector<Stage> stages;
  if (run.from_cloud)
    stages = cloudStages(run, view);
  else
    stages = {meshStage(run)};
  if (!run.problem.empty()) {
    for (const char* name : {"boundaries", "lines", "bridges", "holes", "result"})
      stages.push_back(missingStage(name, "There is no surface: " + run.problem + "."));
    return stages;
  }
  const Background background = makeBackground(run.survey);
  stages.push_back(boundaryStage(run.survey, background));
  stages.push_back(lineStage(run.survey, background));
  if (!run.repaired) {
    for (const char* name : {"bridges", "holes", "result"})
      stages.push_back(missingStage(name, "The surface was not repaired."));
    return stages;
  }
  stages.push_back(bridgeStage(run, background));
  stages.push_back(holeStage(run, background));
  stages.push_back(resultStage(run));
  return stages;
}

} // namespace app
