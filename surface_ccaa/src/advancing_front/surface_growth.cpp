// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: triangle by triangle, the best supported one first.
#include "advancing_front/surface_growth.h"

#include "advancing_front/empty_ball.h"
#include "advancing_front/local_fan.h"
#include "advancing_front/loop_closure.h"
#include "advancing_front/scattered_points.h"
#include "advancing_front/tuning.h"
#include "mesh/corners.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::ccaa {

SurfaceGrowth::SurfaceGrowth(const OpenSurface& open,
                             const CompletionParameters& parameters,
                             const NearbyTriangles* nearby)
: open_(open)
, parameters_(parameters)
, cos_smooth_(std::cos(parameters.smooth_fold))
, cos_largest_(std::cos(parameters.largest_fold))
, surface_(open)
, trial_(open, surface_, parameters.support, nearby)
, seen_(open.positions.size(), 0)
{}

bool
SurfaceGrowth::run(RunControl* control)
{
  if (!growFront(control) || !growFromSeeds(control, tuning::MOST_THICKNESS))
    return false;
  if (surface_.triangles().empty() && !growFromSeeds(control, 1.0))
    return false;
  obstructed_ = closeLoops(surface_, trial_, control);
  return !isCancelled(control);
}

bool
SurfaceGrowth::growFromSeeds(RunControl* control, double thickness)
{
  for (std::size_t i = 0; i < open_.open_points; ++i) {
    const auto vertex = static_cast<pcl::index_t>(i);
    if (surface_.hasTriangles(vertex))
      continue;
    if (!spend(control, tuning::GROWTH_WORK))
      return false;
    if (neighborhoodThickness(open_, vertex) <= thickness && plantSeed(vertex) &&
        !growFront(control))
      return false;
  }
  return true;
}

bool
SurfaceGrowth::growFront(RunControl* control)
{
  proposeNew();
  while (!proposals_.empty()) {
    if (!spend(control, tuning::GROWTH_WORK))
      return false;
    const Proposal best = proposals_.top();
    proposals_.pop();
    has_proposal_[static_cast<std::size_t>(best.edge)] = 0;
    if (surface_.front()[best.edge].alive)
      take(best);
  }
  return true;
}

/** The surface may have changed since the proposal was made. */
void
SurfaceGrowth::take(const Proposal& proposal)
{
  const FrontEdge edge = surface_.front()[proposal.edge];
  if (!isAdmissible(edge, proposal.apex)) {
    propose(proposal.edge);
    return;
  }
  if (trial_.crossesSurface({edge.to, edge.from, proposal.apex})) {
    const std::pair<FrontIndex, pcl::index_t> ban{proposal.edge, proposal.apex};
    banned_.insert(std::lower_bound(banned_.begin(), banned_.end(), ban), ban);
    propose(proposal.edge);
    return;
  }
  surface_.advance(proposal.edge, proposal.apex);
  proposeNew();
  for (const FrontIndex beside : {edge.previous, edge.next})
    if (surface_.front()[beside].alive)
      propose(beside);
}

void
SurfaceGrowth::proposeNew()
{
  const auto count = static_cast<FrontIndex>(surface_.front().size());
  has_proposal_.resize(static_cast<std::size_t>(count), 0);
  for (; unproposed_ < count; ++unproposed_)
    if (surface_.front()[unproposed_].alive)
      propose(unproposed_);
}

void
SurfaceGrowth::propose(FrontIndex i)
{
  std::uint8_t& has_proposal = has_proposal_[static_cast<std::size_t>(i)];
  if (has_proposal != 0)
    return;
  const FrontEdge& edge = surface_.front()[i];
  if (!trial_.isOpenPoint(edge.from) || !trial_.isOpenPoint(edge.to))
    return; // where the boundary leads out of the open surface
  listCandidates(i);
  Candidate best;
  bool found = false;
  for (Candidate& candidate : candidates_) {
    if (found && best.grade < candidate.grade)
      break; // estimates ascend and never exceed the grade itself
    if (examine(i, candidate) && (!found || candidate < best)) {
      best = candidate;
      found = true;
    }
  }
  if (found)
    proposals_.push({best.grade, i, best.apex});
  has_proposal = found;
}

/** All candidates of a front edge by their estimates, best first. */
void
SurfaceGrowth::listCandidates(FrontIndex i)
{
  const FrontEdge& edge = surface_.front()[i];
  const Position behind = unitNormal(trial_.cornersOf({edge.from, edge.to, edge.apex}));
  collectWitnesses(i);
  candidates_.clear();
  for (const pcl::index_t apex : witnesses_) {
    Candidate candidate;
    candidate.apex = apex;
    if (apex != edge.apex && surface_.isOpen(apex) && estimate(edge, behind, candidate))
      candidates_.push_back(candidate);
  }
  std::sort(candidates_.begin(), candidates_.end());
}

/** Turn an estimate into a grade. \return whether the triangle may be made */
bool
SurfaceGrowth::examine(FrontIndex i, Candidate& candidate) const
{
  const FrontEdge& edge = surface_.front()[i];
  EmptyBall ball(surface_.position(edge.to),
                 surface_.position(edge.from),
                 surface_.position(candidate.apex));
  if (!isEmpty(ball, {edge.to, edge.from, candidate.apex}) ||
      std::binary_search(
          banned_.begin(), banned_.end(), std::pair(i, candidate.apex)) ||
      !isAdmissible(edge, candidate.apex))
    return false;
  if (ball.radius() > tuning::LARGEST_BALL * ball.circumradius())
    return false;
  if (candidate.grade.tier == 0 || candidate.grade.tier == 3)
    candidate.grade.cost = ball.radius();
  return true;
}

/** The open points around a front edge, its ends left out. */
void
SurfaceGrowth::collectWitnesses(FrontIndex i)
{
  const FrontEdge& edge = surface_.front()[i];
  ++call_;
  witnesses_.clear();
  for (const pcl::index_t end : {edge.from, edge.to})
    seen_[static_cast<std::size_t>(end)] = call_;
  for (const pcl::index_t end : {edge.from, edge.to})
    for (unsigned int j = 0; j < open_.neighbors.k; ++j) {
      const pcl::index_t near = open_.neighbors.row(end)[j];
      if (near == NeighborRows::NONE)
        break;
      witness(near);
    }
  witness(surface_.front()[edge.previous].from);
  witness(surface_.front()[edge.next].to);
}

void
SurfaceGrowth::witness(pcl::index_t vertex)
{
  std::uint32_t& seen = seen_[static_cast<std::size_t>(vertex)];
  if (seen != call_ && trial_.isOpenPoint(vertex))
    witnesses_.push_back(vertex);
  seen = call_;
}

/** Whether a triangle is worth a closer look, and how good it can be at best.
 * \param[in] behind unit normal of the triangle behind the edge */
bool
SurfaceGrowth::estimate(const FrontEdge& edge,
                        const Position& behind,
                        Candidate& candidate) const
{
  const Position &a = surface_.position(edge.to), &b = surface_.position(edge.from),
                 &c = surface_.position(candidate.apex);
  const Position normal = areaNormal({a, b, c});
  const double doubled_area = normal.norm();
  if (!(doubled_area > tuning::LEAST_HEIGHT * (b - a).squaredNorm()))
    return false;
  const double cosine = behind.dot(normal) / doubled_area;
  if (cosine < cos_largest_)
    return false;
  const double radius = EmptyBall(a, b, c).circumradius();
  if (!trial_.isSupported(edge, candidate.apex, radius))
    return false;
  const bool touches =
      surface_.hasTriangles(candidate.apex) && !isStitched(edge, candidate.apex);
  const bool folded = cosine < cos_smooth_;
  candidate.grade.tier = touches ? (folded ? 2 : 3) : (folded ? 1 : 0);
  candidate.grade.cost = folded ? -cosine : radius;
  return true;
}

bool
SurfaceGrowth::isEmpty(EmptyBall& ball, const Triangle& corners) const
{
  for (const pcl::index_t w : witnesses_)
    if (w != corners[0] && w != corners[1] && w != corners[2]) {
      ball.exclude(surface_.position(w));
      if (!ball.exists())
        return false;
    }
  return true;
}

/** Whether one of the two new edges closes a gap to a triangle that is there. */
bool
SurfaceGrowth::isStitched(const FrontEdge& edge, pcl::index_t apex) const
{
  return surface_.front().find(apex, edge.from) != FrontEdge::NONE ||
         surface_.front().find(edge.to, apex) != FrontEdge::NONE;
}

bool
SurfaceGrowth::isAdmissible(const FrontEdge& edge, pcl::index_t apex) const
{
  if (!surface_.isOpen(apex) || !surface_.takesEdge(edge.from, apex) ||
      !surface_.takesEdge(apex, edge.to))
    return false;
  const Position normal = unitNormal(trial_.cornersOf({edge.to, edge.from, apex}));
  if (surface_.hasTriangles(apex) && !isStitched(edge, apex) &&
      surface_.normalSum(apex).dot(normal) <= 0.0)
    return false;
  return !isCurtain({edge.to, edge.from, apex}, normal) &&
         agreesWithNormal(apex, normal) &&
         fitsFans(surface_, edge.to, edge.from, apex, normal) &&
         fitsFans(surface_, edge.from, apex, edge.to, normal) &&
         fitsFans(surface_, apex, edge.to, edge.from, normal);
}

/** Between three points of one border a triangle can hang down like a curtain: it is
 * steep to the surface at all three. */
bool
SurfaceGrowth::isCurtain(const Triangle& corners, const Position& normal) const
{
  for (const pcl::index_t corner : corners) {
    const Position& sum = surface_.normalSum(corner);
    if (!surface_.hasTriangles(corner) ||
        sum.dot(normal) > tuning::COS_STEEP * sum.norm())
      return false;
  }
  return true;
}

bool
SurfaceGrowth::agreesWithNormal(pcl::index_t vertex, const Position& normal) const
{
  return open_.normals.empty() ||
         open_.normals[static_cast<std::size_t>(vertex)].dot(normal) >= 0.0;
}

/** Begin a new piece of surface: the smallest triangle with an empty ball that a point
 * and two of its neighbors form, none of which has triangles. */
bool
SurfaceGrowth::plantSeed(pcl::index_t vertex)
{
  const pcl::index_t* row = open_.neighbors.row(vertex);
  const unsigned int count = open_.neighbors.count(vertex);
  witnesses_.assign(row, row + count);
  double least = std::numeric_limits<double>::infinity();
  Triangle seed{};
  for (unsigned int i = 0; i < count; ++i)
    for (unsigned int j = i + 1; j < count; ++j) {
      const Triangle corners{vertex, row[i], row[j]};
      if (surface_.hasTriangles(row[i]) || surface_.hasTriangles(row[j]) ||
          !trial_.isSupportedByAll(corners))
        continue;
      EmptyBall ball(surface_.position(vertex),
                     surface_.position(row[i]),
                     surface_.position(row[j]));
      if (ball.circumradius() < least && isEmpty(ball, corners) &&
          ball.radius() < least && !trial_.crossesSurface(corners)) {
        least = ball.radius();
        seed = corners;
      }
    }
  if (least == std::numeric_limits<double>::infinity())
    return false;
  addSeed(seed);
  return true;
}

/** Wound as is known, if anything is. */
void
SurfaceGrowth::addSeed(Triangle seed)
{
  if (!open_.outward.empty()) {
    const Position normal = unitNormal(trial_.cornersOf(seed));
    double agreement = 0.0;
    for (const pcl::index_t corner : seed)
      agreement += open_.outward[static_cast<std::size_t>(corner)].dot(normal);
    if (agreement < 0.0)
      std::swap(seed[1], seed[2]);
  }
  surface_.addTriangle(seed);
}

} // namespace pcl::ccaa
