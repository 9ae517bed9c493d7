// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a disc of new triangles that is to be filled anew.

#include "patch/opening.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace pcl::repair {

namespace {

using DirectedEdge = std::pair<pcl::index_t, pcl::index_t>;

/** Grows a disc of new triangles: each comes with one new vertex, or fills a notch. */
class DiscGrowth {
public:
  explicit DiscGrowth(const ModelPart& part)
  : part_(part)
  , is_open_(part.triangles.size(), false)
  , is_corner_(part.vertices.size(), false)
  {}

  void
  open(std::size_t triangle)
  {
    is_open_[triangle] = true;
    for (const pcl::index_t corner : part_.model.triangles[triangle])
      is_corner_[static_cast<std::size_t>(corner)] = true;
  }

  void
  addHole(const std::vector<pcl::index_t>& hole)
  {
    for (std::size_t k = 0; k < hole.size(); ++k) {
      is_corner_[static_cast<std::size_t>(hole[k])] = true;
      hole_.emplace(hole[k], hole[(k + 1) % hole.size()]);
    }
  }

  Opening
  run(const std::vector<bool>& may_open)
  {
    for (bool grows = true; grows;) {
      grows = false;
      for (std::size_t t = 0; t < is_open_.size(); ++t)
        if (may_open[t] && !is_open_[t] && staysDisc(t)) {
          open(t);
          grows = true;
        }
    }
    return {is_open_, border()};
  }

private:
  DirectedEdge
  edge(std::size_t triangle, int corner) const
  {
    const Triangle& corners = part_.model.triangles[triangle];
    return {corners[static_cast<std::size_t>(corner)],
            corners[static_cast<std::size_t>((corner + 1) % 3)]};
  }

  /** Whether the disc, or the hole in it, lies beyond an edge. */
  bool
  isShared(std::size_t triangle, int corner) const
  {
    const pcl::index_t across =
        part_.model.adjacency.across(static_cast<pcl::index_t>(triangle), corner);
    return across >= 0 ? is_open_[static_cast<std::size_t>(across)]
                       : hole_.count(edge(triangle, corner)) > 0;
  }

  bool
  staysDisc(std::size_t triangle) const
  {
    int shared = 0;
    bool has_new = false;
    for (int c = 0; c < 3; ++c) {
      if (isShared(triangle, c)) {
        const pcl::index_t opposite =
            part_.model.triangles[triangle][static_cast<std::size_t>((c + 2) % 3)];
        ++shared;
        has_new = has_new || !is_corner_[static_cast<std::size_t>(opposite)];
      }
      else if (part_.model.adjacency.across(static_cast<pcl::index_t>(triangle), c) < 0)
        return false; // at another border
    }
    return shared == 2 || (shared == 1 && has_new);
  }

  /** Its edges as the surface around has them, one after the other. */
  std::vector<pcl::index_t>
  border() const
  {
    std::map<pcl::index_t, pcl::index_t> next;
    std::set<DirectedEdge> left = hole_;
    for (std::size_t t = 0; t < is_open_.size(); ++t)
      for (int c = 0; is_open_[t] && c < 3; ++c) {
        const auto [from, to] = edge(t, c);
        if (left.erase({from, to}) == 0 && !isShared(t, c) &&
            !next.emplace(to, from).second)
          return {};
      }
    for (const auto& [from, to] : left)
      if (!next.emplace(from, to).second)
        return {};
    std::vector<pcl::index_t> loop;
    if (next.empty())
      return loop;
    auto edge = next.begin();
    do {
      loop.push_back(edge->first);
      edge = next.find(edge->second);
    }
    while (edge != next.end() && edge->first != loop.front() &&
           loop.size() <= next.size());
    return loop.size() == next.size() ? loop : std::vector<pcl::index_t>();
  }

  const ModelPart& part_;
  std::vector<bool> is_open_;
  std::vector<bool> is_corner_; /**< of the part's vertices */
  std::set<DirectedEdge> hole_; /**< as the triangles around it have them */
};

} // namespace

std::vector<bool>
ringsAround(const ModelPart& part, std::vector<bool> some, int rings)
{
  bool is_growing = true;
  for (int ring = 0; ring < rings && is_growing; ++ring) {
    is_growing = false;
    std::vector<bool> touched(part.vertices.size(), false);
    for (std::size_t t = 0; t < some.size(); ++t)
      if (some[t])
        for (const pcl::index_t corner : part.model.triangles[t])
          touched[static_cast<std::size_t>(corner)] = true;
    for (std::size_t t = 0; t < some.size(); ++t) {
      const Triangle& corners = part.model.triangles[t];
      if (!some[t] && part.is_new[t] &&
          std::any_of(corners.begin(), corners.end(), [&](pcl::index_t corner) {
            return touched[static_cast<std::size_t>(corner)];
          }))
        some[t] = is_growing = true;
    }
  }
  return some;
}

Opening
openFrom(const ModelPart& part, std::size_t first, const std::vector<bool>& may_open)
{
  DiscGrowth growth(part);
  growth.open(first);
  return growth.run(may_open);
}

Opening
openFrom(const ModelPart& part,
         const std::vector<pcl::index_t>& hole,
         const std::vector<bool>& may_open)
{
  DiscGrowth growth(part);
  growth.addHole(hole);
  return growth.run(may_open);
}

ccaa::Box
placeOf(const ModelPart& part, const Opening& opening)
{
  ccaa::Box box;
  for (const pcl::index_t vertex : opening.border)
    box.extend(part.model.positions[static_cast<std::size_t>(vertex)]);
  return ccaa::widened(box, 0.5 * box.diagonal().norm());
}

bool
isWithin(const ccaa::Box& box, const ModelPart& part, const Opening& opening)
{
  return std::all_of(
      opening.border.begin(), opening.border.end(), [&](pcl::index_t vertex) {
        return box.contains(part.model.positions[static_cast<std::size_t>(vertex)]);
      });
}

const BoundaryLoop*
loopAt(const BoundaryLoops& loops, pcl::index_t vertex)
{
  const auto found =
      std::find_if(loops.begin(), loops.end(), [&](const BoundaryLoop& loop) {
        return std::find(loop.vertices.begin(), loop.vertices.end(), vertex) !=
               loop.vertices.end();
      });
  return found == loops.end() ? nullptr : &*found;
}

const BoundaryLoop*
loopOf(const Opening& opening,
       const ModelPart& part,
       const ModelPart& left,
       const BoundaryLoops& loops)
{
  const auto first = static_cast<std::size_t>(opening.border.front());
  const auto vertex = left.number_of.find(part.vertices[first]);
  if (vertex == left.number_of.end()) // all around it is open
    return nullptr;
  const BoundaryLoop* loop = loopAt(loops, vertex->second);
  return loop != nullptr && loop->vertices.size() == opening.border.size() ? loop
                                                                           : nullptr;
}

std::vector<std::size_t>
trianglesLeft(const ModelPart& part, const Opening& opening, const ccaa::Box& place)
{
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < part.triangles.size(); ++i)
    if (!opening.is_open[i] &&
        ccaa::boxOf(ccaa::cornersOf(part.model.triangles[i], part.model.positions))
            .intersects(place))
      left.push_back(part.triangles[i]);
  return left;
}

bool
isFree(const Patch& patch,
       const ccaa::Box& place,
       const SurfaceObstacle& obstacle,
       ccaa::RunControl* control)
{
  return std::all_of(
             patch.positions.begin(),
             patch.positions.end(),
             [&](const Position& position) { return place.contains(position); }) &&
         obstructedTriangles(patch, obstacle, control).empty();
}

} // namespace pcl::repair
