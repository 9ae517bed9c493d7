// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a hole of which a part has been closed.

#include "filling/partial_filling.h"

#include "mesh/intersection.h"

#include <algorithm>
#include <utility>

namespace pcl::repair {

PartialFilling::PartialFilling(const FillingTask& task,
                               Triangles triangles,
                               const Positions& points)
: task_(task), points_(points), triangles_(std::move(triangles))
{
  do {
    readEdges();
    keepConnected();
    readEdges();
  }
  while (dropPinches());
  std::vector<ccaa::Box> boxes;
  for (const Triangle& triangle : triangles_)
    boxes.push_back(ccaa::boxOf(ccaa::cornersOf(triangle, points_)));
  tree_ = ccaa::BoxTree(boxes);
}

void
PartialFilling::readEdges()
{
  triangle_at_.clear();
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      triangle_at_[{triangles_[t][i], triangles_[t][(i + 1) % 3]}] = t;
}

/** From the edges of the polygon inwards. */
void
PartialFilling::keepConnected()
{
  std::vector<bool> reached(triangles_.size(), false);
  std::vector<std::size_t> open;
  const auto reach = [&](const HalfEdge& edge) {
    const auto found = triangle_at_.find(edge);
    if (found != triangle_at_.end() && !reached[found->second]) {
      reached[found->second] = true;
      open.push_back(found->second);
    }
  };
  for (std::size_t k = 0; k < task_.polygon.size(); ++k)
    reach({static_cast<pcl::index_t>(task_.polygon.next(k)),
           static_cast<pcl::index_t>(k)});
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Triangle triangle = triangles_[open[i]];
    for (std::size_t k = 0; k < 3; ++k)
      reach({triangle[(k + 1) % 3], triangle[k]});
  }
  std::sort(open.begin(), open.end());
  Triangles kept;
  for (const std::size_t t : open)
    kept.push_back(triangles_[t]);
  triangles_ = std::move(kept);
}

/** Drop the triangles at vertices with more than one gap. */
bool
PartialFilling::dropPinches()
{
  std::map<pcl::index_t, std::size_t> gaps;
  for (const HalfEdge& edge : openEdges())
    ++gaps[edge[0]];
  const std::size_t before = triangles_.size();
  triangles_.erase(
      std::remove_if(triangles_.begin(),
                     triangles_.end(),
                     [&](const Triangle& t) {
                       return std::any_of(t.begin(), t.end(), [&](pcl::index_t corner) {
                         const auto found = gaps.find(corner);
                         return found != gaps.end() && found->second > 1;
                       });
                     }),
      triangles_.end());
  return triangles_.size() < before;
}

/** Whether the surface around runs through an edge in this direction. */
bool
PartialFilling::isPolygonEdge(const HalfEdge& edge) const
{
  const auto from = static_cast<std::size_t>(edge[0]);
  return from < task_.polygon.size() &&
         static_cast<pcl::index_t>(task_.polygon.next(from)) == edge[1];
}

/** Edges with one triangle, in its direction: of the surface around, and of ours. */
std::vector<PartialFilling::HalfEdge>
PartialFilling::openEdges() const
{
  std::vector<HalfEdge> open;
  for (std::size_t k = 0; k < task_.polygon.size(); ++k) {
    const HalfEdge edge{static_cast<pcl::index_t>(k),
                        static_cast<pcl::index_t>(task_.polygon.next(k))};
    if (triangle_at_.count({edge[1], edge[0]}) == 0)
      open.push_back(edge);
  }
  for (const auto& [edge, triangle] : triangle_at_) {
    const HalfEdge backwards{edge[1], edge[0]};
    if (!isPolygonEdge(backwards) && triangle_at_.count(backwards) == 0)
      open.push_back(edge);
  }
  return open;
}

std::vector<std::vector<pcl::index_t>>
PartialFilling::openLoops() const
{
  std::map<pcl::index_t, pcl::index_t> next;
  for (const HalfEdge& edge : openEdges())
    next[edge[0]] = edge[1];
  std::vector<std::vector<pcl::index_t>> loops;
  while (!next.empty()) {
    std::vector<pcl::index_t> loop;
    for (auto at = next.begin(); at != next.end();) {
      loop.push_back(at->first);
      const pcl::index_t following = at->second;
      next.erase(at);
      at = next.find(following);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

Direction
PartialFilling::normalAlong(const HalfEdge& edge) const
{
  const auto inner = triangle_at_.find(edge);
  if (inner == triangle_at_.end())
    return task_.polygon.normals[static_cast<std::size_t>(edge[0])];
  return ccaa::unitNormal(ccaa::cornersOf(triangles_[inner->second], points_));
}

bool
PartialFilling::areJoined(pcl::index_t a, pcl::index_t b) const
{
  if (triangle_at_.count({a, b}) + triangle_at_.count({b, a}) > 0 ||
      isPolygonEdge({a, b}) || isPolygonEdge({b, a}))
    return true;
  const auto first = static_cast<std::size_t>(a);
  const auto second = static_cast<std::size_t>(b);
  return task_.joined && first < task_.polygon.size() &&
         second < task_.polygon.size() && task_.joined(first, second);
}

FillingTask
PartialFilling::taskFor(const std::vector<pcl::index_t>& loop) const
{
  FillingTask task;
  task.control = task_.control;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    task.polygon.points.push_back(points_[static_cast<std::size_t>(loop[k])]);
    task.polygon.normals.push_back(normalAlong({loop[k], loop[(k + 1) % loop.size()]}));
  }
  task.joined = [this, loop](std::size_t a, std::size_t b) {
    return areJoined(loop[a], loop[b]);
  };
  task.obstructed = [this](const ccaa::Corners& corners) {
    return meetsTriangles(corners) || (task_.obstructed && task_.obstructed(corners));
  };
  return task;
}

bool
PartialFilling::meetsTriangles(const ccaa::Corners& corners) const
{
  return tree_.anyMeeting(corners, [&](pcl::index_t i) {
    return ccaa::areasMeet(
        corners, ccaa::cornersOf(triangles_[static_cast<std::size_t>(i)], points_));
  });
}

} // namespace pcl::repair
