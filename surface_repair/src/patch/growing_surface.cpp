// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a surface of which parts are taken out and filled anew.

#include "patch/growing_surface.h"

#include "icadm/model_assembly.h"
#include "mesh/intersection.h"

#include <algorithm>
#include <utility>

namespace pcl::repair {

namespace {

/** Operations for a triangle that is looked at or copied, that is found near a place,
 * and that becomes part of a model. */
constexpr std::uint64_t LOOK_WORK = 1;
constexpr std::uint64_t NEAR_WORK = 5;
constexpr std::uint64_t MODEL_WORK = 30;

/** Square of the number of triangles beside the tree, over that of all, from which the
 * tree is built anew: then that takes as long as looking at those beside it has taken.
 */
constexpr std::size_t MOST_ADDED = 100;

} // namespace

std::size_t
ModelPart::placeOf(std::size_t triangle) const
{
  return static_cast<std::size_t>(
      std::lower_bound(triangles.begin(), triangles.end(), triangle) -
      triangles.begin());
}

GrowingSurface::GrowingSurface(const IncompleteModel& model,
                               const std::vector<std::size_t>& of_hole,
                               ccaa::RunControl* control)
: triangles(model.triangles)
, positions(model.positions)
, point_of_vertex(model.point_of_vertex)
, hole(of_hole)
, is_there(model.triangles.size(), true)
{
  buildTree(control);
}

void
GrowingSurface::buildTree(ccaa::RunControl* control)
{
  std::vector<ccaa::Box> boxes(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (is_there[t])
      boxes[t] = ccaa::boxOf(ccaa::cornersOf(triangles[t], positions));
  ccaa::spend(control, NEAR_WORK * boxes.size());
  tree_ = ccaa::BoxTree(boxes, 1, control);
  in_tree_ = triangles.size();
}

std::vector<std::size_t>
GrowingSurface::meeting(const std::vector<std::size_t>& some,
                        ccaa::RunControl* control) const
{
  const auto corners_of = [&](std::size_t t) {
    return ccaa::cornersOf(triangles[t], positions);
  };
  std::vector<std::size_t> found;
  for (const std::size_t own : some)
    for (const std::size_t other : near(ccaa::boxOf(corners_of(own)), control))
      if (hole[other] != NONE && ccaa::areasMeet(corners_of(own), corners_of(other)))
        found.push_back(other);
  return found;
}

bool
GrowingSurface::hasChanged() const
{
  return std::find(is_there.begin(), is_there.end(), false) != is_there.end();
}

std::vector<ccaa::Box>
GrowingSurface::gone() const
{
  std::vector<ccaa::Box> boxes;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (!is_there[t])
      boxes.push_back(ccaa::boxOf(ccaa::cornersOf(triangles[t], positions)));
  return boxes;
}

/** \param[in] counts whether a triangle is asked for */
template <typename Counts>
std::vector<std::size_t>
GrowingSurface::meetingBox(const ccaa::Box& box,
                           const Counts& counts,
                           ccaa::RunControl* control) const
{
  std::vector<std::size_t> found;
  const auto look = [&](std::size_t t) {
    if (is_there[t] && counts(t) &&
        ccaa::boxOf(ccaa::cornersOf(triangles[t], positions)).intersects(box))
      found.push_back(t);
  };
  tree_.forEachMeeting(box, [&](pcl::index_t t) { look(static_cast<std::size_t>(t)); });
  for (std::size_t t = in_tree_; t < triangles.size(); ++t)
    look(t);
  ccaa::spend(control,
              NEAR_WORK * (found.size() + 1) +
                  LOOK_WORK * (triangles.size() - in_tree_));
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::size_t>
GrowingSurface::near(const ccaa::Box& box, ccaa::RunControl* control) const
{
  return meetingBox(
      box, [](std::size_t) { return true; }, control);
}

std::vector<std::size_t>
GrowingSurface::patchesNear(const ccaa::Box& box, ccaa::RunControl* control) const
{
  return meetingBox(
      box, [&](std::size_t t) { return hole[t] != NONE; }, control);
}

ModelPart
GrowingSurface::part(std::vector<std::size_t> chosen,
                     ccaa::RunControl* control,
                     const std::map<std::size_t, Triangle>& others) const
{
  ModelPart found;
  ccaa::RunControl silent(control); // tells no stages
  const ccaa::LoopContext context{1, &silent};
  Triangles own;
  Positions places;
  found.number_of.reserve(chosen.size());
  for (const std::size_t t : chosen) {
    const auto other = others.find(t);
    Triangle triangle = other == others.end() ? triangles[t] : other->second;
    for (pcl::index_t& corner : triangle) {
      const auto [entry, is_new] =
          found.number_of.emplace(corner, static_cast<pcl::index_t>(places.size()));
      if (is_new) {
        found.vertices.push_back(corner);
        places.push_back(positions[static_cast<std::size_t>(corner)]);
      }
      corner = entry->second;
    }
    own.push_back(triangle);
    found.is_new.push_back(hole[t] != NONE);
  }
  found.triangles = std::move(chosen);
  ccaa::spend(control, MODEL_WORK * own.size());
  found.model = assembleModel(std::move(own), std::move(places), context);
  return found;
}

Replacement
replacementIn(const ModelPart& part,
              const std::vector<bool>& is_gone,
              const ModelPart& left,
              Patch patch)
{
  Replacement replacement;
  for (std::size_t i = 0; i < is_gone.size(); ++i)
    if (is_gone[i])
      replacement.gone.push_back(part.triangles[i]);
  for (pcl::index_t& vertex : patch.rim)
    vertex = left.vertices[static_cast<std::size_t>(vertex)];
  replacement.patch = std::move(patch);
  return replacement;
}

ccaa::Box
GrowingSurface::remove(const std::vector<std::size_t>& some)
{
  ccaa::Box place;
  for (const std::size_t t : some) {
    is_there[t] = false;
    place.extend(ccaa::boxOf(ccaa::cornersOf(triangles[t], positions)));
  }
  return place;
}

ccaa::Box
GrowingSurface::replace(const Replacement& replacement, std::size_t of_hole)
{
  ccaa::Box place = remove(replacement.gone);
  const Patch& patch = replacement.patch;
  std::vector<pcl::index_t> number = patch.rim;
  for (std::size_t v = patch.rim.size(); v < patch.positions.size(); ++v) {
    number.push_back(static_cast<pcl::index_t>(positions.size()));
    positions.push_back(patch.positions[v]);
    point_of_vertex.push_back(pcl::UNAVAILABLE);
  }
  for (Triangle triangle : patch.triangles) {
    for (pcl::index_t& corner : triangle)
      corner = number[static_cast<std::size_t>(corner)];
    place.extend(ccaa::boxOf(ccaa::cornersOf(triangle, positions)));
    triangles.push_back(triangle);
    hole.push_back(of_hole);
    is_there.push_back(true);
  }
  const std::size_t added = triangles.size() - in_tree_;
  if (added * added > MOST_ADDED * triangles.size())
    buildTree(nullptr);
  return place;
}

} // namespace pcl::repair
