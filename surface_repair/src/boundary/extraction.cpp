// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: walking the boundaries of a model (D4.1-2).
#include <pcl/surface_repair/boundary/extraction.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace pcl {
namespace repair {
namespace {

/** \brief An edge with one triangle: 3 * triangle + the corner where it begins. */
using HalfEdge = std::uint32_t;
constexpr HalfEdge NO_EDGE = static_cast<HalfEdge>(-1);

/** \brief Walks from boundary edge to boundary edge. */
class BoundaryWalk {
public:
  explicit BoundaryWalk(const IncompleteModel& model) : model_(model)
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
    BoundaryLoops loops;
    for (const HalfEdge edge : edges_)
      if (!seen_[edge])
        loops.push_back(walk(edge));
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
  BoundaryLoop
  walk(HalfEdge first)
  {
    BoundaryLoop loop;
    loop.island = model_.island_of[first / 3];
    pcl::index_t vertex = start(first);
    for (HalfEdge edge = first; edge != NO_EDGE && !seen_[edge];
         edge = otherEdge(vertex, edge)) {
      seen_[edge] = true;
      loop.vertices.push_back(vertex);
      loop.triangles.push_back(static_cast<pcl::index_t>(edge / 3));
      vertex = vertex == start(edge) ? stop(edge) : start(edge);
    }
    return loop;
  }

  const IncompleteModel& model_;
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

} // namespace repair
} // namespace pcl
