// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what new triangles must not run through.

#include "patch/surface_obstacle.h"

#include "mesh/block_loop.h"
#include "mesh/exact_sign.h"
#include "mesh/intersection.h"

#include <algorithm>
#include <utility>

namespace pcl::repair {

namespace {

/** Operations of a search in a tree, and of a test of two triangles whose boxes meet.
 */
constexpr std::uint64_t SEARCH_WORK = 50;
constexpr std::uint64_t TEST_WORK = 5;
/** So many that were met last meet 0.65 to 0.85 of the triangles that are obstructed
 * next; with 16, 0.94, in no less time. */
constexpr std::size_t LAST_MET = 4;
/** Of a triangle that may come near. */
constexpr std::uint64_t TAKING_WORK = 3;

ccaa::BoxTree
treeOver(const std::vector<ccaa::Corners>& triangles, ccaa::RunControl* control)
{
  std::vector<ccaa::Box> boxes;
  boxes.reserve(triangles.size());
  for (const ccaa::Corners& corners : triangles)
    boxes.push_back(ccaa::boxOf(corners));
  ccaa::spend(control, TAKING_WORK * boxes.size());
  return ccaa::BoxTree(boxes, 1, control);
}

/** Whether a way from a corner of a triangle, the first one, runs within it. */
bool
runsWithin(const ccaa::Corners& triangle, const Position& to)
{
  const auto& [a, b, c] = triangle;
  if (ccaa::sideOfPlane(a, b, c, to) != 0)
    return false;
  const int axis = ccaa::droppableAxis(a, b, c);
  const int turn = ccaa::turnInPlane(a, b, c, axis);
  return ccaa::turnInPlane(a, b, to, axis) == turn &&
         ccaa::turnInPlane(a, to, c, axis) == turn;
}

/** Whether each triangle that has an edge meets another one for that (trianglesMeet()):
 * but for common corners the edge has a point in common with it. */
bool
crosses(const Position& p, const Position& q, const ccaa::Corners& triangle)
{
  const auto cornerAt = [&](const Position& place) {
    return static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), place) -
                                    triangle.begin());
  };
  const std::size_t at_p = cornerAt(p), at_q = cornerAt(q);
  if (at_p == 3 && at_q == 3)
    return ccaa::segmentMeetsTriangle(p, q, triangle);
  if (at_p != 3 && at_q != 3)
    return false;
  const std::size_t first = std::min(at_p, at_q);
  return runsWithin(
      {triangle[first], triangle[(first + 1) % 3], triangle[(first + 2) % 3]},
      at_p == 3 ? p : q);
}

/** Which boxes meet any of the places. */
class NearPlaces {
public:
  explicit NearPlaces(const std::vector<ccaa::Box>& places) : tree_(places)
  {
    for (const ccaa::Box& place : places)
      all_.extend(place);
  }

  bool
  contain(const ccaa::Box& box) const
  {
    return all_.intersects(box) &&
           tree_.anyMeeting(box, [](pcl::index_t) { return true; });
  }

private:
  ccaa::Box all_;
  ccaa::BoxTree tree_;
};

/** Whether a new vertex of a triangle lies exactly at another corner. Rims may have
 * corners in line; a new vertex can be anywhere else. */
bool
hasCollapsed(const Patch& patch, const Triangle& triangle)
{
  for (std::size_t i = 0; i < 3; ++i) {
    const pcl::index_t a = triangle[i], b = triangle[(i + 1) % 3];
    if (static_cast<std::size_t>(std::max(a, b)) >= patch.rim.size() &&
        patch.positions[std::size_t(a)] == patch.positions[std::size_t(b)])
      return true;
  }
  return false;
}

} // namespace

SurfaceObstacle::SurfaceObstacle(const IncompleteModel& model,
                                 const std::vector<ccaa::Box>& places,
                                 int threads,
                                 ccaa::RunControl* control)
{
  const NearPlaces near_places(places);
  ccaa::RunControl silent(control); // tells no stages
  const ccaa::LoopContext context{threads, &silent};
  std::vector<std::vector<ccaa::Corners>> found(
      context.blockCount(model.triangles.size()));
  ccaa::forEachBlock(model.triangles.size(),
                     context,
                     [&](std::size_t block, std::size_t begin, std::size_t end) {
                       ccaa::spend(context.control, TAKING_WORK * (end - begin));
                       for (std::size_t t = begin; t < end; ++t) {
                         const ccaa::Corners corners =
                             ccaa::cornersOf(model.triangles[t], model.positions);
                         if (near_places.contain(ccaa::boxOf(corners)) &&
                             !ccaa::isCollinear(corners))
                           found[block].push_back(corners);
                       }
                     });
  addLayer(ccaa::joinBlocks(found), control);
}

SurfaceObstacle
SurfaceObstacle::watched(ccaa::Box& seen) const
{
  SurfaceObstacle copy = *this;
  copy.seen_ = &seen;
  return copy;
}

void
SurfaceObstacle::add(const Positions& positions,
                     const Triangles& triangles,
                     ccaa::RunControl* control)
{
  std::vector<ccaa::Corners> layer;
  for (const Triangle& triangle : triangles) {
    const ccaa::Corners corners = ccaa::cornersOf(triangle, positions);
    if (!ccaa::isCollinear(corners))
      layer.push_back(corners);
  }
  addLayer(std::move(layer), control);
}

void
SurfaceObstacle::addLayer(std::vector<ccaa::Corners> triangles,
                          ccaa::RunControl* control)
{
  // Layers that are no larger become part of it, so that there are few: log n of them.
  while (!layers_.empty() && layers_.back()->triangles.size() <= triangles.size()) {
    const std::vector<ccaa::Corners>& last = layers_.back()->triangles;
    triangles.insert(triangles.end(), last.begin(), last.end());
    layers_.pop_back();
  }
  const auto layer = std::make_shared<Layer>();
  for (const ccaa::Corners& corners : triangles)
    layer->box.extend(ccaa::boxOf(corners));
  ccaa::spend(control, TAKING_WORK * triangles.size());
  layer->tree = treeOver(triangles, control);
  layer->triangles = std::move(triangles);
  layers_.push_back(layer);
}

/** \param[in] box of what is asked for \param[in] search for it in a tree */
template <typename Search, typename Test>
bool
SurfaceObstacle::holdsForAny(const ccaa::Box& box,
                             const Search& search,
                             const Test& test,
                             ccaa::RunControl* control) const
{
  noteSeen(box);
  ccaa::WorkCount work(control);
  work.add(SEARCH_WORK);
  bool found = false;
  for (const auto& layer : layers_)
    if (!found && layer->box.intersects(box))
      found = search(layer->tree, [&](pcl::index_t i) {
        return !work.add(TEST_WORK) ||
               test(layer->triangles[static_cast<std::size_t>(i)]);
      });
  return !work.tell() || found;
}

bool
LastMet::meets(const ccaa::Corners& corners, const ccaa::Box& box)
{
  const auto found =
      std::find_if(met_.begin(), met_.end(), [&](const ccaa::Corners& there) {
        return ccaa::boxOf(there).intersects(box) &&
               ccaa::trianglesMeet(corners, there);
      });
  if (found == met_.end())
    return false;
  std::rotate(met_.begin(), found, found + 1);
  return true;
}

void
LastMet::add(const ccaa::Corners& met)
{
  if (met_.size() == LAST_MET)
    met_.pop_back();
  met_.insert(met_.begin(), met);
}

bool
SurfaceObstacle::meets(const ccaa::Corners& corners,
                       ccaa::RunControl* control,
                       LastMet* last) const
{
  if (ccaa::isCollinear(corners))
    return false;
  const ccaa::Box box = ccaa::boxOf(corners);
  if (last != nullptr && last->meets(corners, box)) {
    noteSeen(box);
    ccaa::spend(control, TEST_WORK);
    return true;
  }
  const auto search = [&](const ccaa::BoxTree& tree, const auto& meets_it) {
    return tree.anyMeeting(corners, meets_it);
  };
  const auto test = [&](const ccaa::Corners& there) {
    const bool meets = ccaa::trianglesMeet(corners, there);
    if (meets && last != nullptr)
      last->add(there);
    return meets;
  };
  return holdsForAny(box, search, test, control);
}

bool
SurfaceObstacle::isCrossedBy(const Position& p,
                             const Position& q,
                             ccaa::RunControl* control) const
{
  const auto search = [&](const ccaa::BoxTree& tree, const auto& crosses_it) {
    return tree.anyAlong(p, q, crosses_it);
  };
  const auto test = [&](const ccaa::Corners& there) { return crosses(p, q, there); };
  return holdsForAny({p.cwiseMin(q), p.cwiseMax(q)}, search, test, control);
}

void
avoid(const SurfaceObstacle& obstacle, FillingTask& task)
{
  task.obstructed = [&obstacle, control = task.control, last = LastMet()](
                        const ccaa::Corners& corners) mutable {
    return obstacle.meets(corners, control, &last);
  };
  task.crossed = [&obstacle, control = task.control](const Position& p,
                                                     const Position& q) {
    return obstacle.isCrossedBy(p, q, control);
  };
  task.has_failed = true;
}

OpenReason
crossedEdges(const BoundaryCurve& polygon,
             const std::function<bool(std::size_t, std::size_t)>& is_given,
             const SurfaceObstacle& obstacle,
             ccaa::RunControl* control)
{
  OpenReason reason = OpenReason::NONE;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::size_t next = polygon.next(k);
    if (!obstacle.isCrossedBy(polygon.points[k], polygon.points[next], control))
      continue;
    if (is_given(k, next))
      return OpenReason::PIERCED;
    reason = OpenReason::INTERSECTION;
  }
  return reason;
}

std::vector<std::size_t>
obstructedTriangles(const Patch& patch,
                    const SurfaceObstacle& obstacle,
                    ccaa::RunControl* control)
{
  const std::vector<ccaa::Corners> triangles =
      ccaa::cornersOf(patch.triangles, patch.positions);
  const ccaa::BoxTree tree = treeOver(triangles, control);
  std::vector<bool> obstructed(triangles.size(), false);
  std::vector<std::size_t> found;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (ccaa::isCollinear(triangles[t])) {
      obstructed[t] = hasCollapsed(patch, patch.triangles[t]);
      continue;
    }
    if (obstacle.meets(triangles[t], control))
      obstructed[t] = true;
    std::uint64_t work = SEARCH_WORK;
    tree.forEachMeeting(triangles[t], [&](pcl::index_t i) {
      const auto other = static_cast<std::size_t>(i);
      work += TEST_WORK;
      if (other > t && !(obstructed[t] && obstructed[other]) &&
          !ccaa::isCollinear(triangles[other]) &&
          ccaa::trianglesMeet(triangles[t], triangles[other]))
        obstructed[t] = obstructed[other] = true;
    });
    ccaa::spend(control, work);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (obstructed[t])
      found.push_back(t);
  return found;
}

} // namespace pcl::repair
