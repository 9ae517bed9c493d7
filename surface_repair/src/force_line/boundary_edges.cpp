// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the boundary edges at which a force line can end.

#include "force_line/boundary_edges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace repair {

namespace {

struct ClosestPair {
  double along_first = 0.0;
  double along_second = 0.0;
  double squared_distance = 0.0;
};

double
clampedRatio(double numerator, double denominator)
{
  return denominator > 0.0 ? std::clamp(numerator / denominator, 0.0, 1.0) : 0.0;
}

/** Closest points of the segments a + s u and b + t v, 0 <= s, t <= 1: the closest
 * points of the lines, then each parameter clamped in turn. */
ClosestPair
closestPair(const Position& a,
            const Eigen::Vector3d& u,
            const Position& b,
            const Eigen::Vector3d& v)
{
  const Eigen::Vector3d between = a - b;
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  const double uv = u.dot(v);
  const double ua = u.dot(between);
  const double va = v.dot(between);
  ClosestPair pair;
  // Parallel segments: any s on the overlap is right; 0 leads to one by the clamping.
  pair.along_first = clampedRatio(uv * va - vv * ua, uu * vv - uv * uv);
  pair.along_second = clampedRatio(uv * pair.along_first + va, vv);
  pair.along_first = clampedRatio(uv * pair.along_second - ua, uu);
  pair.squared_distance =
      (between + pair.along_first * u - pair.along_second * v).squaredNorm();
  return pair;
}

} // namespace

BoundaryEdges::BoundaryEdges(std::vector<TargetCurve> curves)
: curves_(std::move(curves))
{
  std::vector<ccaa::Box> boxes;
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    const BoundaryCurve& curve = curves_[c].curve;
    arcs_.emplace_back(1, 0.0);
    for (std::size_t k = 0; k < curve.size(); ++k) {
      arcs_.back().push_back(arcs_.back().back() + curve.edge(k).norm());
      edges_.push_back({c, k});
      ccaa::Box box(curve.points[k]);
      boxes.push_back(box.extend(curve.points[curve.next(k)]));
    }
  }
  tree_ = ccaa::BoxTree(boxes);
}

double
BoundaryEdges::arcAt(const BoundaryPoint& point) const
{
  const std::vector<double>& arcs = arcs_[point.curve];
  return arcs[point.edge] + point.share * (arcs[point.edge + 1] - arcs[point.edge]);
}

BoundaryPoint
BoundaryEdges::pointAt(std::size_t curve, double arc) const
{
  const std::vector<double>& arcs = arcs_[curve];
  const double within = arc - arcs.back() * std::floor(arc / arcs.back());
  const auto after = std::upper_bound(arcs.begin(), arcs.end(), within);
  const auto last_edge = static_cast<std::ptrdiff_t>(arcs.size()) - 2;
  const auto edge = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after - arcs.begin() - 1, 0, last_edge));
  BoundaryPoint point;
  point.curve = curve;
  point.edge = edge;
  point.share = clampedRatio(within - arcs[edge], arcs[edge + 1] - arcs[edge]);
  const BoundaryCurve& shape = curves_[curve].curve;
  point.position = shape.points[edge] + point.share * shape.edge(edge);
  return point;
}

std::optional<BoundaryEncounter>
BoundaryEdges::closest(const Position& a,
                       const Position& b,
                       double within,
                       const Filter& counts) const
{
  ccaa::Box query(a);
  query.extend(b);
  query.min().array() -= within;
  query.max().array() += within;
  std::optional<std::pair<double, std::size_t>> best;
  ClosestPair best_pair;
  tree_.forEachMeeting(query, [&](pcl::index_t index) {
    const auto id = static_cast<std::size_t>(index);
    const EdgeId& edge = edges_[id];
    if (!counts(edge.curve, edge.edge))
      return;
    const BoundaryCurve& curve = curves_[edge.curve].curve;
    const ClosestPair pair =
        closestPair(a, b - a, curve.points[edge.edge], curve.edge(edge.edge));
    const auto rank = std::make_pair(pair.squared_distance, id);
    if (pair.squared_distance > within * within || (best && *best < rank))
      return;
    best = rank;
    best_pair = pair;
  });
  if (!best)
    return std::nullopt;
  const EdgeId& edge = edges_[best->second];
  const BoundaryCurve& curve = curves_[edge.curve].curve;
  BoundaryEncounter encounter;
  encounter.point = {edge.curve,
                     edge.edge,
                     best_pair.along_second,
                     curve.points[edge.edge] +
                         best_pair.along_second * curve.edge(edge.edge)};
  encounter.distance = std::sqrt(best_pair.squared_distance);
  encounter.along = best_pair.along_first;
  return encounter;
}

} // namespace repair
} // namespace pcl
