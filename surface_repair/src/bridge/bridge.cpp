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

} // namespace

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
    Bridge bridge = bridgeAlong(lines[i]);
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
