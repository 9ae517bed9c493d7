// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: complex holes divided until each is simple (4.5).

#include "subdivision/hole_subdivision.h"

#include "field/source_sampling.h"
#include "force_line/line_origins.h"
#include "subdivision/bisecting_line.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace pcl::repair {

namespace {

/** What is tried in turn while no line fits. */
struct Attempt {
  double threshold;  /**< share of T */
  double coarseness; /**< spacing of the sources, in that of the contour's points */
  std::size_t lines; /**< to be traced */
  std::size_t from;  /**< fewest edges of a hole for which it is worth while */
};
constexpr std::array<Attempt, 6> ATTEMPTS{{{1.0, 2.0, 8, 200},
                                           {1.0, 1.0, 12, 0},
                                           {0.5, 1.0, 12, 0},
                                           {1.0, 4.0, 12, 0},
                                           {0.2, 1.0, 12, 0},
                                           {0.2, 4.0, 12, 0}}};
/** Holes of fewer edges are never divided. */
constexpr std::size_t FEWEST_EDGES = 4;

/** Looks for the line that bisects one hole best. */
class Bisector {
public:
  Bisector(const HolePolygon& hole,
           const Attempt& attempt,
           const SurveyParameters& parameters,
           const SubdivisionGuides& guides,
           const ccaa::LoopContext& context)
  : attempt_(attempt)
  , parameters_(parameters)
  , guides_(guides)
  , context_(context)
  , contour_({{hole.curve, 0}})
  , near_(attempt.coarseness *
          (parameters.field.near > 0.0
               ? parameters.field.near
               : contour_.lengthOf(0) / static_cast<double>(hole.size())))
  , sources_(sourcesOf(hole, near_))
  , field_(sources_,
           parameters.field.interpolation,
           isFull() ? guides.free_points : nullptr,
           isFull() ? guides.surface : nullptr)
  , fitter_(hole, contour_, perturbationOf(parameters), guides)
  {}

  std::optional<BisectingLine>
  best() const
  {
    std::optional<BisectingLine> best;
    for (const ForceLine& line : lines()) {
      auto fitted = fitter_.fit(line);
      if (fitted && (!best || fitted->merit > best->merit))
        best = std::move(fitted);
    }
    return best;
  }

private:
  bool
  isFull() const
  {
    return parameters_.field.mode == FieldMode::FULL;
  }

  static SourceSet
  sourcesOf(const HolePolygon& hole, double near)
  {
    SourceCurve curve = sampleSources(hole.curve, near);
    curve.island = 0;
    curve.loop = 0;
    return gatherSources({std::move(curve)});
  }

  static PerturbationParameters
  perturbationOf(const SurveyParameters& parameters)
  {
    PerturbationParameters perturbation = parameters.perturbation;
    perturbation.trust = parameters.field.trust; // k_t is one number (4.424, 4.6)
    return perturbation;
  }

  /** Lines from the strongest origins. */
  std::vector<ForceLine>
  lines() const
  {
    const double threshold = attempt_.threshold * parameters_.hole_threshold;
    const FieldParameters& field = parameters_.field;
    const std::vector<PossibleOrigin> possible =
        originsInHole(field_,
                      contour_,
                      0,
                      threshold * contour_.lengthOf(0),
                      {near_, field.far, field.room, field.falloff_exponent},
                      context_);
    std::vector<LineOrigin> origins;
    for (const std::size_t i :
         strongestOrigins(possible, contour_, parameters_.line_spacing)) {
      origins.push_back(possible[i].origin);
      if (origins.size() == attempt_.lines)
        break;
    }
    const ForceLineTracker tracker(
        field_, contour_, parameters_.tracker, guides_.surface);
    return tracker.track(origins, context_);
  }

  const Attempt& attempt_;
  const SurveyParameters& parameters_;
  const SubdivisionGuides& guides_;
  const ccaa::LoopContext& context_;
  BoundaryEdges contour_;
  double near_; /**< L_1, the spacing of the sources */
  SourceSet sources_;
  IndicatorField field_;
  LineFitter fitter_;
};

std::optional<BisectingLine>
bisect(const HolePolygon& hole,
       const SurveyParameters& parameters,
       const SubdivisionGuides& guides,
       const ccaa::LoopContext& context)
{
  for (const Attempt& attempt : ATTEMPTS) {
    if (context.cancelled())
      break;
    if (hole.size() < attempt.from)
      continue;
    auto line = Bisector(hole, attempt, parameters, guides, context).best();
    if (line)
      return line;
  }
  return std::nullopt;
}

/** The contour from one of its points to another, then back along the bridge, which is
 * given in that direction. */
HolePolygon
partAlong(const HolePolygon& hole,
          std::size_t from,
          std::size_t to,
          const DividingBridge& back)
{
  HolePolygon part;
  for (std::size_t k = from; k != to; k = hole.curve.next(k)) {
    part.vertices.push_back(hole.vertices[k]);
    part.curve.points.push_back(hole.curve.points[k]);
    part.curve.normals.push_back(hole.curve.normals[k]);
  }
  for (std::size_t k = 0; k + 1 < back.vertices.size(); ++k) {
    part.vertices.push_back(back.vertices[k]);
    part.curve.points.push_back(back.points[k]);
    // Of the surface to come along the edge: across it, between those at its ends.
    const Direction along = (back.points[k + 1] - back.points[k]).normalized();
    const Direction sum = back.normals[k] + back.normals[k + 1];
    part.curve.normals.push_back((sum - along * along.dot(sum)).normalized());
  }
  return part;
}

DividingBridge
reversed(DividingBridge bridge)
{
  std::reverse(bridge.vertices.begin(), bridge.vertices.end());
  std::reverse(bridge.points.begin(), bridge.points.end());
  std::reverse(bridge.normals.begin(), bridge.normals.end());
  return bridge;
}

/** Gives the inner points of a line their numbers. */
DividingBridge
bridgeOf(const BisectingLine& line,
         const HolePolygon& hole,
         pcl::index_t first_new,
         Positions& new_vertices)
{
  DividingBridge bridge{{}, line.points, line.normals, line.quality};
  bridge.vertices.push_back(hole.vertices[line.from]);
  for (std::size_t k = 1; k < line.edges(); ++k) {
    bridge.vertices.push_back(first_new +
                              static_cast<pcl::index_t>(new_vertices.size()));
    new_vertices.push_back(line.points[k]);
  }
  bridge.vertices.push_back(hole.vertices[line.to]);
  return bridge;
}

/** More than a disc of so many edges needs for parts of 12 edges: that has as many of
 * them as their areas fit into its own. */
std::size_t
mostBridges(std::size_t edges)
{
  return edges + edges * edges / 32;
}

} // namespace

DividedHole
divideHole(const HolePolygon& hole,
           pcl::index_t first_new,
           const SurveyParameters& parameters,
           const SubdivisionGuides& guides,
           const ccaa::LoopContext& context)
{
  DividedHole divided;
  const std::size_t simple = std::max(FEWEST_EDGES - 1, parameters.simple_edges);
  std::vector<HolePolygon> open{hole};
  while (!open.empty()) {
    const HolePolygon part = std::move(open.back());
    open.pop_back();
    std::optional<BisectingLine> line;
    // Parts shrink, so it ends; the limit makes it end soon whatever the shape.
    if (part.size() > simple && divided.bridges.size() < mostBridges(hole.size()))
      line = bisect(part, parameters, guides, context);
    if (!line) {
      divided.holes.push_back(part);
      continue;
    }
    const DividingBridge bridge =
        bridgeOf(*line, part, first_new, divided.new_vertices);
    open.push_back(partAlong(part, line->to, line->from, bridge));
    open.push_back(partAlong(part, line->from, line->to, reversed(bridge)));
    divided.bridges.push_back(bridge);
  }
  return divided;
}

} // namespace pcl::repair
