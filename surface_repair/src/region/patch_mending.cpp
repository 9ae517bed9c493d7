// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch of which parts run into something is filled anew
// there.

#include "region/patch_mending.h"

#include "mesh/intersection.h"
#include "patch/growing_surface.h"
#include "region/opening_closing.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace pcl::repair {

namespace {

/** Rings around what runs into something that are taken out with it, one try after the
 * other. */
constexpr std::array<int, 5> MENDED_RINGS = {1, 2, 4, 8, 16};
/** Edges of what is filled anew; the time that takes grows with their cube. */
constexpr std::size_t LONGEST_MENDED = 128;
/** Parts that are filled anew at most. */
constexpr int MOST_PARTS = 32;
/** Share of a patch, or triangles of a small one, that may run into something: where it
 * is more, the patch as a whole is wrong. */
constexpr double MOST_OBSTRUCTED = 0.05;
constexpr double FEW_OBSTRUCTED = 8.0;
/** Triangles of the model that are looked at in an operation, and operations for one
 * that is made part of something. */
constexpr std::size_t TRIANGLES_AT_ONCE = 4;
constexpr std::size_t PART_WORK = 100;

std::size_t
mostObstructed(const Patch& patch)
{
  return static_cast<std::size_t>(std::max(
      FEW_OBSTRUCTED, MOST_OBSTRUCTED * static_cast<double>(patch.triangles.size())));
}

/** A patch and the surface around it. Vertices are numbered as in the patch, then those
 * of the surface, then new ones. */
class PatchMending {
public:
  PatchMending(const ClosingPlace& place,
               const SurfaceObstacle& obstacle,
               const ccaa::LoopContext& context,
               const Patch& patch)
  : place_(place)
  , context_(context)
  , rim_(patch.rim)
  , box_(boxAround(patch))
  , most_(mostObstructed(patch))
  , obstacle_(obstacle)
  , surface_(modelWith(patch), of_hole_, context.control)
  {
    obstacle.noteSeen(box_);
  }

  /** \return whether nothing of it runs into anything any more */
  bool
  run()
  {
    for (int parts = 0; parts <= MOST_PARTS && !context_.cancelled(); ++parts) {
      const std::vector<std::size_t> obstructed = obstructedNow();
      if (obstructed.empty())
        return true;
      if (obstructed.size() > most_ || parts == MOST_PARTS || !mend(obstructed))
        break;
    }
    return false;
  }

  /** \param[out] triangles which of the surface's they are */
  Patch
  patch(std::vector<std::size_t>* triangles = nullptr) const;

private:
  static ccaa::Box
  boxAround(const Patch& patch)
  {
    ccaa::Box box;
    for (const Position& position : patch.positions)
      box.extend(position);
    return ccaa::widened(box, 0.5 * box.diagonal().norm());
  }

  IncompleteModel
  modelWith(const Patch& patch);
  std::vector<std::size_t>
  obstructedNow() const;
  bool
  mend(const std::vector<std::size_t>& obstructed);

  const ClosingPlace& place_;
  const ccaa::LoopContext& context_;
  const std::vector<pcl::index_t>& rim_;
  ccaa::Box box_;
  std::vector<std::size_t> of_hole_; /**< of each triangle; NONE: it is no new one */
  std::size_t most_;                 /**< triangles that may run into something */
  const SurfaceObstacle& obstacle_;
  GrowingSurface surface_;
};

IncompleteModel
PatchMending::modelWith(const Patch& patch)
{
  IncompleteModel all;
  all.triangles = patch.triangles;
  all.positions = patch.positions;
  std::map<pcl::index_t, pcl::index_t> number_of;
  for (std::size_t v = 0; v < patch.rim.size(); ++v)
    number_of.emplace(patch.rim[v], static_cast<pcl::index_t>(v));
  for (Triangle triangle : place_.model.triangles) {
    if (!ccaa::boxOf(ccaa::cornersOf(triangle, place_.model.positions))
             .intersects(box_))
      continue;
    for (pcl::index_t& corner : triangle) {
      const auto [entry, is_new] =
          number_of.emplace(corner, static_cast<pcl::index_t>(all.positions.size()));
      if (is_new)
        all.positions.push_back(
            place_.model.positions[static_cast<std::size_t>(corner)]);
      corner = entry->second;
    }
    all.triangles.push_back(triangle);
  }
  all.point_of_vertex.assign(all.positions.size(), pcl::UNAVAILABLE);
  of_hole_.assign(all.triangles.size(), NONE);
  std::copy(patch.hole.begin(), patch.hole.end(), of_hole_.begin());
  return all;
}

Patch
PatchMending::patch(std::vector<std::size_t>* triangles) const
{
  Patch now;
  now.rim = rim_;
  now.positions.assign(surface_.positions.begin(),
                       surface_.positions.begin() +
                           static_cast<std::ptrdiff_t>(rim_.size()));
  std::map<pcl::index_t, pcl::index_t> number_of;
  for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
    if (!surface_.is_there[t] || surface_.hole[t] == NONE)
      continue;
    Triangle triangle = surface_.triangles[t];
    for (pcl::index_t& corner : triangle) {
      const auto vertex = static_cast<std::size_t>(corner);
      if (vertex < rim_.size())
        continue;
      const auto [entry, is_new] =
          number_of.emplace(corner, static_cast<pcl::index_t>(now.positions.size()));
      if (is_new)
        now.positions.push_back(surface_.positions[vertex]);
      corner = entry->second;
    }
    now.triangles.push_back(triangle);
    now.hole.push_back(surface_.hole[t]);
    if (triangles != nullptr)
      triangles->push_back(t);
  }
  now.free_point.assign(now.positions.size(), NONE);
  return now;
}

/** Of the surface. */
std::vector<std::size_t>
PatchMending::obstructedNow() const
{
  std::vector<std::size_t> triangles;
  std::vector<std::size_t> obstructed =
      obstructedTriangles(patch(&triangles), obstacle_, context_.control);
  for (std::size_t& triangle : obstructed)
    triangle = triangles[triangle];
  return obstructed;
}

/** What runs into something around the first of them. */
bool
PatchMending::mend(const std::vector<std::size_t>& obstructed)
{
  const ModelPart whole =
      surface_.part(surface_.near(box_, context_.control), context_.control);
  if (context_.cancelled())
    return false;
  std::vector<bool> some(whole.triangles.size(), false);
  for (std::size_t i = 0; i < some.size(); ++i)
    some[i] =
        std::binary_search(obstructed.begin(), obstructed.end(), whole.triangles[i]);
  const auto first = static_cast<std::size_t>(
      std::find(some.begin(), some.end(), true) - some.begin());
  const std::size_t of_hole = surface_.hole[whole.triangles[first]];
  std::size_t opened = 0;
  for (const int rings : MENDED_RINGS) {
    const Opening opening = openFrom(whole, first, ringsAround(whole, some, rings));
    const auto now = static_cast<std::size_t>(
        std::count(opening.is_open.begin(), opening.is_open.end(), true));
    if (now == opened || opening.border.size() > LONGEST_MENDED ||
        !ccaa::spend(context_.control, PART_WORK * opening.is_open.size()))
      break;
    opened = now;
    const ClosedOpening closed = closeOpening(
        opening, whole, box_, place_.parameters, place_.frame, context_, surface_);
    if (closed.outcome.open == OpenReason::NONE) {
      surface_.replace(closed.replacement, of_hole);
      return true;
    }
  }
  return false;
}

} // namespace

bool
mendPatch(const ClosingPlace& place,
          const SurfaceObstacle& obstacle,
          const ccaa::LoopContext& context,
          Patch& patch)
{
  // The surroundings are looked for in the whole model: not for nothing.
  ccaa::RunControl* const control = context.control;
  const std::size_t obstructed = obstructedTriangles(patch, obstacle, control).size();
  if (obstructed == 0 || obstructed > mostObstructed(patch))
    return obstructed == 0;
  if (!ccaa::spend(control, place.model.triangles.size() / TRIANGLES_AT_ONCE))
    return false;
  PatchMending mending(place, obstacle, context, patch);
  if (!mending.run())
    return false;
  Patch mended = mending.patch();
  if (surfaceKindOf(mended).genus != surfaceKindOf(patch).genus)
    return false;
  patch = std::move(mended);
  return true;
}

} // namespace pcl::repair
