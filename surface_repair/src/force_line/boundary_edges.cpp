// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the boundary edges at which a force line can end.

#include "force_line/boundary_edges.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pcl::repair {

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
  std::vector<ccaa::Box> around;
  for (const TargetCurve& target : curves_) {
    const BoundaryCurve& curve = target.curve;
    std::vector<ccaa::Box> boxes;
    around.emplace_back();
    arcs_.emplace_back(1, 0.0);
    for (std::size_t k = 0; k < curve.size(); ++k) {
      arcs_.back().push_back(arcs_.back().back() + curve.edge(k).norm());
      ccaa::Box box(curve.points[k]);
      boxes.push_back(box.extend(curve.points[curve.next(k)]));
      around.back().extend(boxes.back());
    }
    trees_.emplace_back(boxes);
  }
  tree_ = ccaa::BoxTree(around);
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
                       const CurveFilter& curve_counts,
                       const EdgeFilter& edge_counts,
                       const BoundaryPoint& guess) const
{
  ccaa::Box query(a);
  query.extend(b);
  ClosestPair best;
  BoundaryPoint place;
  double reach = within * within;
  const auto take = [&](std::size_t curve, std::size_t edge) {
    if (edge_counts && !edge_counts(curve, edge))
      return;
    const BoundaryCurve& shape = curves_[curve].curve;
    const ClosestPair pair =
        closestPair(a, b - a, shape.points[edge], shape.edge(edge));
    if (pair.squared_distance > within * within ||
        (place.curve != NONE &&
         std::tie(best.squared_distance, place.curve, place.edge) <
             std::tie(pair.squared_distance, curve, edge)))
      return;
    best = pair;
    place.curve = curve;
    place.edge = edge;
    reach = pair.squared_distance;
  };
  if (guess.curve != NONE)
    take(guess.curve, guess.edge);
  tree_.forEachNear(query, reach, [&](pcl::index_t c) {
    const auto curve = static_cast<std::size_t>(c);
    if (!curve_counts || curve_counts(curve))
      trees_[curve].forEachNear(query, reach, [&](pcl::index_t edge) {
        take(curve, static_cast<std::size_t>(edge));
        return reach;
      });
    return reach;
  });
  if (place.curve == NONE)
    return std::nullopt;
  const BoundaryCurve& shape = curves_[place.curve].curve;
  place.share = best.along_second;
  place.position = shape.points[place.edge] + place.share * shape.edge(place.edge);
  return BoundaryEncounter{place, std::sqrt(best.squared_distance), best.along_first};
}

std::optional<BoundaryEncounter>
BoundaryEdges::closestFurtherAlong(const Position& a,
                                   const Position& b,
                                   double within,
                                   std::size_t curve,
                                   double arc,
                                   double length,
                                   const BoundaryPoint& guess) const
{
  const auto is_it = [&](std::size_t other) { return other == curve; };
  const auto is_further = [&](std::size_t, std::size_t edge) {
    return arcBetween(curve, arc, arcOfEdge(curve, edge)) > length;
  };
  return closest(a, b, within, is_it, is_further, guess);
}

} // namespace pcl::repair
