// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: direction and normal of a force line at a point (4.44).

#include "force_line/line_state.h"

namespace pcl::repair {

namespace {

/** Rounds of n(p), p = unit(H n): the field of a smooth boundary is close to rank one,
 * for which the second round changes nothing. */
constexpr int MOST_ROUNDS = 8;
constexpr double SAME_DIRECTION = 1e-12;

/** A normal further than this from the one before is another branch: cos 60 degrees. */
constexpr double SAME_BRANCH = 0.5;

struct NormalChoice {
  Direction normal;
  bool undetermined = false;
};

/** The normal in the plane across `direction` that continues `before`. */
NormalChoice
continuedNormal(const Tension& tension,
                const Direction& direction,
                const Direction& before,
                double least_clearness)
{
  const FieldNormal found = searchNormal(tension, direction);
  const Direction carried = unitAcross(before, direction);
  const double agreement = found.normal.dot(before);
  if (!carried.isZero() &&
      (found.clearness < least_clearness || std::abs(agreement) < SAME_BRANCH))
    return {carried, true};
  return {agreement < 0.0 ? Direction(-found.normal) : found.normal, false};
}

} // namespace

Direction
unitAcross(const Eigen::Vector3d& vector, const Direction& unit)
{
  const Eigen::Vector3d across = vector - vector.dot(unit) * unit;
  const double length = across.norm();
  return length > 1e-9 * vector.norm() ? Direction(across / length) : Direction::Zero();
}

LineState
stateAt(const Tension& tension, const LineState& before, double least_clearness)
{
  if (before.direction.isZero())
    return {};
  LineState state = before;
  for (int round = 0; round < MOST_ROUNDS; ++round) {
    const NormalChoice choice =
        continuedNormal(tension, state.direction, before.normal, least_clearness);
    const Eigen::Vector3d force = tension * choice.normal;
    state.tension = force.norm();
    if (!(state.tension > 0.0))
      return {};
    const Direction direction = force / state.tension;
    const double change = 1.0 - direction.dot(state.direction);
    state.normal = choice.normal;
    state.undetermined = choice.undetermined;
    state.direction = direction;
    if (change < SAME_DIRECTION)
      break;
  }
  return state;
}

} // namespace pcl::repair
