// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: holes that bridges connect are closed together.

#include "region_closing.h"

#include <pcl/surface_repair/darning/completion_darning.h>
#include <pcl/surface_repair/icadm/model_assembly.h>

#include "../fairing/flat_cap.h"
#include "../junction/depth_jump.h"
#include "darning_choice.h"
#include "patch_assembly.h"
#include "patch_calming.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace pcl {
namespace repair {

namespace {

/** How a hole is closed. */
struct Care {
  bool avoiding; /**< the darn may not run through anything */
  bool relaxed;
  bool refined;
  bool basic; /**< free points do not become vertices */
};

/** One after the other, each when the one before has failed; basic ones only where free
 * points did become vertices. */
constexpr std::array<Care, 8> CARES = {{{false, true, true, false},
                                        {true, true, true, false},
                                        {false, false, true, false},
                                        {true, false, true, false},
                                        {true, false, false, false},
                                        {true, true, true, true},
                                        {true, false, true, true},
                                        {true, false, false, true}}};
/** So many of them for a hole that has others in its region: later it is alone. */
constexpr std::size_t CARES_AMONG_OTHERS = 1;
constexpr std::size_t GIVEN_UP = CARES.size();

/** Rings around what runs into something that go back, one try after the other. */
constexpr std::array<std::size_t, 4> CALMED_RINGS = {0, 2, 4, 8};

/** An edge between two vertices, the lower one first. */
using VertexPair = std::pair<pcl::index_t, pcl::index_t>;

VertexPair
pairOf(pcl::index_t a, pcl::index_t b)
{
  return {std::min(a, b), std::max(a, b)};
}

/** Edges that a darn must not have once more. */
class TakenEdges {
public:
  explicit TakenEdges(const IncompleteModel& model) : model_(model) {}

  void
  addPolygon(const HolePolygon& polygon)
  {
    for (std::size_t k = 0; k < polygon.size(); ++k)
      edges_.insert(
          pairOf(polygon.vertices[k], polygon.vertices[polygon.curve.next(k)]));
  }

  /** The inner edges of a darn between points of its polygon. */
  void
  addDarn(const HolePolygon& polygon, const Darn& darn)
  {
    const auto vertex = [&](pcl::index_t corner) {
      return polygon.vertices[static_cast<std::size_t>(corner)];
    };
    const auto on_polygon = [&](pcl::index_t corner) {
      return static_cast<std::size_t>(corner) < polygon.size();
    };
    for (const Triangle& t : darn.triangles)
      for (std::size_t c = 0; c < 3; ++c)
        if (on_polygon(t[c]) && on_polygon(t[(c + 1) % 3]))
          edges_.insert(pairOf(vertex(t[c]), vertex(t[(c + 1) % 3])));
  }

  bool
  contain(pcl::index_t a, pcl::index_t b) const
  {
    return edges_.count(pairOf(a, b)) > 0 || isInModel(a, b);
  }

private:
  bool
  isInModel(pcl::index_t a, pcl::index_t b) const
  {
    const auto vertices = static_cast<pcl::index_t>(model_.positions.size());
    return a < vertices && b < vertices && areJoined(model_, a, b);
  }

  const IncompleteModel& model_;
  std::set<VertexPair> edges_;
};

void
addArea(const DarnedPart& part, FillArea& fill)
{
  const auto place = [&](pcl::index_t corner) {
    const auto c = static_cast<std::size_t>(corner);
    return c < part.polygon.size() ? part.polygon.curve.points[c]
                                   : part.darn.inner[c - part.polygon.size()];
  };
  for (const Triangle& t : part.darn.triangles) {
    const Eigen::Vector3d normal =
        ccaa::areaNormal({place(t[0]), place(t[1]), place(t[2])});
    fill.vector += normal;
    fill.size += normal.norm();
  }
}

/** The nearest place that floats at an origin can hold. Through memory: GCC 12 takes a
 * vector of doubles that became floats and doubles again for the doubles that they
 * were. */
Position
nearestFloats(Position place, const Position& origin)
{
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double there =
        origin[axis] == 0.0 ? place[axis] : place[axis] + origin[axis]; // keeps -0
    volatile const float held = static_cast<float>(there);
    place[axis] = static_cast<double>(held) - origin[axis];
  }
  return place;
}

class RegionClosing {
public:
  RegionClosing(const ClosingPlace& place,
                const Region& region,
                const SurfaceObstacle& obstacle,
                const ccaa::LoopContext& context)
  : place_(place)
  , region_(region)
  , obstacle_(obstacle)
  , context_(context)
  , care_(region.holes.size(), 0)
  , completed_(region.holes.size(), false)
  , flat_(isToBeFlat())
  {
    result_.holes.resize(region.holes.size());
  }

  ClosedRegion
  run();

private:
  bool
  isToBeFlat() const;
  bool
  hasSamples(const HolePolygon& hole) const;
  void
  divide();
  const std::vector<ChosenDarn>&
  darnsOf(const Care& care);
  void
  darnAll();
  void
  leaveDepthJumps();
  void
  shapePatch();
  void
  relax();
  void
  look();
  void
  roundPositions();
  bool
  isSound();
  bool
  all(bool Care::*wanted) const;
  void
  raiseCare(std::size_t hole, OpenReason reason);
  DarningTask
  taskFor(const HolePolygon& polygon, const TakenEdges& taken, bool avoiding) const;

  const ClosingPlace& place_;
  const Region& region_;
  const SurfaceObstacle& obstacle_;
  const ccaa::LoopContext& context_;
  std::vector<std::size_t> care_; /**< of each hole: place in CARES */
  std::vector<DarnedPart> parts_; /**< of all holes, whether they are darned or not */
  std::vector<bool> completed_;   /**< of each hole: free points are vertices */
  bool flat_;                     /**< all lies in the plane of its rim */
  std::array<std::vector<ChosenDarn>, 3>
      darns_; /**< of the parts: plain, avoiding, and basic ones avoiding */
  ClosedRegion result_;
  std::vector<std::size_t> obstructed_; /**< triangles of the patch as it is */
};

/** What the user wants, or else what the rim is and whether free points speak against
 * it. */
bool
RegionClosing::isToBeFlat() const
{
  if (region_.cap != Cap::AUTO)
    return region_.cap == Cap::FLAT;
  const HolePolygon& hole = region_.holes.front();
  return isBase(hole.curve,
                place_.model,
                *place_.model.adjacency.begin(hole.vertices.front())) &&
         !hasSamples(hole);
}

/** Whether free points tell the surface within a large rim: such as were given for
 * that, or enough of them to be its vertices. */
bool
RegionClosing::hasSamples(const HolePolygon& hole) const
{
  const FreePointField* free_points = place_.guides.free_points.get();
  if (free_points == nullptr)
    return false;
  const RimPlane plane = planeOf(hole.curve);
  const std::vector<pcl::index_t> near =
      free_points->within(plane.center, 0.5 * plane.size);
  const bool has_given = std::any_of(near.begin(), near.end(), [&](pcl::index_t i) {
    return place_.model.point_of_free_point[static_cast<std::size_t>(i)] ==
           pcl::UNAVAILABLE;
  });
  if (has_given || near.empty())
    return has_given;
  const TakenEdges taken(place_.model);
  return darn(
             taskFor(hole, taken, false), place_.parameters.darning.choice, free_points)
             .method == CompletionDarning().name();
}

/** ICM2 -> ICM1 (4.5). */
void
RegionClosing::divide()
{
  const SubdivisionGuides guides{place_.guides.free_points.get(),
                                 place_.guides.surface.get()};
  std::size_t next = place_.model.positions.size() + region_.bridge_vertices;
  for (std::size_t h = 0; h < region_.holes.size(); ++h) {
    if (flat_) { // bridges would follow the surface around, out of the plane
      parts_.push_back({region_.holes[h], {}, h});
      continue;
    }
    DividedHole divided = divideHole(region_.holes[h],
                                     static_cast<pcl::index_t>(next),
                                     place_.parameters.survey,
                                     guides,
                                     context_);
    next += divided.new_vertices.size();
    for (HolePolygon& polygon : divided.holes)
      parts_.push_back({std::move(polygon), {}, h});
    result_.holes[h].bridges = std::move(divided.bridges);
  }
}

DarningTask
RegionClosing::taskFor(const HolePolygon& polygon,
                       const TakenEdges& taken,
                       bool avoiding) const
{
  DarningTask task;
  task.polygon = polygon.curve;
  task.joined = [&polygon, &taken](std::size_t a, std::size_t b) {
    return polygon.curve.points[a] == polygon.curve.points[b] ||
           taken.contain(polygon.vertices[a], polygon.vertices[b]);
  };
  if (avoiding)
    task.obstructed = [this](const ccaa::Corners& corners) {
      return obstacle_.meets(corners);
    };
  return task;
}

/** The darns of all parts in one way or the other: made once, they serve every care. */
const std::vector<ChosenDarn>&
RegionClosing::darnsOf(const Care& care)
{
  std::vector<ChosenDarn>& darns = darns_[care.basic ? 2 : care.avoiding ? 1 : 0];
  if (!darns.empty())
    return darns;
  TakenEdges taken(place_.model);
  for (const DarnedPart& part : parts_)
    taken.addPolygon(part.polygon);
  for (const DarnedPart& part : parts_) {
    darns.push_back(darn(taskFor(part.polygon, taken, care.avoiding),
                         care.basic || flat_ ? DarningChoice::MINIMUM_WEIGHT
                                             : place_.parameters.darning.choice,
                         place_.guides.free_points.get()));
    if (darns.back().darn.closed())
      taken.addDarn(part.polygon, darns.back().darn);
  }
  return darns;
}

void
RegionClosing::darnAll()
{
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    DarnedPart& part = parts_[p];
    std::size_t& care = care_[part.hole];
    if (care == GIVEN_UP)
      continue;
    HoleOutcome& outcome = result_.holes[part.hole];
    const bool avoiding = CARES[care].avoiding;
    const ChosenDarn& chosen = darnsOf(CARES[care])[p];
    part.darn = chosen.darn;
    outcome.darning = chosen.method;
    if (chosen.method == CompletionDarning().name())
      completed_[part.hole] = true;
    if (chosen.darn.closed())
      continue;
    ++outcome.tries;
    care = GIVEN_UP;
    outcome.open = avoiding ? OpenReason::INTERSECTION : OpenReason::NO_DARN;
  }
}

/** A surface that the sensor would see edge-on was never measured (free points are). */
void
RegionClosing::leaveDepthJumps()
{
  for (std::size_t hole = 0; hole < care_.size(); ++hole) {
    const bool is_wanted = !region_.is_wanted.empty() && region_.is_wanted[hole];
    if (care_[hole] == GIVEN_UP || is_wanted || completed_[hole])
      continue;
    FillArea fill;
    for (const DarnedPart& part : parts_)
      if (part.hole == hole)
        addArea(part, fill);
    const HolePolygon& polygon = region_.holes[hole];
    if (!isDepthJump(fill, polygon.curve, polygon.vertices, place_.model))
      continue;
    care_[hole] = GIVEN_UP;
    result_.holes[hole].open = OpenReason::DEPTH_JUMP;
  }
}

/** Whether all holes that are still to be closed want something. */
bool
RegionClosing::all(bool Care::*wanted) const
{
  return std::all_of(care_.begin(), care_.end(), [&](std::size_t care) {
    return care == GIVEN_UP || CARES[care].*wanted;
  });
}

/** Places that the cloud can hold: what is tested is what will be written. */
void
RegionClosing::roundPositions()
{
  if (!place_.float_positions)
    return;
  Positions& positions = result_.patch.positions;
  for (std::size_t v = result_.patch.rim.size(); v < positions.size(); ++v)
    positions[v] = nearestFloats(positions[v], place_.origin);
}

void
RegionClosing::shapePatch()
{
  std::vector<DarnedPart> closed;
  for (const DarnedPart& part : parts_)
    if (care_[part.hole] != GIVEN_UP)
      closed.push_back(part);
  result_.patch = assemblePatch(closed, place_.model.positions.size());
  const RepairParameters& parameters = place_.parameters;
  const bool refined = parameters.refine && all(&Care::refined);
  if (refined)
    refinePatch(place_.model, parameters.refinement, result_.patch);
  if (refined && parameters.relax && all(&Care::relaxed))
    relax();
  else
    look();
}

/** Where the relaxed patch runs into something, it goes back to what it was before, in
 * wider and wider surroundings. */
void
RegionClosing::relax()
{
  Patch& patch = result_.patch;
  const Positions before = patch.positions;
  RelaxationParameters relaxation = place_.parameters.relaxation;
  relaxation.trust = place_.parameters.survey.field.trust;
  if (flat_)
    flattenPatch(place_.model, patch);
  else
    relaxPatch(place_.model, place_.model.free_points, relaxation, patch);
  look();
  for (const std::size_t rings : CALMED_RINGS) {
    if (obstructed_.empty())
      return;
    calmPatch(before, obstructed_, rings, patch);
    look();
  }
}

/** What the patch, as it would be written, runs into. */
void
RegionClosing::look()
{
  roundPositions();
  obstructed_ = obstructedTriangles(result_.patch, obstacle_);
}

void
RegionClosing::raiseCare(std::size_t hole, OpenReason reason)
{
  if (care_[hole] == GIVEN_UP)
    return;
  ++result_.holes[hole].tries;
  ++care_[hole];
  const bool has_others = region_.holes.size() > 1;
  if ((has_others && care_[hole] >= CARES_AMONG_OTHERS) ||
      (care_[hole] != GIVEN_UP && CARES[care_[hole]].basic && !completed_[hole]))
    care_[hole] = GIVEN_UP;
  if (care_[hole] == GIVEN_UP)
    result_.holes[hole].open = reason;
}

/** \return false when a hole had to be closed in another way */
bool
RegionClosing::isSound()
{
  const Patch& patch = result_.patch;
  std::set<std::size_t> obstructed;
  for (const std::size_t triangle : obstructed_)
    obstructed.insert(patch.hole[triangle]);
  for (const std::size_t hole : obstructed)
    raiseCare(hole, OpenReason::INTERSECTION);
  if (!obstructed.empty() && region_.holes.size() == 1)
    return false;
  // What is left of the patch without the holes in question has no other fault.
  if (!obstructed.empty())
    result_.patch = withoutHoles(patch, obstructed);
  if (fitsModel(place_.model, patch))
    return true;
  if (!obstructed.empty())
    return false;
  for (std::size_t hole = 0; hole < care_.size(); ++hole)
    raiseCare(hole, OpenReason::NOT_MANIFOLD);
  return false;
}

ClosedRegion
RegionClosing::run()
{
  divide();
  do {
    darnAll();
    leaveDepthJumps();
    shapePatch();
  }
  while (!context_.cancelled() && !isSound());
  for (HoleOutcome& hole : result_.holes)
    if (hole.open != OpenReason::NONE)
      hole.darning.clear();
  return std::move(result_);
}

} // namespace

ClosedRegion
closeRegion(const ClosingPlace& place,
            const Region& region,
            const SurfaceObstacle& obstacle,
            const ccaa::LoopContext& context)
{
  return RegionClosing(place, region, obstacle, context).run();
}

} // namespace repair
} // namespace pcl
