// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all that can be told about an incomplete model.

#include <pcl/surface_repair/boundary/extraction.h>
#include <pcl/surface_repair/model_survey.h>

#include "survey_fields.h"

#include <algorithm>
#include <chrono>

namespace pcl {
namespace repair {

namespace {

/** Notes how long each stage took. */
class StageClock {
public:
  explicit StageClock(ModelSurvey& survey) : survey_(survey) {}

  void
  finish(const char* stage)
  {
    const Clock::time_point now = Clock::now();
    survey_.seconds.emplace_back(stage,
                                 std::chrono::duration<double>(now - start_).count());
    start_ = now;
  }

private:
  using Clock = std::chrono::steady_clock;
  ModelSurvey& survey_;
  Clock::time_point start_ = Clock::now();
};

bool
isOpenHole(const LoopClass& loop)
{
  return loop.boundary_class == BoundaryClass::HOLE;
}

/** Sides first: which way a loop runs, and so its class, depends on them. */
void
findSides(const SurveyParameters& parameters,
          const ccaa::LoopContext& context,
          ModelSurvey& survey)
{
  survey.loops = extractBoundaries(survey.model);
  survey.sides =
      orientIslands(survey.model, survey.loops, parameters.orientation, context);
  const bool any_flipped =
      std::any_of(survey.sides.begin(), survey.sides.end(), [](const IslandSide& side) {
        return side.flipped;
      });
  if (!any_flipped)
    return;
  turnIslands(survey.model, survey.sides);
  survey.loops = extractBoundaries(survey.model);
}

void
classify(const SurveyParameters& parameters, ModelSurvey& survey)
{
  survey.classes =
      classifyBoundaries(survey.model, survey.loops, parameters.classification);
  std::vector<std::size_t> hole_edges;
  for (std::size_t k = 0; k < survey.loops.size(); ++k)
    if (isOpenHole(survey.classes[k]))
      hole_edges.push_back(survey.loops[k].vertices.size());
  survey.counts =
      countHoles(survey.model.islands.size(), hole_edges, parameters.simple_edges);
  survey.icm_class = classOf(survey.counts);
}

void
traceFields(const SurveyParameters& parameters,
            const ccaa::LoopContext& context,
            ModelSurvey& survey)
{
  const IslandSources islands = islandSources(survey, parameters.field);
  survey.spacing = islands.sources.spacing;
  const SurveyGuides guides = makeGuides(survey, parameters.field, islands.median_gap);
  survey.between_islands = surveyIslands(survey, parameters, islands, guides, context);
  survey.joined = joinIslands(survey, parameters, islands);
  for (std::size_t k = 0; k < survey.loops.size() && !context.cancelled(); ++k)
    if (isOpenHole(survey.classes[k]) &&
        survey.loops[k].vertices.size() > parameters.simple_edges)
      survey.in_holes.push_back(surveyHole(survey, k, parameters, guides, context));
}

} // namespace

ModelSurvey
surveyModel(const pcl::PolygonMesh::ConstPtr& mesh,
            const pcl::PCLPointCloud2* free_points,
            const SurveyParameters& parameters,
            const ccaa::LoopContext& context)
{
  ModelSurvey survey;
  StageClock clock(survey);
  ccaa::LoopContext stage = context;
  stage.stage = "reading";
  ReadModel read = readModel(mesh, free_points, stage);
  survey.model = std::move(read.model);
  survey.reading = std::move(read.report);
  clock.finish("reading");
  if (!survey.reading.problem.empty())
    return survey;
  stage.stage = "orientation";
  findSides(parameters, stage, survey);
  clock.finish("orientation");
  classify(parameters, survey);
  clock.finish("classification");
  stage.stage = "force lines";
  if (!context.cancelled())
    traceFields(parameters, stage, survey);
  clock.finish("force lines");
  survey.cancelled = context.cancelled();
  return survey;
}

} // namespace repair
} // namespace pcl
