// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a hole as a closed polygon of vertices, ready to be filled.

#include "hole/hole_polygon.h"

#include <utility>

namespace pcl::repair {

namespace {

class PolygonBuilder {
public:
  void
  add(pcl::index_t vertex, const Position& point, const Direction& normal_after)
  {
    polygon_.vertices.push_back(vertex);
    polygon_.curve.points.push_back(point);
    polygon_.curve.normals.push_back(normal_after);
  }

  /** The edge that leaves the point added last is none of its boundary. */
  void
  replaceLastNormal(const Direction& normal)
  {
    polygon_.curve.normals.back() = normal;
  }

  HolePolygon
  finish()
  {
    return std::move(polygon_);
  }

private:
  HolePolygon polygon_;
};

/** Walks a bridge from either end. */
struct BridgeWalk {
  const Bridge& bridge;
  bool backward;

  std::size_t
  at(std::size_t step) const
  {
    return backward ? bridge.points.size() - 1 - step : step;
  }
  Direction
  normalAfter(std::size_t step) const
  {
    return (bridge.normals[at(step)] + bridge.normals[at(step + 1)]).normalized();
  }
};

/** The points of a bridge between its supporting points, which the sections have. */
void
addInnerPoints(const BridgeWalk& walk,
               pcl::index_t first_inner,
               PolygonBuilder& builder)
{
  for (std::size_t step = 1; step + 1 < walk.bridge.points.size(); ++step)
    builder.add(first_inner + static_cast<pcl::index_t>(walk.at(step) - 1),
                walk.bridge.points[walk.at(step)],
                walk.normalAfter(step));
}

void
addSection(const BoundaryCurve& curve,
           const std::vector<pcl::index_t>& vertices,
           std::size_t from,
           std::size_t to,
           PolygonBuilder& builder)
{
  for (std::size_t v = from;; v = curve.next(v)) {
    builder.add(vertices[v], curve.points[v], curve.normals[v]);
    if (v == to)
      break;
  }
}

} // namespace

HolePolygon
polygonOf(const HoleContour& contour,
          const BoundaryEdges& boundaries,
          const std::vector<Bridge>& bridges,
          const ContourVertices& vertices)
{
  PolygonBuilder builder;
  const std::size_t count = contour.steps.size();
  for (std::size_t i = 0; i < count; ++i) {
    const ContourStep& step = contour.steps[i];
    const std::size_t number = step.section.from.curve;
    const BoundaryCurve& curve = boundaries.curves()[number].curve;
    const std::vector<pcl::index_t>& of_curve = vertices.of_curve[number];
    if (step.bridge == NONE) {
      addSection(curve, of_curve, 0, curve.size() - 1, builder);
      break;
    }
    addInnerPoints({bridges[step.bridge], step.backward},
                   vertices.first_inner[step.bridge],
                   builder);
    addSection(curve, of_curve, step.section.from.edge, step.section.to.edge, builder);
    const ContourStep& next = contour.steps[(i + 1) % count];
    builder.replaceLastNormal(
        BridgeWalk{bridges[next.bridge], next.backward}.normalAfter(0));
  }
  return builder.finish();
}

HolePolygon
polygonOf(const BoundaryLoop& loop)
{
  return {loop.curve, loop.vertices};
}

} // namespace pcl::repair
