// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all that can be told about an incomplete model.

#include "survey/model_survey.h"

#include "boundary/extraction.h"
#include "decision/mesh_fingerprint.h"
#include "icadm/fins.h"
#include "icadm/model_assembly.h"
#include "run/stage_clock.h"
#include "survey/survey_fields.h"
#include "survey/survey_stages.h"

#include <algorithm>
#include <string>
#include <utility>

namespace pcl::repair {

namespace {

ccaa::LoopContext
named(ccaa::LoopContext context, const char* stage)
{
  context.stage = stage;
  return context;
}

bool
isOpenHole(const LoopClass& loop)
{
  return loop.boundary_class == BoundaryClass::HOLE;
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

/** Holes by their number of edges, and the class that follows (D4.1-4). */
void
count(std::size_t simple_edges, ModelSurvey& survey)
{
  std::vector<std::size_t> hole_edges;
  for (std::size_t k = 0; k < survey.loops.size(); ++k)
    if (isOpenHole(survey.classes[k]))
      hole_edges.push_back(survey.loops[k].vertices.size());
  survey.counts = countHoles(survey.model.islands.size(), hole_edges, simple_edges);
  survey.icm_class = classOf(survey.counts);
}

void
traceFields(const SurveyParameters& parameters,
            const ccaa::LoopContext& context,
            ModelSurvey& survey)
{
  const IslandSources islands = islandSources(survey, parameters.field, context);
  if (context.cancelled())
    return;
  survey.spacing = islands.sources.spacing;
  const bool between = parameters.trace_between_islands && hasGap(islands.sources);
  std::vector<std::size_t> complex_holes;
  for (std::size_t k = 0; k < survey.loops.size(); ++k)
    if (isComplex(survey, k, parameters.simple_edges))
      complex_holes.push_back(k);
  survey.guides = makeGuides(survey,
                             parameters.field,
                             islands.median_gap,
                             between || !complex_holes.empty(),
                             context);
  if (between)
    joinIslands(islands, parameters, context, survey);
  for (const std::size_t hole : complex_holes)
    if (parameters.trace_in_holes && !context.cancelled())
      survey.in_holes.push_back(surveyHole(survey, hole, parameters, context));
}

/** What of the user's decisions does not fit. */
std::string
misfit(const Decisions& decisions, ModelSurvey& survey)
{
  const MeshFingerprint& wanted = decisions.mesh;
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
  const std::string problem = survey.wishes.take(decisions);
  return problem.empty() ? problem : "the decisions do not fit: " + problem;
}

} // namespace

std::map<std::size_t, std::set<std::size_t>>
partnersOver(const SurveyedBridges& joined, bool with_removed)
{
  const std::vector<std::size_t>& removed = joined.holes.removed_bridges;
  std::map<std::size_t, std::set<std::size_t>> partners;
  for (std::size_t b = 0; b < joined.bridges.size(); ++b) {
    if (!with_removed && std::binary_search(removed.begin(), removed.end(), b))
      continue;
    const std::size_t begin = joined.loops[joined.bridges[b].begin.curve];
    const std::size_t end = joined.loops[joined.bridges[b].end.curve];
    partners[begin].insert(end);
    partners[end].insert(begin);
  }
  return partners;
}

ModelSurvey
readSurvey(const ccaa::MeshView& mesh,
           const pcl::PCLPointCloud2* free_points,
           const SurveyParameters& parameters,
           const ccaa::LoopContext& context)
{
  ModelSurvey survey;
  const ccaa::StageClock clock;
  const ccaa::LoopContext stage = named(context, "reading");
  ReadModel read = readModel(mesh, free_points, stage, parameters.orientation.sides);
  if (parameters.dropped.any() && read.report.problem.empty())
    dropIslands(parameters.dropped, stage, read);
  survey.model = std::move(read.model);
  survey.fin_edges = edgesWithFins(survey.model);
  markFins(survey.fin_edges, survey.model);
  survey.reading = std::move(read.report);
  if (survey.reading.problem.empty())
    survey.mesh = fingerprintOf(mesh);
  survey.seconds.emplace_back("reading", clock.seconds());
  return survey;
}

void
orientIslands(const SurveyParameters& parameters,
              const ccaa::LoopContext& context,
              ModelSurvey& survey)
{
  if (!survey.reading.problem.empty())
    return;
  const ccaa::StageClock clock;
  survey.loops = extractBoundaries(survey.model);
  survey.sides = orientIslands(survey.model,
                               survey.loops,
                               parameters.orientation,
                               parameters.field.room,
                               named(context, "orientation"));
  const bool any_flipped =
      std::any_of(survey.sides.begin(), survey.sides.end(), [](const IslandSide& side) {
        return side.flipped;
      });
  if (any_flipped) {
    turnIslands(survey.model, survey.sides);
    survey.loops = extractBoundaries(survey.model);
  }
  if (auto sight = std::make_shared<const SightLines>(survey.model); !sight->empty())
    survey.sight = std::move(sight);
  survey.seconds.emplace_back("orientation", clock.seconds());
}

void
takeDecisions(const SurveyParameters& parameters, ModelSurvey& survey)
{
  if (!survey.reading.problem.empty())
    return;
  survey.wishes = LoopWishes(survey.model, survey.loops);
  if (parameters.decisions)
    survey.reading.problem = misfit(*parameters.decisions, survey);
}

void
classifyBoundaries(const SurveyParameters& parameters,
                   const ccaa::LoopContext& context,
                   ModelSurvey& survey)
{
  const ccaa::StageClock clock;
  survey.classes = classifyBoundaries(survey.model,
                                      survey.loops,
                                      parameters.classification,
                                      named(context, "classification"));
  survey.facing = facingOf(survey.model);
  if (!context.cancelled())
    count(parameters.simple_edges, survey);
  survey.seconds.emplace_back("classification", clock.seconds());
}

void
bridgeIslands(const SurveyParameters& parameters,
              const ccaa::LoopContext& context,
              ModelSurvey& survey)
{
  const ccaa::StageClock clock;
  if (!context.cancelled() && !survey.loops.empty())
    traceFields(parameters, named(context, "force lines"), survey);
  survey.seconds.emplace_back("force lines", clock.seconds());
}

ModelSurvey
putInOrder(ModelSurvey before,
           const std::vector<bool>& used,
           const ccaa::LoopContext& context)
{
  ModelSurvey survey;
  const ccaa::StageClock clock;
  survey.sight = std::move(before.sight);
  survey.facing = before.facing;
  survey.wishes = std::move(before.wishes);
  survey.fin_edges = std::move(before.fin_edges);
  IncompleteModel& old = before.model;
  IncompleteModel& model = survey.model;
  model = assembleModel(std::move(old.triangles),
                        std::move(old.positions),
                        std::move(old.adjacency),
                        named(context, "assembly"));
  model.point_of_vertex = std::move(old.point_of_vertex);
  model.viewpoints = std::move(old.viewpoints);
  for (std::size_t i = 0; i < used.size(); ++i)
    if (!used[i]) {
      model.free_points.push_back(old.free_points[i]);
      model.point_of_free_point.push_back(old.point_of_free_point[i]);
    }
  if (!context.cancelled()) { // else the model is not whole
    markFins(survey.fin_edges, model);
    survey.loops = extractBoundaries(model);
  }
  survey.seconds.emplace_back("assembly", clock.seconds());
  return survey;
}

ModelSurvey
surveyModel(const ccaa::MeshView& mesh,
            const pcl::PCLPointCloud2* free_points,
            const SurveyParameters& parameters,
            const ccaa::LoopContext& context)
{
  ModelSurvey survey = readSurvey(mesh, free_points, parameters, context);
  orientIslands(parameters, context, survey);
  takeDecisions(parameters, survey);
  if (!survey.reading.problem.empty())
    return survey;
  classifyBoundaries(parameters, context, survey);
  bridgeIslands(parameters, context, survey);
  survey.cancelled = context.cancelled();
  return survey;
}

} // namespace pcl::repair
