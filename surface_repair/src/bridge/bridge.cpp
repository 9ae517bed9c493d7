// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a bridge between two supporting points (4.32).

#include <pcl/surface_repair/bridge/bridge.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace pcl {
namespace repair {

namespace {

/** A boundary has room for so many supporting points, however small it is: an island
 * that one bridge reaches cannot keep it (C4.47-3). */
constexpr double LEAST_SUPPORTS = 6.0;

/** The supporting points that are taken, by curve and arc. */
class TakenPoints {
public:
  explicit TakenPoints(const BoundaryEdges& boundaries) : boundaries_(boundaries) {}

  bool
  hasRoomFor(const BoundaryPoint& point, double apart) const
  {
    const auto taken = arcs_.find(point.curve);
    if (taken == arcs_.end())
      return true;
    const double arc = boundaries_.arcAt(point);
    const double wanted =
        std::min(apart, boundaries_.lengthOf(point.curve) / LEAST_SUPPORTS);
    return std::all_of(taken->second.begin(), taken->second.end(), [&](double other) {
      return boundaries_.arcBetween(point.curve, arc, other) >= wanted;
    });
  }

  void
  add(const BoundaryPoint& point)
  {
    arcs_[point.curve].insert(boundaries_.arcAt(point));
  }

private:
  const BoundaryEdges& boundaries_;
  std::map<std::size_t, std::set<double>> arcs_;
};

/** Quality made comparable between lines over gaps of different widths, whose L_2
 * differ: see strongestOrigins(). */
double
rankOf(const ForceLine& line)
{
  return line.length > 0.0 ? line.quality / (line.length * line.length) : 0.0;
}

/** Of a line within one boundary the two ends must keep their distance as well. */
bool
endsAreApart(const Bridge& bridge, const BoundaryEdges& boundaries, double apart)
{
  return bridge.begin.curve != bridge.end.curve ||
         boundaries.arcBetween(bridge.begin.curve,
                               boundaries.arcAt(bridge.begin),
                               boundaries.arcAt(bridge.end)) >= apart;
}

BoundaryPoint
nearestVertex(const BoundaryPoint& point, const BoundaryEdges& boundaries)
{
  const BoundaryCurve& curve = boundaries.curves()[point.curve].curve;
  const std::size_t vertex = point.share < 0.5 ? point.edge : curve.next(point.edge);
  return {point.curve, vertex, 0.0, curve.points[vertex]};
}

/** Shares of the way at the points, 0 to 1. */
std::vector<double>
sharesAlong(const Positions& points)
{
  std::vector<double> shares{0.0};
  for (std::size_t i = 1; i < points.size(); ++i)
    shares.push_back(shares.back() + (points[i] - points[i - 1]).norm());
  const double length = shares.back();
  for (double& share : shares)
    share = length > 0.0 ? share / length : 0.0;
  return shares;
}

} // namespace

Bridge
supportedByVertices(Bridge bridge, const BoundaryEdges& boundaries)
{
  bridge.begin = nearestVertex(bridge.begin, boundaries);
  bridge.end = nearestVertex(bridge.end, boundaries);
  const Eigen::Vector3d at_begin = bridge.begin.position - bridge.points.front();
  const Eigen::Vector3d at_end = bridge.end.position - bridge.points.back();
  const std::vector<double> shares = sharesAlong(bridge.points);
  for (std::size_t i = 1; i + 1 < bridge.points.size(); ++i)
    bridge.points[i] += (1.0 - shares[i]) * at_begin + shares[i] * at_end;
  bridge.points.front() = bridge.begin.position;
  bridge.points.back() = bridge.end.position;
  return bridge;
}

Bridge
bridgeAlong(const ForceLine& line)
{
  return {line.origin, line.target, line.points, line.normals, line.quality};
}

std::vector<Bridge>
selectBridges(const std::vector<ForceLine>& lines,
              const BoundaryEdges& boundaries,
              const SupportSpacing& spacing)
{
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rankOf(lines[a]) > rankOf(lines[b]);
  });
  TakenPoints taken(boundaries);
  std::vector<Bridge> chosen;
  for (const std::size_t i : order) {
    if (lines[i].end != LineEnd::BRIDGE)
      continue;
    Bridge bridge = supportedByVertices(bridgeAlong(lines[i]), boundaries);
    const double apart = std::max(spacing.least, spacing.share * lines[i].length);
    if (!taken.hasRoomFor(bridge.begin, apart) ||
        !taken.hasRoomFor(bridge.end, apart) ||
        !endsAreApart(bridge, boundaries, apart))
      continue;
    taken.add(bridge.begin);
    taken.add(bridge.end);
    chosen.push_back(std::move(bridge));
  }
  return chosen;
}

} // namespace repair
} // namespace pcl
