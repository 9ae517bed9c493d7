// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which boundaries are to be closed, and which together.

#include "listing/hole_list.h"

#include "boundary/extraction.h"
#include "boundary/loop_evidence.h"
#include "listing/hole_regions.h"
#include "listing/junction_rings.h"
#include "listing/loop_reasons.h"
#include "listing/sampled_rings.h"
#include "mesh/disjoint_sets.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace pcl::repair {

namespace {

using ccaa::DisjointSets;

BoundaryEdges
boundariesOf(const ModelSurvey& survey)
{
  std::vector<TargetCurve> curves;
  for (const std::size_t loop : survey.joined.loops)
    curves.push_back({survey.loops[loop].curve, survey.loops[loop].island});
  return BoundaryEdges(std::move(curves));
}

ContourVertices
verticesOf(const ModelSurvey& survey)
{
  ContourVertices vertices;
  for (const std::size_t loop : survey.joined.loops)
    vertices.of_curve.push_back(survey.loops[loop].vertices);
  auto next = static_cast<pcl::index_t>(survey.model.positions.size());
  for (const Bridge& bridge : survey.joined.bridges) {
    vertices.first_inner.push_back(next);
    next += static_cast<pcl::index_t>(bridge.points.size() - 2);
  }
  return vertices;
}

std::size_t
islandAt(const ModelSurvey& survey, const BoundaryPoint& end)
{
  return survey.loops[survey.joined.loops[end.curve]].island;
}

/** The islands that bridges join. */
DisjointSets
joinedIslands(const ModelSurvey& survey)
{
  const SurveyedBridges& joined = survey.joined;
  DisjointSets groups(survey.model.islands.size());
  for (const HoleContour& contour : joined.holes.contours)
    for (const ContourStep& step : contour.steps)
      if (step.bridge != NONE)
        groups.join(islandAt(survey, joined.bridges[step.bridge].begin),
                    islandAt(survey, joined.bridges[step.bridge].end));
  return groups;
}

/** For each island the area of all that are joined to it. */
std::vector<double>
joinedAreas(const ModelSurvey& survey, DisjointSets& groups)
{
  std::vector<double> sums(survey.model.islands.size(), 0.0);
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[groups.find(i)] += survey.model.islands[i].area;
  std::vector<double> areas;
  for (std::size_t i = 0; i < sums.size(); ++i)
    areas.push_back(sums[groups.find(i)]);
  return areas;
}

/** D4.1-1 and what goes with it, for a contour. \param[in] outside what it is when it
 * is no hole */
OpenReason
reasonForContour(const HolePolygon& polygon, double area, OpenReason outside)
{
  return evidenceOf(polygon.curve, area).score() < 0.0 ? outside : OpenReason::NONE;
}

class Listing {
public:
  Listing(const ModelSurvey& survey, const FillingParameters& parameters)
  : survey_(survey)
  , parameters_(parameters)
  , longest_(parameters.greatest_length.limits()
                 ? parameters.greatest_length.length(diagonalOf(survey.model))
                 : std::numeric_limits<double>::infinity())
  {}

  HoleList
  run(double longest_join)
  {
    is_listed_.assign(survey_.loops.size(), false);
    addRings(longest_join);
    addContours();
    countIslands();
    addLoops();
    weldHoles(survey_, list_);
    groupHoles(list_);
    return std::move(list_);
  }

private:
  void
  addContours();
  void
  addCrease(std::size_t bridge, const ContourVertices& vertices);
  OpenReason
  outsideOf(DisjointSets& groups) const;
  void
  addRings(double longest_join);
  void
  countIslands();
  void
  addLoops();
  bool
  isWanted(const HoleContour& contour) const;
  void
  add(OpenHole hole);

  const ModelSurvey& survey_;
  const FillingParameters& parameters_;
  double longest_;              /**< that is to be closed */
  std::vector<bool> is_listed_; /**< of a loop: in a contour or ring */
  HoleList list_;
};

void
Listing::add(OpenHole hole)
{
  const bool has_too_many =
      parameters_.greatest_hole > 0 && hole.polygon.size() > parameters_.greatest_hole;
  if (hole.open == OpenReason::NONE &&
      (has_too_many || lengthOf(hole.polygon.curve) > longest_))
    hole.open = OpenReason::TOO_LARGE;
  list_.holes.push_back(std::move(hole));
}

/** Whether the user wants a contour closed, wherever it lies. */
bool
Listing::isWanted(const HoleContour& contour) const
{
  return parameters_.close == CloseChoice::ALL ||
         std::any_of(
             contour.steps.begin(), contour.steps.end(), [&](const ContourStep& step) {
               const BoundaryLoop& loop =
                   survey_.loops[survey_.joined.loops[step.section.from.curve]];
               return survey_.wishes.wishFor(survey_.wishes.inputLoop(
                          survey_.model, loop)) == LoopWish::CLOSE;
             });
}

/** What a contour is that bounds joined islands from outside: a body has no outer
 * border, so it faces islands that are not joined yet. */
OpenReason
Listing::outsideOf(DisjointSets& groups) const
{
  if (!isSeenFromAllSides(survey_.facing))
    return OpenReason::OUTER_BORDER;
  for (std::size_t i = 1; i < survey_.model.islands.size(); ++i)
    if (groups.find(i) != groups.find(0))
      return OpenReason::NOT_JOINED;
  return OpenReason::NONE;
}

void
Listing::addCrease(std::size_t bridge, const ContourVertices& vertices)
{
  const Bridge& crease = survey_.joined.bridges[bridge];
  for (const BoundaryPoint& end : {crease.begin, crease.end})
    list_.creases[vertices.of_curve[end.curve][end.edge]] = bridge;
  for (std::size_t k = 0; k + 2 < crease.points.size(); ++k)
    list_.creases[vertices.first_inner[bridge] + static_cast<pcl::index_t>(k)] = bridge;
}

void
Listing::addContours()
{
  const SurveyedBridges& joined = survey_.joined;
  const std::vector<bool> is_in_ring = is_listed_;
  DisjointSets groups = joinedIslands(survey_);
  if (joined.bridges.empty())
    return;
  const BoundaryEdges boundaries = boundariesOf(survey_);
  const ContourVertices vertices = verticesOf(survey_);
  const std::vector<double> areas = joinedAreas(survey_, groups);
  const OpenReason outside = outsideOf(groups);
  for (const Bridge& bridge : joined.bridges)
    list_.bridge_vertices += bridge.points.size() - 2;
  for (const HoleContour& contour : joined.holes.contours) {
    const std::size_t loop = joined.loops[contour.steps.front().section.from.curve];
    OpenHole hole;
    if (contour.steps.front().bridge == NONE || is_in_ring[loop])
      continue;
    for (const ContourStep& step : contour.steps) {
      hole.bridges.push_back(step.bridge);
      if (joined.bridges[step.bridge].is_crease)
        addCrease(step.bridge, vertices);
      is_listed_[joined.loops[step.section.from.curve]] = true;
    }
    hole.polygon = polygonOf(contour, boundaries, joined.bridges, vertices);
    hole.is_wanted = isWanted(contour);
    if (!hole.is_wanted)
      hole.open =
          reasonForContour(hole.polygon, areas[survey_.loops[loop].island], outside);
    add(std::move(hole));
  }
}

void
Listing::addRings(double longest_join)
{
  std::vector<OpenHole> rings = ringsOverSamples(survey_, longest_join);
  if (rings.empty())
    rings = ringsOverJunctions(survey_);
  for (OpenHole& ring : rings) {
    is_listed_[ring.loop] = is_listed_[ring.other_loop] = true;
    add(std::move(ring));
  }
}

/** A bridge joins islands where a hole beside it is to be closed. */
void
Listing::countIslands()
{
  const SurveyedBridges& joined = survey_.joined;
  DisjointSets groups(survey_.model.islands.size());
  for (const OpenHole& hole : list_.holes) {
    if (hole.open != OpenReason::NONE)
      continue;
    for (const std::size_t bridge : hole.bridges)
      groups.join(islandAt(survey_, joined.bridges[bridge].begin),
                  islandAt(survey_, joined.bridges[bridge].end));
    if (hole.other_loop != NONE)
      groups.join(survey_.loops[hole.loop].island,
                  survey_.loops[hole.other_loop].island);
  }
  list_.islands += groups.count();
}

void
Listing::addLoops()
{
  for (std::size_t loop = 0; loop < survey_.loops.size(); ++loop)
    if (!is_listed_[loop]) {
      const std::size_t input_loop =
          survey_.wishes.inputLoop(survey_.model, survey_.loops[loop]);
      OpenHole hole;
      hole.polygon = polygonOf(survey_.loops[loop]);
      hole.open = reasonForLoop(survey_, parameters_.close, loop);
      hole.loop = loop;
      hole.cap = survey_.wishes.capFor(input_loop);
      hole.is_wanted = parameters_.close == CloseChoice::ALL ||
                       survey_.wishes.wishFor(input_loop) == LoopWish::CLOSE;
      add(std::move(hole));
    }
}

} // namespace

HoleList
listHoles(const ModelSurvey& survey,
          const FillingParameters& parameters,
          double longest_join)
{
  return Listing(survey, parameters).run(longest_join);
}

} // namespace pcl::repair
