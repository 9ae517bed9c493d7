// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a bridge between two supporting points (4.32).

#include "bridge/bridge.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

namespace pcl::repair {

namespace {

/** A boundary has room for so many supporting points, however small it is: an island
 * that one bridge reaches cannot keep it (C4.47-3). */
constexpr double LEAST_SUPPORTS = 6.0;

/** A boundary with fewer bridges gets others that are closer to their neighbours. */
constexpr std::size_t FEWEST_BRIDGES = 3;

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
  return {line.origin, line.target, line.points, line.normals, line.quality, false};
}

namespace {

/** Takes lines as bridges, one after the other, where there is room for them. */
class Selection {
public:
  Selection(const std::vector<ForceLine>& lines,
            const BoundaryEdges& boundaries,
            const std::vector<Bridge>& given)
  : lines_(lines)
  , boundaries_(boundaries)
  , given_(given)
  , taken_(boundaries)
  , is_chosen_(lines.size(), false)
  , bridges_of_(boundaries.curves().size(), 0)
  {
    for (const Bridge& bridge : given)
      take(bridge);
  }

  void
  consider(std::size_t line, double apart)
  {
    if (lines_[line].end != LineEnd::BRIDGE || is_chosen_[line])
      return;
    Bridge bridge = supportedByVertices(bridgeAlong(lines_[line]), boundaries_);
    if (!taken_.hasRoomFor(bridge.begin, apart) ||
        !taken_.hasRoomFor(bridge.end, apart) ||
        !endsAreApart(bridge, boundaries_, apart) || crossesGiven(bridge))
      return;
    take(bridge);
    is_chosen_[line] = true;
    chosen_.push_back(std::move(bridge));
  }

  /** Whether it leads from between two given bridges to elsewhere than between them. On
   * the two boundaries of a gap bridges follow each other in opposite order. */
  bool
  crossesGiven(const Bridge& bridge) const
  {
    const double length = boundaries_.lengthOf(bridge.begin.curve);
    const double other_length = boundaries_.lengthOf(bridge.end.curve);
    double before = length, after = length; // along the first boundary, to given ones
    double other_before = 0.0, other_after = 0.0; // of these, along the other boundary
    const auto ahead = [&](const BoundaryPoint& from, const BoundaryPoint& to) {
      const double way = boundaries_.arcAt(to) - boundaries_.arcAt(from);
      return way < 0.0 ? way + boundaries_.lengthOf(from.curve) : way;
    };
    for (const Bridge& given : given_) {
      const bool is_same = given.begin.curve == bridge.begin.curve &&
                           given.end.curve == bridge.end.curve;
      const bool is_turned = given.begin.curve == bridge.end.curve &&
                             given.end.curve == bridge.begin.curve;
      if (!is_same && !is_turned)
        continue;
      const BoundaryPoint& here = is_same ? given.begin : given.end;
      const BoundaryPoint& there = is_same ? given.end : given.begin;
      if (const double way = ahead(bridge.begin, here); way < after) {
        after = way;
        other_after = ahead(there, bridge.end);
      }
      if (const double way = ahead(here, bridge.begin); way < before) {
        before = way;
        other_before = ahead(bridge.end, there);
      }
    }
    return other_after + other_before > (1.0 + 1e-9) * other_length;
  }

  void
  take(const Bridge& bridge)
  {
    for (const BoundaryPoint& end : {bridge.begin, bridge.end}) {
      taken_.add(end);
      ++bridges_of_[end.curve];
    }
  }

  /** Whether a line ends at a boundary with too few bridges to keep them. */
  bool
  servesPoorBoundary(std::size_t line) const
  {
    return lines_[line].end == LineEnd::BRIDGE &&
           (bridges_of_[lines_[line].origin.curve] < FEWEST_BRIDGES ||
            bridges_of_[lines_[line].target.curve] < FEWEST_BRIDGES);
  }

  std::vector<Bridge>
  finish()
  {
    return std::move(chosen_);
  }

private:
  const std::vector<ForceLine>& lines_;
  const BoundaryEdges& boundaries_;
  const std::vector<Bridge>& given_;
  TakenPoints taken_;
  std::vector<bool> is_chosen_;
  std::vector<std::size_t> bridges_of_; /**< of each boundary */
  std::vector<Bridge> chosen_;
};

} // namespace

std::vector<Bridge>
selectBridges(const std::vector<ForceLine>& lines,
              const BoundaryEdges& boundaries,
              const SupportSpacing& spacing,
              const std::vector<Bridge>& given)
{
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return rankOf(lines[a]) > rankOf(lines[b]);
  });
  Selection selection(lines, boundaries, given);
  for (const std::size_t i : order)
    selection.consider(i, std::max(spacing.least, spacing.share * lines[i].length));
  for (const std::size_t i : order)
    if (selection.servesPoorBoundary(i))
      selection.consider(i, spacing.least);
  return selection.finish();
}

} // namespace pcl::repair
