// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all that can be told about an incomplete model.

#include <pcl/surface_repair/boundary/extraction.h>
#include <pcl/surface_repair/model_survey.h>

#include "survey_fields.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

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
classify(const SurveyParameters& parameters,
         const ccaa::LoopContext& context,
         ModelSurvey& survey)
{
  survey.classes = classifyBoundaries(
      survey.model, survey.loops, parameters.classification, context);
  if (context.cancelled())
    return;
  std::vector<std::size_t> hole_edges;
  for (std::size_t k = 0; k < survey.loops.size(); ++k)
    if (isOpenHole(survey.classes[k]))
      hole_edges.push_back(survey.loops[k].vertices.size());
  survey.counts =
      countHoles(survey.model.islands.size(), hole_edges, parameters.simple_edges);
  survey.icm_class = classOf(survey.counts);
}

bool
isComplex(const ModelSurvey& survey, std::size_t loop, std::size_t simple_edges)
{
  return isOpenHole(survey.classes[loop]) &&
         survey.loops[loop].vertices.size() > simple_edges;
}

/** Whether lines could run between the sources: there are two sides of a gap. */
bool
hasGap(const SourceSet& sources)
{
  return std::any_of(
      sources.curves.begin(), sources.curves.end(), [&](const SourceCurve& curve) {
        return curve.island != sources.curves.front().island;
      });
}

void
traceFields(const SurveyParameters& parameters,
            const ccaa::LoopContext& context,
            ModelSurvey& survey)
{
  const IslandSources islands = islandSources(survey, parameters.field);
  survey.spacing = islands.sources.spacing;
  const bool between = parameters.trace_between_islands && hasGap(islands.sources);
  std::vector<std::size_t> complex_holes;
  for (std::size_t k = 0; k < survey.loops.size(); ++k)
    if (isComplex(survey, k, parameters.simple_edges))
      complex_holes.push_back(k);
  survey.guides = makeGuides(
      survey, parameters.field, islands.median_gap, between || !complex_holes.empty());
  if (between)
    joinIslands(islands, parameters, context, survey);
  for (const std::size_t hole : complex_holes)
    if (parameters.trace_in_holes && !context.cancelled())
      survey.in_holes.push_back(surveyHole(survey, hole, parameters, context));
}

/** What the user has decided about the loops. \return what does not fit */
std::string
takeDecisions(const pcl::PolygonMesh& mesh,
              const SurveyParameters& parameters,
              ModelSurvey& survey)
{
  survey.wishes = LoopWishes(survey.model, survey.loops);
  survey.mesh = fingerprintOf(mesh);
  if (!parameters.decisions)
    return {};
  const MeshFingerprint& wanted = parameters.decisions->mesh;
  const MeshFingerprint& found = survey.mesh;
  const auto tell = [](const MeshFingerprint& print) {
    return std::to_string(print.points) + " points and " +
           std::to_string(print.polygons) + " polygons";
  };
  if (!(wanted == found))
    return "the decisions are about another mesh, of " + tell(wanted) +
           "; this one has " + tell(found) +
           (wanted.points == found.points && wanted.polygons == found.polygons
                ? ", but other ones"
                : "");
  const std::string problem = survey.wishes.take(*parameters.decisions);
  return problem.empty() ? problem : "the decisions do not fit: " + problem;
}

/** All that follows once the islands are wound as they should be. */
void
surveyWound(const SurveyParameters& parameters,
            ccaa::LoopContext context,
            StageClock& clock,
            ModelSurvey& survey)
{
  context.stage = "classification";
  classify(parameters, context, survey);
  clock.finish("classification");
  context.stage = "force lines";
  if (!context.cancelled() && !survey.loops.empty())
    traceFields(parameters, context, survey);
  clock.finish("force lines");
  survey.cancelled = context.cancelled();
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
  ReadModel read = readModel(mesh, free_points, stage, parameters.orientation.sides);
  if (parameters.dropped.any() && read.report.problem.empty())
    dropIslands(parameters.dropped, stage, read);
  survey.model = std::move(read.model);
  survey.reading = std::move(read.report);
  clock.finish("reading");
  if (!survey.reading.problem.empty())
    return survey;
  stage.stage = "orientation";
  findSides(parameters, stage, survey);
  if (auto sight = std::make_shared<const SightLines>(survey.model); !sight->empty())
    survey.sight = std::move(sight);
  clock.finish("orientation");
  survey.reading.problem = takeDecisions(*mesh, parameters, survey);
  if (survey.reading.problem.empty())
    surveyWound(parameters, context, clock, survey);
  return survey;
}

ModelSurvey
surveyModel(IncompleteModel model,
            std::shared_ptr<const SightLines> sight,
            const SurveyParameters& parameters,
            const ccaa::LoopContext& context,
            LoopWishes wishes)
{
  ModelSurvey survey;
  survey.sight = std::move(sight);
  survey.wishes = std::move(wishes);
  StageClock clock(survey);
  survey.model = std::move(model);
  survey.loops = extractBoundaries(survey.model);
  surveyWound(parameters, context, clock, survey);
  return survey;
}

} // namespace repair
} // namespace pcl
