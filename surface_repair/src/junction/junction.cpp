// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether two boundaries belong to one surface.

#include "junction/junction.h"

#include "mesh/corners.h"
#include "mesh/quantile.h"

#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace pcl::repair {

namespace {

/** Gaps up to so many edges are bridged anywhere, and those up to this share of the
 * smaller boundary's extent in a body. */
constexpr double NARROW_EDGES = 8.0;
constexpr double NARROW_SHARE = 0.3;
/** Turn and fold together from which a wide gap counts in full, in radians. */
constexpr double BENT = M_PI / 4.0;
/** Fitted by `bench_repair junctions`, where a wrong junction counts four times; the
 * last one is the least that leaves few of them in range maps (doc/benchmarks.md). */
constexpr double EVEN = 4.7;
constexpr std::array<double, 6> WEIGHTS = {2.2, 0.8, 4.1, 1.2, 1.4, 2.0};
/** Cosine between chord and ray from which a gap lies in depth. */
constexpr double IN_DEPTH = 0.5;
/** Log odds that are wanted above the others where sensors are known: up to there a
 * third of the pairs in generated range maps (7 of 23) is none. */
constexpr double SEEN_ODDS = 0.75;
/** Share of the way that must have been looked through to call it that. */
constexpr double MOSTLY_EMPTY = 0.25;

/** Operations for what a line says: some hundred triangles at each of its ends. */
constexpr std::uint64_t EVIDENCE_WORK = 10000;

/** What one line says. \param[in] extent of the smaller boundary */
JunctionEvidence
evidenceOf(const ForceLine& line,
           const SurfaceEnd& begin,
           const SurfaceEnd& end,
           double extent,
           const SightLines* sight)
{
  JunctionEvidence evidence;
  const Eigen::Vector3d chord = line.target.position - line.origin.position;
  evidence.turn = std::max(ccaa::angleBetween(begin.conormal, chord),
                           ccaa::angleBetween(end.conormal, -chord));
  evidence.fold = ccaa::angleBetween(begin.normal, end.normal);
  evidence.gap = chord.norm();
  const double edge = std::max(begin.edge, end.edge);
  evidence.gap_edges = edge > 0.0 ? evidence.gap / edge : 0.0;
  evidence.gap_share = extent > 0.0 ? evidence.gap / extent : 0.0;
  evidence.has_sight = sight != nullptr;
  if (evidence.has_sight) {
    evidence.seen_empty = sight->seenEmpty(line.points);
    evidence.along_ray = sight->alongRay(line.origin.position, line.target.position);
  }
  return evidence;
}

JunctionEvidence
medianOf(const std::vector<JunctionEvidence>& lines)
{
  JunctionEvidence median;
  median.has_sight = lines.front().has_sight;
  median.facing = lines.front().facing;
  for (const auto member : {&JunctionEvidence::turn,
                            &JunctionEvidence::fold,
                            &JunctionEvidence::gap,
                            &JunctionEvidence::gap_edges,
                            &JunctionEvidence::gap_share,
                            &JunctionEvidence::seen_empty,
                            &JunctionEvidence::along_ray}) {
    std::vector<double> values;
    for (const JunctionEvidence& line : lines)
      values.push_back(line.*member);
    median.*member = ccaa::medianOf(std::move(values));
  }
  return median;
}

double
extentOf(const BoundaryCurve& curve)
{
  Eigen::AlignedBox3d box;
  for (const Position& point : curve.points)
    box.extend(point);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

JunctionVerdict
verdictOn(const JunctionEvidence& evidence, const JunctionParameters& parameters)
{
  const double odds = evidence.logOdds();
  if (!parameters.judge || odds >= oddsThatJoin(evidence, parameters))
    return JunctionVerdict::JOINED;
  if (odds >= parameters.different_below)
    return JunctionVerdict::DOUBTFUL;
  return evidence.seen_empty > MOSTLY_EMPTY ? JunctionVerdict::SEEN_EMPTY
                                            : JunctionVerdict::DIFFERENT_OBJECTS;
}

/** \param[in] lines evidence of each line of the junction */
void
judge(const std::vector<JunctionEvidence>& lines,
      const JunctionParameters& parameters,
      Junction& junction)
{
  junction.evidence = medianOf(lines);
  junction.verdict = verdictOn(junction.evidence, parameters);
  junction.confidence =
      std::abs(std::tanh(0.5 * (junction.evidence.logOdds() - parameters.joined_from)));
  if (junction.verdict == JunctionVerdict::JOINED)
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (!parameters.judge || lines[i].logOdds() >= parameters.different_below)
        junction.believed.push_back(junction.lines[i]);
}

} // namespace

std::array<double, 6>
JunctionEvidence::terms() const
{
  // Over a gap of few edges the direction between jagged rims says little.
  const double edges = gap_edges / NARROW_EDGES;
  const double trust = std::min(1.0, edges);
  const double bend = std::min(1.0, (turn + fold) / BENT);
  const double wide = std::log(std::max(1.0, edges));
  const double wide_for_body =
      std::min(wide, std::log(std::max(1.0, gap_share / NARROW_SHARE)));
  return {trust * turn,
          trust * fold,
          facing * bend * wide,
          (1.0 - facing) * wide_for_body,
          seen_empty,
          trust * bend * std::min(1.0, along_ray / IN_DEPTH)};
}

double
JunctionEvidence::logOdds() const
{
  const auto against = terms();
  return EVEN -
         std::inner_product(against.begin(), against.end(), WEIGHTS.begin(), 0.0);
}

const char*
describe(JunctionVerdict verdict)
{
  switch (verdict) {
  case JunctionVerdict::JOINED:
    return "joined";
  case JunctionVerdict::DIFFERENT_OBJECTS:
    return "different objects";
  case JunctionVerdict::SEEN_EMPTY:
    return "seen empty";
  case JunctionVerdict::DOUBTFUL:
    break;
  }
  return "doubtful";
}

double
oddsThatJoin(const JunctionEvidence& evidence, const JunctionParameters& parameters)
{
  return parameters.joined_from + (evidence.has_sight ? SEEN_ODDS : 0.0);
}

const SurfaceEnd&
SurfaceEnds::at(pcl::index_t vertex)
{
  const auto [entry, is_new] = ends_.try_emplace(vertex);
  if (is_new)
    entry->second = surfaceEndAt(model_, vertex);
  return entry->second;
}

std::vector<Junction>
findJunctions(SurfaceEnds& ends,
              const BoundaryLoops& loops,
              const std::vector<std::size_t>& loop_of_curve,
              const BoundaryEdges& boundaries,
              const std::vector<ForceLine>& lines,
              const SightLines* sight,
              double facing,
              const JunctionParameters& parameters,
              ccaa::RunControl* control)
{
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> pairs;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].end == LineEnd::BRIDGE)
      pairs[std::minmax(lines[i].origin.curve, lines[i].target.curve)].push_back(i);
  const auto end_at = [&](const BoundaryPoint& point) -> const SurfaceEnd& {
    const BoundaryLoop& loop = loops[loop_of_curve[point.curve]];
    const std::size_t k = point.share < 0.5 ? point.edge : loop.curve.next(point.edge);
    return ends.at(loop.vertices[k]);
  };
  std::vector<Junction> junctions;
  for (auto& [curves, between] : pairs) {
    Junction junction;
    junction.curves = {curves.first, curves.second};
    junction.lines = std::move(between);
    const double extent = std::min(extentOf(boundaries.curves()[curves.first].curve),
                                   extentOf(boundaries.curves()[curves.second].curve));
    std::vector<JunctionEvidence> evidence;
    for (const std::size_t i : junction.lines) {
      if (!ccaa::spend(control, EVIDENCE_WORK))
        return junctions;
      evidence.push_back(evidenceOf(
          lines[i], end_at(lines[i].origin), end_at(lines[i].target), extent, sight));
      evidence.back().facing = facing;
    }
    judge(evidence, parameters, junction);
    junctions.push_back(std::move(junction));
  }
  return junctions;
}

} // namespace pcl::repair
