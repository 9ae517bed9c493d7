// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: walking the boundaries of a model (D4.1-2).
#include "boundary/extraction.h"

#include "boundary/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace pcl::repair {
namespace {

/** \brief An edge with one triangle: 3 * triangle + the corner where it begins. */
using HalfEdge = std::uint32_t;
constexpr HalfEdge NO_EDGE = static_cast<HalfEdge>(-1);

/** \brief An edge and the vertex from which it is walked. */
struct Step {
  HalfEdge edge;
  pcl::index_t vertex;

  bool
  operator<(const Step& other) const
  {
    return edge < other.edge;
  }
};
using Steps = std::vector<Step>;

/** \brief Walks from boundary edge to boundary edge. */
class BoundaryWalk {
public:
  explicit BoundaryWalk(const IncompleteModel& model) : model_(model), seams_(model)
  {
    ends_.assign(model.positions.size(), {NO_EDGE, NO_EDGE});
    for (std::size_t t = 0; t < model.triangles.size(); ++t)
      for (int corner = 0; corner < 3; ++corner) {
        if (model.adjacency.across(static_cast<pcl::index_t>(t), corner) >= 0)
          continue;
        const auto edge =
            static_cast<HalfEdge>(3 * t + static_cast<std::size_t>(corner));
        edges_.push_back(edge);
        addEnd(start(edge), edge);
        addEnd(stop(edge), edge);
      }
    seen_.assign(3 * model.triangles.size(), false);
  }

  BoundaryLoops
  run()
  {
    std::vector<Steps> walks;
    for (const HalfEdge edge : edges_)
      if (!seen_[edge])
        for (Steps& part : parted(walk(edge)))
          if (!runsAlongSeams(part))
            walks.push_back(std::move(part));
    std::sort(walks.begin(), walks.end()); // by their first, the lowest, edges
    BoundaryLoops loops;
    for (const Steps& steps : walks)
      loops.push_back(loopOf(steps));
    return loops;
  }

private:
  pcl::index_t
  start(HalfEdge edge) const
  {
    return model_.triangles[edge / 3][edge % 3];
  }
  pcl::index_t
  stop(HalfEdge edge) const
  {
    return model_.triangles[edge / 3][(edge % 3 + 1) % 3];
  }

  /** A vertex has one fan, so exactly two boundary edges or none. */
  void
  addEnd(pcl::index_t vertex, HalfEdge edge)
  {
    auto& ends = ends_[static_cast<std::size_t>(vertex)];
    ends[ends[0] == NO_EDGE ? 0 : 1] = edge;
  }

  HalfEdge
  otherEdge(pcl::index_t vertex, HalfEdge edge) const
  {
    const auto& ends = ends_[static_cast<std::size_t>(vertex)];
    return ends[0] == edge ? ends[1] : ends[0];
  }

  /** The vertex where the walk leaves an edge is its stop where windings agree; on a
   * one-sided island it may be its start. */
  Steps
  walk(HalfEdge first)
  {
    Steps steps;
    pcl::index_t vertex = start(first);
    for (HalfEdge edge = first; edge != NO_EDGE && !seen_[edge];
         edge = otherEdge(vertex, edge)) {
      seen_[edge] = true;
      steps.push_back({edge, vertex});
      vertex = vertex == start(edge) ? stop(edge) : start(edge);
    }
    return steps;
  }

  /** \brief What a walk may pass only once: a point, or a vertex that has none or lies
   * at a seam, across which no walk goes. */
  std::int64_t
  placeOf(const Step& step) const
  {
    const pcl::index_t point = Seams::pointOf(model_, step.vertex);
    return point != pcl::UNAVAILABLE && !seams_.containPoint(point)
               ? std::int64_t{point}
               : -2 - std::int64_t{step.vertex};
  }

  /** \brief Nothing is missing beyond such a walk: all of it lies on other triangles,
   * but for the free edges of single ones that were cut off. */
  bool
  runsAlongSeams(const Steps& steps) const
  {
    std::size_t seams = 0;
    for (const Step& step : steps) {
      const pcl::index_t from = Seams::pointOf(model_, start(step.edge));
      const pcl::index_t to = Seams::pointOf(model_, stop(step.edge));
      if (!seams_.containPoint(from) || !seams_.containPoint(to))
        return false;
      seams += seams_.containEdge(from, to) ? 1 : 0;
    }
    return 2 * seams > steps.size();
  }

  /** Takes a walk apart where it comes to a point again: it has gone around one gap
   * between the fans of the point, and goes around another one from there on. */
  std::vector<Steps>
  parted(Steps walk) const
  {
    std::vector<Steps> parts;
    Steps open;
    std::unordered_map<std::int64_t, std::size_t> rank_of; // of a place, among these
    for (const Step& step : walk) {
      const auto [entry, is_new] = rank_of.emplace(placeOf(step), open.size());
      if (!is_new) {
        const auto begin = open.begin() + static_cast<std::ptrdiff_t>(entry->second);
        for (auto done = begin + 1; done != open.end(); ++done)
          rank_of.erase(placeOf(*done));
        parts.emplace_back(begin, open.end());
        open.erase(begin, open.end());
      }
      open.push_back(step);
    }
    parts.push_back(std::move(open));
    const auto is_contour = [](const Steps& part) { return part.size() >= 3; };
    if (!std::all_of(parts.begin(), parts.end(), is_contour))
      return {std::move(walk)};
    for (Steps& part : parts)
      std::rotate(part.begin(), std::min_element(part.begin(), part.end()), part.end());
    return parts;
  }

  BoundaryLoop
  loopOf(const Steps& steps) const
  {
    BoundaryLoop loop;
    loop.island = model_.island_of[steps.front().edge / 3];
    for (const Step& step : steps) {
      loop.vertices.push_back(step.vertex);
      loop.triangles.push_back(static_cast<pcl::index_t>(step.edge / 3));
    }
    return loop;
  }

  const IncompleteModel& model_;
  Seams seams_;
  std::vector<HalfEdge> edges_; /**< ascending */
  std::vector<std::array<HalfEdge, 2>> ends_;
  std::vector<bool> seen_;
};

/** \brief A direction made perpendicular to a unit vector; nothing of a direction along
 * it, and of NaN. */
bool
makePerpendicular(const Direction& tangent, Direction& direction)
{
  /** Sine of the angle to the tangent below which rounding decides. */
  constexpr double SMALLEST_SINE = 1e-6;
  direction -= tangent * tangent.dot(direction);
  const double sine = direction.norm();
  if (!(sine > SMALLEST_SINE))
    return false;
  direction /= sine;
  return true;
}

Direction
triangleNormal(const IncompleteModel& model, pcl::index_t triangle)
{
  const Triangle& corners = model.triangles[static_cast<std::size_t>(triangle)];
  const Position& a = model.positions[static_cast<std::size_t>(corners[0])];
  const Position& b = model.positions[static_cast<std::size_t>(corners[1])];
  const Position& c = model.positions[static_cast<std::size_t>(corners[2])];
  return (b - a).cross(c - a).normalized();
}

Direction
edgeNormal(const IncompleteModel& model, const BoundaryLoop& loop, std::size_t k)
{
  const BoundaryCurve& curve = loop.curve;
  const Direction tangent = curve.edge(k).normalized(); // 0 of an edge without length
  const auto from = static_cast<std::size_t>(loop.vertices[k]);
  const auto to = static_cast<std::size_t>(loop.vertices[curve.next(k)]);
  Direction normal = model.normals[from] + model.normals[to];
  if (makePerpendicular(tangent, normal))
    return normal;
  normal = triangleNormal(model, loop.triangles[k]);
  if (makePerpendicular(tangent, normal))
    return normal;
  return tangent.squaredNorm() > 0.0 ? tangent.unitOrthogonal()
                                     : Direction(Direction::UnitZ());
}

void
fillCurve(const IncompleteModel& model, BoundaryLoop& loop)
{
  for (const pcl::index_t vertex : loop.vertices)
    loop.curve.points.push_back(model.positions[static_cast<std::size_t>(vertex)]);
  loop.curve.normals.reserve(loop.vertices.size());
  for (std::size_t k = 0; k < loop.vertices.size(); ++k)
    loop.curve.normals.push_back(edgeNormal(model, loop, k));
  loop.length = lengthOf(loop.curve);
}

} // namespace

BoundaryLoops
extractBoundaries(const IncompleteModel& model)
{
  BoundaryLoops loops = BoundaryWalk(model).run();
  for (BoundaryLoop& loop : loops)
    fillCurve(model, loop);
  return loops;
}

pcl::index_t
vertexBefore(const IncompleteModel& model, const BoundaryLoop& loop, std::size_t k)
{
  const pcl::index_t vertex = loop.vertices[k];
  const std::size_t edge = (k == 0 ? loop.triangles.size() : k) - 1;
  const Triangle& corners =
      model.triangles[static_cast<std::size_t>(loop.triangles[edge])];
  if (std::find(corners.begin(), corners.end(), vertex) != corners.end())
    return vertex;
  const auto point = [&](pcl::index_t corner) {
    return model.point_of_vertex[static_cast<std::size_t>(corner)];
  };
  const auto before =
      std::find_if(corners.begin(), corners.end(), [&](pcl::index_t corner) {
        return point(corner) == point(vertex);
      });
  return before == corners.end() ? vertex : *before; // parted at a seam
}

std::map<pcl::index_t, pcl::index_t>
pinchedVertices(const IncompleteModel& model, const BoundaryLoops& loops)
{
  std::map<pcl::index_t, pcl::index_t> lower; // leads to the lowest in some steps
  const auto lowest = [&lower](pcl::index_t vertex) {
    for (auto at = lower.find(vertex); at != lower.end(); at = lower.find(vertex))
      vertex = at->second;
    return vertex;
  };
  for (const BoundaryLoop& loop : loops)
    for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
      const pcl::index_t before = lowest(vertexBefore(model, loop, k));
      const pcl::index_t after = lowest(loop.vertices[k]);
      if (before != after)
        lower.emplace(std::max(before, after), std::min(before, after));
    }
  for (auto& [vertex, kept] : lower)
    kept = lowest(kept);
  return lower;
}

} // namespace pcl::repair
