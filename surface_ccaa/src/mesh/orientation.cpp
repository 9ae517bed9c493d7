// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: winding all triangles alike and outward (thesis 4.48).
#include "mesh/orientation.h"

#include "mesh/block_loop.h"
#include "mesh/outward_votes.h"
#include "mesh/winding.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl::ccaa {
namespace {

/** \brief Free sight this clear is believed without asking for the bulge. */
constexpr double CLEAR_SIGHT_MARGIN = 0.75;

/** \brief A bulge clearer than this outweighs sight that is not clear. A scan of
 * several objects from one side (measured: the toys of rs1_normals) lies about the
 * centre of the scene any way it likes, while each object still bulges to the sensor.
 */
constexpr double BULGE_MARGIN = 0.4;

/** \brief Which components have to be turned, and why. */
struct Decision {
  std::vector<unsigned char> turn;
  std::vector<OrientedComponent> components;
  bool any_undecided = false; /**< by what is asked before the shape, the guess aside */
  int plane_axis = -1;        /**< that the dominant plane looks along; -1 if none */

  void
  settle(std::size_t component, OutwardRule rule, const SideVotes& votes)
  {
    turn[component] = votes.sum < 0.0 ? 1 : 0;
    components[component].rule = rule;
    components[component].margin = rule == OutwardRule::VOLUME ? 1.0 : votes.margin();
  }
};

/** \brief What is known before any rule is asked: one-sided components stay, the others
 * keep most of their windings. */
Decision
startDecision(const Winding& winding)
{
  Decision decision;
  for (const WoundComponent& found : winding.components()) {
    OrientedComponent component;
    component.first_triangle = found.first_triangle;
    component.triangles = found.triangles;
    component.closed = found.closed;
    if (found.one_sided)
      component.rule = OutwardRule::ONE_SIDED;
    decision.components.push_back(component);
    decision.turn.push_back(2 * found.turned > found.triangles ? 1 : 0);
  }
  return decision;
}

/** \brief The first of the hints that is clear, or nothing. */
void
decideByHints(std::size_t component, const OutwardEvidence& found, Decision& decision)
{
  for (std::size_t rule = 0; rule < found.given.size(); ++rule)
    if (found.given[rule].margin() >= VOTE_MARGIN) {
      decision.settle(component, static_cast<OutwardRule>(rule), found.given[rule]);
      return;
    }
}

/** \brief A plane that the origin sees edge-on has not been measured from there. */
void
dropVotesFromEdgeOn(std::vector<OutwardEvidence>& evidence)
{
  double shown = 0.0, area = 0.0;
  for (const OutwardEvidence& found : evidence) {
    shown += found.shown;
    area += found.area;
  }
  if (shown < LEAST_MEAN_COSINE * area)
    for (OutwardEvidence& found : evidence)
      found.given[static_cast<std::size_t>(OutwardRule::ORIGIN)] = {};
}

void
decideByEvidence(std::vector<OutwardEvidence> evidence, Decision& decision)
{
  dropVotesFromEdgeOn(evidence);
  for (std::size_t i = 0; i < evidence.size(); ++i) {
    const OrientedComponent& component = decision.components[i];
    if (component.rule == OutwardRule::ONE_SIDED)
      continue;
    decideByHints(i, evidence[i], decision);
    if (component.rule == OutwardRule::UNDECIDED && component.closed &&
        enclosesVolume(evidence[i].volume.sum, evidence[i].area))
      decision.settle(i, OutwardRule::VOLUME, evidence[i].volume);
    if (component.rule == OutwardRule::UNDECIDED)
      decision.any_undecided = true;
  }
}

void
decideByPlane(const WoundMesh& mesh, const LoopContext& context, Decision& decision)
{
  const std::vector<SideVotes> plane = collectPlane(mesh, context, decision.plane_axis);
  for (std::size_t i = 0; i < plane.size(); ++i)
    if (decision.components[i].rule == OutwardRule::UNDECIDED && plane[i].total > 0.0)
      decision.settle(i, OutwardRule::PLANE, plane[i]);
}

/** \brief All that is asked before the shape. */
void
decideByWhatIsKnown(const WoundMesh& mesh,
                    const OrientationHints& hints,
                    const LoopContext& context,
                    Decision& decision)
{
  decideByEvidence(collectEvidence(mesh, hints, context), decision);
  if (decision.any_undecided && hints.guess_plane)
    decideByPlane(mesh, context, decision);
}

void
decideBySight(const std::vector<SideVotes>& sight, double margin, Decision& decision)
{
  for (std::size_t i = 0; i < sight.size(); ++i)
    if (decision.components[i].rule == OutwardRule::UNDECIDED &&
        sight[i].margin() >= margin)
      decision.settle(i, OutwardRule::ENCLOSING_SPHERE, sight[i]);
}

void
decideByBulge(const WoundMesh& mesh, const LoopContext& context, Decision& decision)
{
  ComponentFlags wanted;
  for (const OrientedComponent& component : decision.components)
    wanted.push_back(component.rule == OutwardRule::UNDECIDED);
  const std::vector<SideVotes> bulge = collectBulge(mesh, wanted, context);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i] != 0 && bulge[i].margin() >= BULGE_MARGIN)
      decision.settle(i, OutwardRule::BULGE, bulge[i]);
}

/** \brief Reverse what has to be. \return number of triangles reversed */
std::size_t
apply(const Decision& decision,
      const Winding& winding,
      int threads,
      Triangles& triangles,
      TriangleAdjacency& adjacency)
{
  const LoopContext context{threads};
  std::vector<std::size_t> reversed(context.blockCount(triangles.size()), 0);
  const auto body = [&](std::size_t block, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t component = winding.componentOf(i);
      const bool two_sided =
          decision.components[component].rule != OutwardRule::ONE_SIDED;
      const bool turn = winding.isTurned(i) != (decision.turn[component] != 0);
      if (!two_sided || !turn)
        continue;
      adjacency.turn(static_cast<pcl::index_t>(i), triangles);
      ++reversed[block];
    }
  };
  forEachBlock(triangles.size(), context, body);
  return std::accumulate(reversed.begin(), reversed.end(), std::size_t{0});
}

OrientationReport
cancelledReport()
{
  OrientationReport report;
  report.cancelled = true;
  return report;
}

bool
hasOneSided(const Decision& decision)
{
  return std::any_of(decision.components.begin(),
                     decision.components.end(),
                     [](const OrientedComponent& component) {
                       return component.rule == OutwardRule::ONE_SIDED;
                     });
}

OrientationReport
makeReport(Decision& decision, std::size_t reversed)
{
  OrientationReport report;
  report.reversed = reversed;
  report.components = std::move(decision.components);
  for (const OrientedComponent& component : report.components) {
    const auto rule = static_cast<std::size_t>(component.rule);
    ++report.decided[rule];
    report.tally.triangles[rule] += component.triangles;
  }
  if (report.tally[OutwardRule::PLANE] > 0)
    report.tally.guessed_axis = decision.plane_axis;
  return report;
}

} // namespace

OrientationReport
orientTriangles(Triangles& triangles,
                TriangleAdjacency& adjacency,
                const PointView& positions,
                const OrientationHints& hints,
                RunControl& control)
{
  Winding winding;
  if (!control.report("orientation", 0.0) ||
      !winding.find(triangles, adjacency, hints.threads, control))
    return cancelledReport();
  const WoundMesh mesh{triangles, positions, winding};
  const LoopContext context{hints.threads, &control, "outer side"};
  Decision decision = startDecision(winding);
  if (hints.stop_if_one_sided && hasOneSided(decision))
    return makeReport(decision, 0);
  decideByWhatIsKnown(mesh, hints, context, decision);
  if (decision.any_undecided) {
    const std::vector<SideVotes> sight = collectEnclosingSphere(mesh, context);
    decideBySight(sight, CLEAR_SIGHT_MARGIN, decision);
    decideByBulge(mesh, context, decision);
    decideBySight(sight, VOTE_MARGIN, decision);
  }
  if (!control.report("outer side", 1.0))
    return cancelledReport();
  return makeReport(decision,
                    apply(decision, winding, hints.threads, triangles, adjacency));
}

std::vector<double>
evidentSides(const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const PointView& positions,
             const OrientationHints& hints,
             RunControl& control)
{
  Winding winding;
  if (!winding.find(triangles, adjacency, hints.threads, control))
    return {};
  Decision decision = startDecision(winding);
  decideByWhatIsKnown({triangles, positions, winding},
                      hints,
                      {hints.threads, &control, "outer side"},
                      decision);
  std::vector<double> sides;
  for (std::size_t i = 0; i < decision.components.size(); ++i) {
    const double margin = decision.components[i].margin;
    sides.push_back(decision.turn[i] != 0 ? -margin : margin);
  }
  return sides;
}

Eigen::Vector3d
outwardAt(pcl::index_t vertex,
          const PointView& positions,
          const OrientationHints& hints)
{
  const auto isClear = [](const Eigen::Vector3d& direction) {
    return direction.allFinite() && !direction.isZero(0.0);
  };
  const auto toward = [&](const Position& viewpoint) -> Eigen::Vector3d {
    return viewpoint - positions[vertex];
  };
  if (hints.told_viewpoint)
    return toward(*hints.told_viewpoint);
  if (hints.up)
    return *hints.up;
  if (!hints.normals.empty() && isClear(hints.normals[vertex]))
    return hints.normals[vertex];
  if (!hints.viewpoints.empty() && isClear(toward(hints.viewpoints[vertex])))
    return toward(hints.viewpoints[vertex]);
  return hints.viewpoint ? toward(*hints.viewpoint) : Eigen::Vector3d::Zero();
}

} // namespace pcl::ccaa
