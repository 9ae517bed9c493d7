// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: lays a crumb into the patch that covers it.

#include "crumb/crumb_laying.h"

#include "boundary/classification.h"
#include "boundary/extraction.h"
#include "crumb/crumb_shadow.h"
#include "pass/ring_filling.h"
#include "patch/opening.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace pcl::repair {

namespace {

/** Rings around the shadow of a crumb that are opened, one try after the other. */
constexpr std::array<int, 4> OPENED_RINGS = {1, 2, 4, 0};
/** A patch covers a crumb that is nearer than so many of its extents, or mean edges
 * where these are longer, one try after the other. */
constexpr std::array<double, 2> REACHES = {1.0, 6.0};
/** The same of crumbs that are no fins: single triangles lie far above wide patches.
 * Then so many more rings are opened as it is edges away. */
constexpr double FARTHEST = 24.0;
/** Depth of the surface that is missing in a hole, at most, in lengths of its boundary:
 * at all, and in a body of what is no wider than the hole. Tips of fingers lie up to
 * 0.42 beyond their stumps. */
constexpr double DEEPEST = 0.3, DEEPEST_OF_TIPS = 0.6;
/** Cosine to the normal of a patch from which a crumb lies in front of it. */
constexpr double AHEAD = 0.5;
/** Edges of an opening that is closed around a crumb. */
constexpr std::size_t LONGEST_BORDER = 128;
/** Operations for a triangle around a crumb each time that some are opened. */
constexpr std::uint64_t OPENING_WORK = 5;
/** What is looked at around an opening, in its extent: where its filling has to lie. */
constexpr double ROOM = 0.5;

/** \param[in] triangle of the whole, that the part has */
std::size_t
placeIn(const ModelPart& part, std::size_t triangle)
{
  return static_cast<std::size_t>(
      std::lower_bound(part.triangles.begin(), part.triangles.end(), triangle) -
      part.triangles.begin());
}

/** Lays one crumb. */
class CrumbLaying {
public:
  CrumbLaying(const std::vector<std::size_t>& crumb,
              double edge,
              const Course& course,
              GrowingSurface& surface)
  : crumb_(crumb), edge_(edge), bounded_(course, crumb.size()), surface_(surface)
  {}

  /** \return whether it is part of a patch now */
  bool
  run();

private:
  bool
  tryWithin(double reach);
  double
  deepest(const CrumbShadow& shadow, double extent, double length) const;
  bool
  touchesInput() const;
  std::vector<bool>
  lookAround(const CrumbShadow& shadow, int rings);
  bool
  isKnown(const Opening& opening);
  bool
  layInto(const CrumbShadow& shadow, int rings);
  bool
  meetsAny(const std::vector<std::size_t>& some);
  bool
  close(const Opening& opening,
        const ModelPart& left,
        const BoundaryLoop& outer,
        const BoundaryLoop& inner);
  pcl::index_t
  rimVertex() const;
  ccaa::Box
  boxAt(std::size_t t) const
  {
    return ccaa::boxOf(ccaa::cornersOf(surface_.triangles[t], surface_.positions));
  }
  ccaa::Box
  box() const
  {
    ccaa::Box all;
    for (const std::size_t t : crumb_)
      all.extend(boxAt(t));
    return all;
  }
  void
  turnCrumb()
  {
    for (const std::size_t t : crumb_)
      std::swap(surface_.triangles[t][1], surface_.triangles[t][2]);
  }
  std::size_t
  holeOf(const Opening& opening) const;

  const std::vector<std::size_t>& crumb_;
  double edge_;
  BoundedCourse bounded_;
  ccaa::RunControl& control_ = bounded_.control;
  const Course& course_ = bounded_.course;
  GrowingSurface& surface_;
  ModelPart part_;  /**< all around what may be opened */
  ccaa::Box place_; /**< of what is opened and the crumb */
  std::optional<std::vector<std::size_t>>
      meeting_;                              /**< of patches, through the crumb */
  std::set<std::vector<std::size_t>> tried_; /**< side of the crumb, what was opened */
};

bool
CrumbLaying::run()
{
  for (const double reach : REACHES)
    if (tryWithin(reach))
      return true;
  return !touchesInput() && tryWithin(FARTHEST);
}

/** Whether a point of it is one of other triangles of the input: it is a fin. */
bool
CrumbLaying::touchesInput() const
{
  std::set<pcl::index_t> points;
  for (const std::size_t t : crumb_)
    for (const pcl::index_t corner : surface_.triangles[t])
      points.insert(surface_.pointOf(corner));
  const std::vector<std::size_t> near = surface_.near(box(), &control_);
  return std::any_of(near.begin(), near.end(), [&](std::size_t t) {
    const Triangle& triangle = surface_.triangles[t];
    return surface_.hole[t] == NONE &&
           !std::binary_search(crumb_.begin(), crumb_.end(), t) &&
           std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
             return points.count(surface_.pointOf(corner)) > 0;
           });
  });
}

/** \param[in] length of the boundary of the hole */
double
CrumbLaying::deepest(const CrumbShadow& shadow, double extent, double length) const
{
  const bool is_tip = M_PI * extent < length && shadow.ahead > AHEAD &&
                      isSeenFromAllSides(course_.survey.facing);
  return length * (is_tip ? DEEPEST_OF_TIPS : DEEPEST);
}

/** \param[in] reach in extents of the crumb, or edges */
bool
CrumbLaying::tryWithin(double reach)
{
  const double extent = box().diagonal().norm();
  const double within = reach * std::max(extent, edge_);
  for (const CrumbShadow& shadow : shadowsOf(crumb_, within, surface_, &control_)) {
    const std::size_t hole = surface_.hole[shadow.nearest];
    if (shadow.distance > deepest(shadow, extent, course_.report.holes[hole].length))
      continue;
    if (shadow.turned)
      turnCrumb();
    for (const int rings : OPENED_RINGS)
      if (!control_.cancelled() &&
          layInto(shadow, reach < FARTHEST ? rings : rings * shadow.slopes))
        return true;
    if (shadow.turned)
      turnCrumb();
  }
  return false;
}

/** The part that holds a shadow with rings around it, and whatever may be in the way of
 * a filling there; of no use after cancelling. \return which of its triangles may be
 * opened */
std::vector<bool>
CrumbLaying::lookAround(const CrumbShadow& shadow, int rings)
{
  ccaa::Box needed = box();
  for (const std::size_t t : shadow.triangles)
    needed.extend(boxAt(t));
  std::vector<bool> may_open;
  ccaa::Box around; // all triangles that meet it are known
  do {
    around.extend(ccaa::widened(needed, ROOM * needed.diagonal().norm()));
    part_ = surface_.part(surface_.near(around, &control_), &control_);
    may_open.assign(part_.triangles.size(), false);
    for (const std::size_t t : shadow.triangles)
      may_open[placeIn(part_, t)] = true;
    may_open = ringsAround(part_, std::move(may_open), rings);
    for (std::size_t i = 0; i < may_open.size(); ++i)
      if (may_open[i])
        needed.extend(boxAt(part_.triangles[i]));
  }
  while (control_.spend(OPENING_WORK * part_.triangles.size()) &&
         !around.contains(ccaa::widened(needed, ROOM * needed.diagonal().norm())));
  return may_open;
}

/** In the numbers of the whole. */
BoundaryLoop
inWhole(BoundaryLoop loop, const ModelPart& part)
{
  for (pcl::index_t& vertex : loop.vertices)
    vertex = part.vertices[static_cast<std::size_t>(vertex)];
  return loop;
}

/** The lowest one on the rim of the crumb. */
pcl::index_t
CrumbLaying::rimVertex() const
{
  std::set<std::pair<pcl::index_t, pcl::index_t>> sides;
  for (const std::size_t t : crumb_)
    for (std::size_t c = 0; c < 3; ++c)
      sides.emplace(surface_.triangles[t][c], surface_.triangles[t][(c + 1) % 3]);
  pcl::index_t lowest = std::numeric_limits<pcl::index_t>::max();
  for (const auto& [from, to] : sides)
    if (sides.count({to, from}) == 0)
      lowest = std::min(lowest, from);
  return lowest;
}

/** Of one opening the same comes each time. */
bool
CrumbLaying::isKnown(const Opening& opening)
{
  const Triangle& side = surface_.triangles[crumb_.front()];
  std::vector<std::size_t> numbers(side.begin(), side.end());
  for (std::size_t i = 0; i < opening.is_open.size(); ++i)
    if (opening.is_open[i])
      numbers.push_back(part_.triangles[i]);
  return !tried_.insert(std::move(numbers)).second;
}

bool
CrumbLaying::layInto(const CrumbShadow& shadow, int rings)
{
  const std::vector<bool> may_open = lookAround(shadow, rings);
  if (control_.cancelled())
    return false;
  const Opening opening = openFrom(part_, placeIn(part_, shadow.nearest), may_open);
  if (opening.border.empty() || opening.border.size() > LONGEST_BORDER ||
      isKnown(opening))
    return false;
  place_ = placeOf(part_, opening);
  place_.extend(box());
  std::vector<std::size_t> staying = trianglesLeft(part_, opening, place_);
  if (meetsAny(staying))
    return false;
  const ModelPart left = surface_.part(std::move(staying), &control_);
  if (control_.cancelled())
    return false;
  const BoundaryLoops loops = extractBoundaries(left.model);
  const BoundaryLoop* outer = loopOf(opening, part_, left, loops);
  const BoundaryLoop* inner = loopAt(loops, left.number_of.at(rimVertex()));
  return outer != nullptr && inner != nullptr && outer != inner &&
         close(opening, left, inWhole(*outer, left), inWhole(*inner, left));
}

/** Whether one of some triangles, ascending, runs through the crumb. */
bool
CrumbLaying::meetsAny(const std::vector<std::size_t>& some)
{
  if (!meeting_)
    meeting_ = surface_.meeting(crumb_, &control_);
  return std::any_of(meeting_->begin(), meeting_->end(), [&](std::size_t t) {
    return std::binary_search(some.begin(), some.end(), t);
  });
}

/** Close the ring between an opening and the crumb. */
bool
CrumbLaying::close(const Opening& opening,
                   const ModelPart& left,
                   const BoundaryLoop& outer,
                   const BoundaryLoop& inner)
{
  const std::vector<LoopPlaces> touching = touchingPlaces(surface_, outer, inner);
  std::map<pcl::index_t, pcl::index_t> welded;
  for (const auto& [o, i] : touching)
    welded.emplace(inner.vertices[i], outer.vertices[o]);
  std::vector<std::vector<RingPolygon>> cuts = cutsOf(outer, inner, touching);
  surface_.weld(crumb_, welded);
  for (auto& rings : cuts)
    for (RingPolygon& ring : rings)
      for (pcl::index_t& vertex : ring.vertices)
        vertex = welded.count(vertex) > 0 ? welded.at(vertex) : vertex;
  ModelPart welded_left;
  if (!welded.empty())
    welded_left = surface_.part(left.triangles, &control_);
  const RingPlace place{
      part_, opening.is_open, welded.empty() ? left : welded_left, place_};
  const std::size_t hole = holeOf(opening);
  const bool is_closed = std::any_of(cuts.begin(), cuts.end(), [&](const auto& rings) {
    const auto closed = control_.cancelled() ? std::optional<Replacement>()
                                             : closeRings(rings, place, course_);
    if (closed)
      surface_.replace(*closed, hole);
    return closed.has_value();
  });
  if (!is_closed) {
    std::map<pcl::index_t, pcl::index_t> back;
    for (const auto& [vertex, kept] : welded)
      back.emplace(kept, vertex);
    surface_.weld(crumb_, back);
  }
  return is_closed;
}

/** The hole of what was opened that was closed first. */
std::size_t
CrumbLaying::holeOf(const Opening& opening) const
{
  std::size_t hole = NONE;
  for (std::size_t i = 0; i < opening.is_open.size(); ++i)
    if (opening.is_open[i])
      hole = std::min(hole, surface_.hole[part_.triangles[i]]);
  return hole;
}

} // namespace

bool
layCrumb(const std::vector<std::size_t>& crumb,
         double edge,
         const Course& course,
         GrowingSurface& surface)
{
  return CrumbLaying(crumb, edge, course, surface).run();
}

} // namespace pcl::repair
