// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: sharp edges of islands that go on in those of others.

#include "survey/crease_bridges.h"

#include <Eigen/Geometry>

#include "mesh/quantile.h"
#include "mesh/turn_between.h"
#include "survey/crease_ends.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace pcl::repair {

namespace {

/** Least cosine between a crease and the chord to where it goes on: as in the arc of a
 * circle of 120 degrees. */
constexpr double FORWARD = 0.5;
/** Least cosine between the normals of two creases, the one carried to the other: top
 * and bottom of a plate are a right angle apart. */
constexpr double ALIKE = 0.7;

/** Greatest width of a fold, of the gap: what is narrower does not come back by itself.
 */
constexpr double NARROW = 1.0;

struct Meeting {
  double cost = 0.0; /**< length of the chord, more where the frames disagree */
  std::pair<std::size_t, std::size_t> from, to; /**< curve and vertex */
  CreaseEnd begin, end;
};

class CreaseJoining {
public:
  CreaseJoining(const ModelSurvey& survey,
                const BoundaryEdges& boundaries,
                SurfaceEnds& surface_ends)
  : survey_(survey), boundaries_(boundaries), surface_ends_(surface_ends)
  {}

  std::vector<Bridge>
  run();

private:
  std::vector<CreaseEnd>
  endsAt(std::size_t curve, double gap);
  Position
  placeOf(std::size_t curve, const CreaseEnd& end) const
  {
    return boundaries_.curves()[curve].curve.points[end.vertex];
  }
  void
  addMeetings(const Junction& junction);
  std::optional<double>
  costOf(std::size_t one,
         const CreaseEnd& a,
         std::size_t other,
         const CreaseEnd& b) const;
  Bridge
  bridgeOf(const Meeting& meeting) const;
  bool
  isFree(const Bridge& bridge) const;

  const ModelSurvey& survey_;
  const BoundaryEdges& boundaries_;
  SurfaceEnds& surface_ends_;
  std::map<std::size_t, std::vector<CreaseEnd>> creases_; /**< of curves */
  std::vector<Meeting> meetings_;
};

/** Folds are narrow for the gap that they are to be carried over. */
std::vector<CreaseEnd>
CreaseJoining::endsAt(std::size_t curve, double gap)
{
  const BoundaryLoop& loop = survey_.loops[survey_.joined.loops[curve]];
  const auto [place, is_new] = creases_.try_emplace(curve);
  if (is_new)
    place->second = creaseEnds(survey_.model, loop);
  std::vector<CreaseEnd> ends = place->second;
  const std::vector<CreaseEnd> folds =
      foldEnds(surface_ends_, loop, NARROW * gap, ends);
  ends.insert(ends.end(), folds.begin(), folds.end());
  return ends;
}

/** Nothing where the one does not go on in the other. */
std::optional<double>
CreaseJoining::costOf(std::size_t one,
                      const CreaseEnd& a,
                      std::size_t other,
                      const CreaseEnd& b) const
{
  const Eigen::Vector3d chord = placeOf(other, b) - placeOf(one, a);
  const double length = chord.norm();
  if (a.is_convex != b.is_convex || !(a.along.dot(chord) > FORWARD * length) ||
      !(-b.along.dot(chord) > FORWARD * length))
    return std::nullopt;
  const auto carried = ccaa::turnBetween(a.along, -b.along) * a.normal;
  const double agreement = carried.dot(b.normal);
  if (agreement < ALIKE)
    return std::nullopt;
  return length * (2.0 - agreement);
}

void
CreaseJoining::addMeetings(const Junction& junction)
{
  std::vector<double> lengths;
  for (const std::size_t line : junction.believed)
    lengths.push_back(survey_.between_islands.lines[line].length);
  const double gap = ccaa::medianOf(std::move(lengths));
  const auto [one, other] = junction.curves;
  const std::vector<CreaseEnd> second = endsAt(other, gap);
  for (const CreaseEnd& a : endsAt(one, gap))
    for (const CreaseEnd& b : second)
      if (const auto cost = costOf(one, a, other, b))
        meetings_.push_back({*cost, {one, a.vertex}, {other, b.vertex}, a, b});
}

/** A cubic curve (Hermite) whose speed at both ends is that of a circle's arc. */
Bridge
CreaseJoining::bridgeOf(const Meeting& meeting) const
{
  const CreaseEnd& a = meeting.begin;
  const CreaseEnd& b = meeting.end;
  const Position from = placeOf(meeting.from.first, a);
  const Position to = placeOf(meeting.to.first, b);
  const double length = (to - from).norm();
  const double cosine = 0.5 * (a.along - b.along).dot(to - from) / length;
  const double speed = 2.0 * length / (1.0 + cosine);
  Bridge bridge;
  bridge.is_crease = true;
  bridge.begin = {meeting.from.first, a.vertex, 0.0, from};
  bridge.end = {meeting.to.first, b.vertex, 0.0, to};
  const double steps = std::max(
      1.0, std::round(length / std::max(0.5 * (a.edge + b.edge), 0.01 * length)));
  for (double k = 0.0; k <= steps; ++k) {
    const double s = k / steps, r = 1.0 - s;
    bridge.points.push_back(r * r * (1.0 + 2.0 * s) * from +
                            s * s * (1.0 + 2.0 * r) * to +
                            speed * r * s * (r * a.along + s * b.along));
    const Direction way = 6.0 * r * s / speed * (to - from) +
                          r * (r - 2.0 * s) * a.along - s * (s - 2.0 * r) * b.along;
    const Direction normal = r * a.normal + s * b.normal;
    const Direction across = normal - normal.dot(way) / way.squaredNorm() * way;
    bridge.normals.push_back(across.normalized());
  }
  bridge.points.front() = from;
  bridge.points.back() = to;
  return bridge;
}

bool
CreaseJoining::isFree(const Bridge& bridge) const
{
  if (!survey_.guides || !survey_.guides->surface)
    return true;
  for (std::size_t k = 1; k < bridge.points.size(); ++k)
    if (survey_.guides->surface->crosses(
            bridge.points[k - 1],
            bridge.points[k],
            0.5 * (bridge.points[k] - bridge.points[k - 1]).norm()))
      return false;
  return true;
}

std::vector<Bridge>
CreaseJoining::run()
{
  for (const Junction& junction : survey_.joined.junctions)
    if (!junction.believed.empty() && junction.curves[0] != junction.curves[1])
      addMeetings(junction);
  std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& a, const Meeting& b) {
    return std::tie(a.cost, a.from, a.to) < std::tie(b.cost, b.from, b.to);
  });
  std::vector<Bridge> bridges;
  std::set<std::pair<std::size_t, std::size_t>> taken;
  for (const Meeting& meeting : meetings_) {
    if (taken.count(meeting.from) > 0 || taken.count(meeting.to) > 0)
      continue;
    Bridge bridge = bridgeOf(meeting);
    if (!isFree(bridge))
      continue;
    taken.insert({meeting.from, meeting.to});
    bridges.push_back(std::move(bridge));
  }
  return bridges;
}

} // namespace

std::vector<Bridge>
creaseBridges(const ModelSurvey& survey,
              const BoundaryEdges& boundaries,
              SurfaceEnds& surface_ends)
{
  return CreaseJoining(survey, boundaries, surface_ends).run();
}

} // namespace pcl::repair
