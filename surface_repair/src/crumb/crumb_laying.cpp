// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: lays a crumb into the patch that covers it.

#include "crumb/crumb_laying.h"

#include "boundary/classification.h"
#include "boundary/extraction.h"
#include "crumb/crumb_shadow.h"
#include "pass/ring_filling.h"
#include "patch/opening.h"
#include "region/region_parts.h"

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
/** A crumb may take so many times less work than a region: the dearest that was laid in
 * ten scans took 40 million operations, two fifths of that. */
constexpr std::uint64_t LESS_WORK = 4;
/** What is looked at around an opening, in its extent: where its filling has to lie. */
constexpr double ROOM = 0.5;

/** Lays one crumb. */
class CrumbLaying {
public:
  CrumbLaying(const std::vector<std::size_t>& crumb,
              double edge,
              const Course& course,
              ccaa::RunControl* run,
              const GrowingSurface& surface)
  : crumb_(crumb)
  , edge_(edge)
  , bounded_(course, run, workFor(crumb.size()) / LESS_WORK)
  , surface_(surface)
  {
    for (const std::size_t t : crumb_) {
      laid_.crumb.emplace(t, surface_.triangles[t]);
      box_.extend(boxAt(t));
    }
  }

  LaidCrumb
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
  void
  turnCrumb()
  {
    for (auto& [t, triangle] : laid_.crumb)
      std::swap(triangle[1], triangle[2]);
  }
  std::size_t
  holeOf(const Opening& opening) const;

  const std::vector<std::size_t>& crumb_;
  double edge_;
  BoundedCourse bounded_;
  ccaa::RunControl& control_ = bounded_.control;
  const Course& course_ = bounded_.course;
  const GrowingSurface& surface_;
  LaidCrumb laid_;
  ccaa::Box box_;    /**< of the crumb */
  ccaa::Box around_; /**< all triangles that meet it are in the part */
  ModelPart part_;   /**< all around what may be opened */
  ccaa::Box place_;  /**< of what is opened and the crumb */
  std::optional<std::vector<std::size_t>>
      meeting_;                              /**< of patches, through the crumb */
  std::set<std::vector<std::size_t>> tried_; /**< side of the crumb, what was opened */
};

LaidCrumb
CrumbLaying::run()
{
  const auto lay = [this](double reach) { return tryWithin(reach); };
  if (!std::any_of(REACHES.begin(), REACHES.end(), lay) && !touchesInput())
    tryWithin(FARTHEST);
  laid_.work = control_.work();
  return std::move(laid_);
}

/** Whether a point of it is one of other triangles of the input: it is a fin. */
bool
CrumbLaying::touchesInput() const
{
  std::set<pcl::index_t> points;
  for (const std::size_t t : crumb_)
    for (const pcl::index_t corner : surface_.triangles[t])
      points.insert(surface_.pointOf(corner));
  const std::vector<std::size_t> near = surface_.near(box_, &control_);
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
  const double extent = box_.diagonal().norm();
  const double within = reach * std::max(extent, edge_);
  laid_.seen.extend(ccaa::widened(box_, within));
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
  ccaa::Box needed = box_;
  for (const std::size_t t : shadow.triangles)
    needed.extend(boxAt(t));
  const auto withRoom = [&needed] {
    return ccaa::widened(needed, ROOM * needed.diagonal().norm());
  };
  if (!around_.contains(withRoom()))
    around_.setEmpty(); // the part of another shadow, or of fewer rings
  std::vector<bool> may_open;
  do {
    if (!around_.contains(withRoom())) {
      around_.extend(withRoom());
      laid_.seen.extend(around_);
      part_ = surface_.part(surface_.near(around_, &control_), &control_);
    }
    may_open.assign(part_.triangles.size(), false);
    for (const std::size_t t : shadow.triangles)
      may_open[part_.placeOf(t)] = true;
    may_open = ringsAround(part_, std::move(may_open), rings);
    for (std::size_t i = 0; i < may_open.size(); ++i)
      if (may_open[i])
        needed.extend(boxAt(part_.triangles[i]));
  }
  while (control_.spend(OPENING_WORK * part_.triangles.size()) &&
         !around_.contains(withRoom()));
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
  for (const auto& [t, triangle] : laid_.crumb)
    for (std::size_t c = 0; c < 3; ++c)
      sides.emplace(triangle[c], triangle[(c + 1) % 3]);
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
  const Triangle& side = laid_.crumb.begin()->second;
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
  const Opening opening = openFrom(part_, part_.placeOf(shadow.nearest), may_open);
  if (opening.border.empty() || opening.border.size() > LONGEST_BORDER ||
      isKnown(opening))
    return false;
  place_ = placeOf(part_, opening);
  place_.extend(box_);
  std::vector<std::size_t> staying = trianglesLeft(part_, opening, place_);
  if (meetsAny(staying))
    return false;
  const ModelPart left = surface_.part(std::move(staying), &control_, laid_.crumb);
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
  const auto weld = [&](pcl::index_t& vertex) {
    const auto kept = welded.find(vertex);
    vertex = kept == welded.end() ? vertex : kept->second;
  };
  std::vector<std::vector<RingPolygon>> cuts = cutsOf(outer, inner, touching);
  for (auto& rings : cuts)
    for (RingPolygon& ring : rings)
      std::for_each(ring.vertices.begin(), ring.vertices.end(), weld);
  const std::map<std::size_t, Triangle> unwelded = laid_.crumb;
  for (auto& [t, triangle] : laid_.crumb)
    std::for_each(triangle.begin(), triangle.end(), weld);
  ModelPart welded_left;
  if (!welded.empty())
    welded_left = surface_.part(left.triangles, &control_, laid_.crumb);
  const RingPlace place{
      part_, opening.is_open, welded.empty() ? left : welded_left, place_, &control_};
  laid_.ring = closeRing(cuts, place, course_);
  if (laid_.ring)
    laid_.hole = holeOf(opening);
  else
    laid_.crumb = unwelded;
  return laid_.ring.has_value();
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

LaidCrumb
layCrumb(const std::vector<std::size_t>& crumb,
         double edge,
         const Course& course,
         ccaa::RunControl* run,
         const GrowingSurface& surface)
{
  return CrumbLaying(crumb, edge, course, run, surface).run();
}

} // namespace pcl::repair
