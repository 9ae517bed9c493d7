// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the ring between an opening and what lies within it.

#include "pass/ring_filling.h"

#include "fairing/refinement.h"
#include "fairing/relaxation.h"
#include "filling/minimum_weight_filling.h"
#include "icadm/model_assembly.h"
#include "mesh/intersection.h"
#include "mesh/sort_unique.h"
#include "patch/opening.h"
#include "patch/patch_assembly.h"
#include "patch/relaxation_rollback.h"
#include "region/patch_mending.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl::repair {

std::vector<LoopPlaces>
touchingPlaces(const GrowingSurface& surface,
               const BoundaryLoop& outer,
               const BoundaryLoop& inner)
{
  std::vector<LoopPlaces> touching;
  const auto point_of = [&](const BoundaryLoop& loop, std::size_t place) {
    return surface.pointOf(loop.vertices[place]);
  };
  for (std::size_t o = 0; o < outer.vertices.size(); ++o)
    for (std::size_t i = 0; i < inner.vertices.size(); ++i)
      if (point_of(outer, o) != pcl::UNAVAILABLE &&
          point_of(outer, o) == point_of(inner, i))
        touching.emplace_back(o, i);
  return touching;
}

namespace {

/** Triangles that run into something of a ring that is worth fairing or mending: of 1
 * 100 rings around crumbs with more before they were refined, none came out free, and
 * four could be mended. */
constexpr std::size_t MOST_MENDED = 8;
/** Triangles that run into something of a ring that is filled as if nothing were in the
 * way, above which it is given up: of 148 such rings of five scans and 40 damaged
 * bodies none was closed, whatever was avoided and however it was cut. */
constexpr std::size_t HOPELESS = 32;
/** Rings around what runs into something that are not relaxed. */
constexpr std::array<std::size_t, 3> UNRELAXED_RINGS = {0, 2, 8};

/** \param[in] part that has their vertices \param[in] obstacle to be avoided, or null
 * \return without triangles where one of them cannot be filled */
Patch
fillRings(const std::vector<RingPolygon>& rings,
          const ModelPart& part,
          const SurfaceObstacle* obstacle,
          ccaa::RunControl* control)
{
  Patch patch;
  Triangles triangles; // of vertices of the part
  for (const RingPolygon& ring : rings) {
    if (std::any_of(ring.vertices.begin(), ring.vertices.end(), [&](pcl::index_t v) {
          return part.number_of.count(v) == 0;
        }))
      return {}; // nothing is left around it
    const auto in_part = [&](std::size_t k) {
      return part.number_of.at(ring.vertices[k]);
    };
    FillingTask task;
    task.control = control;
    task.polygon = ring.curve;
    task.vertices = ring.vertices;
    const std::size_t last = ring.vertices.size() - 1;
    task.joined = [&](std::size_t a, std::size_t b) {
      const std::pair<pcl::index_t, pcl::index_t> edge =
          std::minmax(in_part(a), in_part(b));
      return edge.first == edge.second ||
             edge == std::pair<pcl::index_t, pcl::index_t>(
                         std::minmax(in_part(0), in_part(last))) ||
             areJoined(part.model, edge.first, edge.second);
    };
    if (obstacle != nullptr)
      avoid(*obstacle, task);
    task.obstructed = [meets = task.obstructed](const ccaa::Corners& corners) {
      return ccaa::isCollinear(corners) || (meets && meets(corners));
    };
    if (last < 2) // an edge of both loops
      continue;
    const Filling filling = MinimumWeightFilling().close(task);
    if (!filling.closed() || ccaa::isCancelled(control))
      return {};
    for (const Triangle& triangle : filling.triangles) {
      triangles.push_back({in_part(static_cast<std::size_t>(triangle[0])),
                           in_part(static_cast<std::size_t>(triangle[1])),
                           in_part(static_cast<std::size_t>(triangle[2]))});
      patch.rim.insert(
          patch.rim.end(), triangles.back().begin(), triangles.back().end());
    }
  }
  ccaa::sortUnique(patch.rim);
  for (Triangle& triangle : triangles)
    for (pcl::index_t& corner : triangle)
      corner = static_cast<pcl::index_t>(
          std::lower_bound(patch.rim.begin(), patch.rim.end(), corner) -
          patch.rim.begin());
  for (const pcl::index_t vertex : patch.rim)
    patch.positions.push_back(part.model.positions[static_cast<std::size_t>(vertex)]);
  patch.free_point.assign(patch.rim.size(), NONE);
  patch.hole.assign(triangles.size(), 0);
  patch.triangles = std::move(triangles);
  return patch;
}

/** Whether the surface crosses an edge of the loops: what is filled there meets it. */
bool
isPierced(const std::vector<RingPolygon>& rings,
          const ModelPart& part,
          const SurfaceObstacle& obstacle,
          ccaa::RunControl* control)
{
  return std::any_of(rings.begin(), rings.end(), [&](const RingPolygon& ring) {
    const auto is_given = [&](std::size_t from, std::size_t to) {
      const auto a = part.number_of.find(ring.vertices[from]);
      const auto b = part.number_of.find(ring.vertices[to]);
      return a != part.number_of.end() && b != part.number_of.end() &&
             areJoined(part.model, a->second, b->second);
    };
    return crossedEdges(ring.curve, is_given, obstacle, control) == OpenReason::PIERCED;
  });
}

/** Where it runs into something, it is not relaxed. */
void
fair(const IncompleteModel& model,
     const SurfaceObstacle& obstacle,
     const RepairParameters& parameters,
     ccaa::RunControl* control,
     Patch& patch)
{
  if (!parameters.refine)
    return;
  refinePatch(model, parameters.refinement, patch, false, control);
  if (!parameters.relax)
    return;
  const Positions before = patch.positions;
  RelaxationParameters relaxation = parameters.relaxation;
  relaxation.trust = 0.0;
  relaxPatch(model, {}, relaxation, patch, control);
  for (const std::size_t rings : UNRELAXED_RINGS) {
    const std::vector<std::size_t> obstructed =
        obstructedTriangles(patch, obstacle, control);
    if (obstructed.empty() || ccaa::isCancelled(control))
      return;
    rollBackRelaxation(before, obstructed, rings, patch);
  }
}

struct ClosedCut {
  std::optional<Replacement> patch;
  bool is_hopeless = false; /**< other cuts will not do either */
};

ClosedCut
closeCut(const std::vector<RingPolygon>& rings,
         const RingPlace& place,
         const Course& course)
{
  const IncompleteModel& model = place.left.model;
  ccaa::RunControl* const control = place.control;
  const SurfaceObstacle& obstacle = place.obstacle;
  if (isPierced(rings, place.left, obstacle, control))
    return {};
  const ClosingPlace here = withinPart(model, course.parameters, course.frame);
  const auto fits = [&](const Patch& patch) {
    return isFree(patch, place.box, obstacle, control) && !ccaa::isCancelled(control) &&
           fitsModel(model, patch);
  };
  const auto with = [&](Patch patch) {
    return ClosedCut{
        replacementIn(place.part, place.is_open, place.left, std::move(patch))};
  };
  std::vector<Patch> refined;
  for (const bool avoids : {false, true}) {
    Patch bare = fillRings(rings, place.left, avoids ? &obstacle : nullptr, control);
    if (bare.triangles.empty() || !fitsModel(model, bare))
      continue;
    const std::size_t in_the_way = obstructedTriangles(bare, obstacle, control).size();
    if (in_the_way > HOPELESS)
      return {{}, true};
    if (in_the_way > MOST_MENDED)
      continue;
    Patch patch = bare;
    fair(model, obstacle, course.parameters, control, patch);
    if (course.frame.float_positions)
      roundToFloats(course.frame.origin, patch);
    if (fits(patch))
      return with(std::move(patch));
    if (in_the_way == 0 && fits(bare))
      return with(std::move(bare));
    refined.push_back(std::move(patch));
  }
  for (Patch& patch : refined)
    if (obstructedTriangles(patch, obstacle, control).size() <= MOST_MENDED &&
        mendPatch(here, obstacle, course.context, patch) && fits(patch))
      return with(std::move(patch));
  return {};
}

} // namespace

std::optional<Replacement>
closeRing(const std::vector<std::vector<RingPolygon>>& cuts,
          const RingPlace& place,
          const Course& course)
{
  ClosedCut closed;
  for (const std::vector<RingPolygon>& cut : cuts) {
    if (closed.patch || closed.is_hopeless || ccaa::isCancelled(place.control))
      break;
    closed = closeCut(cut, place, course);
  }
  return std::move(closed.patch);
}

} // namespace pcl::repair
