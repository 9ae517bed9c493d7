// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: loops that are the two ends of one gap.

#include "boundary/opposed_loops.h"

#include "boundary/smooth_conormals.h"
#include "mesh/box_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pcl::repair {

namespace {

/** Points of a loop, evenly spread over it, that look for others. */
constexpr std::size_t MOST_SAMPLES = 48;
/** Cosine of half the opening of a view. */
constexpr double IN_VIEW = 0.5;
/** Share of a loop's points that must see the other one. */
constexpr double LEAST_SHARE = 0.5;
/** Widest gap in lengths of the loop: a little more than the diameter of a round one.
 */
constexpr double WIDEST = 0.4;
/** How far ahead of a mouth the loop may be that it looks at, in its lengths, and
 * cosine of half the opening of that view. */
constexpr double AHEAD = 1.2;
constexpr double AHEAD_VIEW = 0.8;
/** By how much a squared distance to a box may be too large. */
constexpr double BOX_ROUNDING = 1.0 + 1e-12;
/** Operations to look from a point at another loop. */
constexpr std::uint64_t LOOKING_WORK = 10;

/** Some points of a loop and where they look. */
struct LookingLoop {
  Positions points;
  Directions conormals;
  double length = 0.0;
  ccaa::Box box;
};

LookingLoop
lookAlong(const BoundaryLoop& loop)
{
  LookingLoop looking;
  looking.length = loop.length;
  const BoundaryCurve& curve = loop.curve;
  const Directions conormals = smoothConormals(curve, 0.0);
  const std::size_t count = std::min(curve.size(), MOST_SAMPLES);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = i * curve.size() / count;
    looking.points.push_back(curve.points[k]);
    looking.conormals.push_back(conormals[k]);
    looking.box.extend(curve.points[k]);
  }
  return looking;
}

/** The loop that most points see. \param[in] seeing points, by the loop they see */
std::size_t
seenByMost(const std::map<std::size_t, std::size_t>& seeing, std::size_t points)
{
  for (const auto& [loop, count] : seeing)
    if (loop != NONE &&
        static_cast<double>(count) > LEAST_SHARE * static_cast<double>(points))
      return loop;
  return NONE;
}

/** Distance to the nearest point of a loop that is seen from a place and looks back;
 * infinite where there is none. */
double
nearestSeen(const Position& from, const Direction& conormal, const LookingLoop& loop)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const Eigen::Vector3d view = loop.points[i] - from;
    const double distance = view.norm();
    if (distance < nearest && conormal.dot(view) > IN_VIEW * distance &&
        loop.conormals[i].dot(view) < -IN_VIEW * distance)
      nearest = distance;
  }
  return nearest;
}

/** Normal of what would close a curve, as long as twice its area. */
Eigen::Vector3d
vectorArea(const BoundaryCurve& curve)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const Position& origin = curve.points.front();
  for (std::size_t k = 0; k < curve.size(); ++k)
    sum += (curve.points[k] - origin).cross(curve.points[curve.next(k)] - origin);
  return sum;
}

class Opposition {
public:
  explicit Opposition(const BoundaryLoops& loops)
  {
    std::vector<ccaa::Box> boxes;
    for (const BoundaryLoop& loop : loops) {
      loops_.push_back(lookAlong(loop));
      boxes.push_back(loops_.back().box);
    }
    tree_ = ccaa::BoxTree(boxes);
  }

  /** The loop that most points of one see first, or NONE. */
  std::size_t
  seenFrom(std::size_t loop, ccaa::RunControl* control) const
  {
    const LookingLoop& own = loops_[loop];
    std::map<std::size_t, std::size_t> seeing; // points, by the loop they see
    for (std::size_t i = 0; i < own.points.size(); ++i) {
      std::uint64_t looks = 1;
      ++seeing[firstSeen(own, i, looks)];
      if (!ccaa::spend(control, LOOKING_WORK * looks))
        return NONE;
    }
    const std::size_t most = seenByMost(seeing, own.points.size());
    return most == loop ? NONE : most;
  }

private:
  /** Of equally near loops the first. */
  std::size_t
  firstSeen(const LookingLoop& own, std::size_t point, std::uint64_t& looks) const
  {
    const Position& from = own.points[point];
    double nearest = WIDEST * own.length;
    std::size_t seen = NONE;
    const auto look = [&](pcl::index_t place) {
      ++looks;
      const auto loop = static_cast<std::size_t>(place);
      const double distance = nearestSeen(from, own.conormals[point], loops_[loop]);
      const bool is_tie = distance == nearest && seen != NONE;
      if (distance < nearest || (is_tie && loop < seen)) {
        nearest = distance;
        seen = loop;
      }
      return BOX_ROUNDING * nearest * nearest;
    };
    tree_.forEachNear(ccaa::Box(from), BOX_ROUNDING * nearest * nearest, look);
    return seen;
  }

  std::vector<LookingLoop> loops_;
  ccaa::BoxTree tree_;
};

} // namespace

std::size_t
loopAhead(const BoundaryLoops& loops, std::size_t mouth)
{
  const LookingLoop own = lookAlong(loops[mouth]);
  Direction axis = Direction::Zero();
  for (const Direction& conormal : own.conormals)
    axis += conormal;
  axis.normalize();
  const double farthest = AHEAD * own.length;
  const ccaa::Box within = ccaa::widened(own.box, farthest);
  std::vector<std::pair<Position, std::size_t>> others; // points, and their loops
  for (std::size_t other = 0; other < loops.size(); ++other)
    for (const Position& point : loops[other].curve.points)
      if (other != mouth && within.contains(point))
        others.emplace_back(point, other);
  std::map<std::size_t, std::size_t> seeing; // points, by the loop ahead
  for (const Position& point : own.points) {
    double nearest = farthest;
    std::size_t seen = NONE;
    for (const auto& [there, loop] : others) {
      const Eigen::Vector3d view = there - point;
      const double distance = view.norm();
      if (distance < nearest && axis.dot(view) > AHEAD_VIEW * distance) {
        nearest = distance;
        seen = loop;
      }
    }
    ++seeing[seen];
  }
  return seenByMost(seeing, own.points.size());
}

std::vector<std::size_t>
opposedLoops(const BoundaryLoops& loops, ccaa::RunControl* control)
{
  const Opposition opposition(loops);
  std::vector<std::size_t> seen;
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
    seen.push_back(opposition.seenFrom(loop, control));
  std::vector<std::size_t> opposed(loops.size(), NONE);
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
    if (seen[loop] != NONE && seen[seen[loop]] == loop)
      opposed[loop] = seen[loop];
  return opposed;
}

bool
lookTheSameWay(const BoundaryCurve& first, const BoundaryCurve& second, double cosine)
{
  const Eigen::Vector3d one = vectorArea(first), other = vectorArea(second);
  return one.dot(other) > cosine * one.norm() * other.norm();
}

} // namespace pcl::repair
