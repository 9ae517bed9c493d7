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

/** Direction of a boundary around an edge: the chords over two edges to each side of
 * both its ends, because single edges of a scan's boundary point anywhere. */
Direction
tangentAround(const BoundaryCurve& curve, std::size_t edge)
{
  const std::size_t count = curve.size();
  if (count < 10)
    return curve.edge(edge).normalized();
  const auto point = [&](std::size_t ahead) -> const Position& {
    return curve.points[(edge + count - 2 + ahead) % count];
  };
  return (point(4) - point(0) + point(5) - point(1)).normalized();
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

Direction
normalAtTarget(const Direction& along, const BoundaryCurve& curve, std::size_t edge)
{
  const Direction& normal = curve.normals[edge];
  const Direction tangent = tangentAround(curve, edge);
  const Direction compatible = unitAcross((-along).cross(tangent), along);
  return compatible.dot(normal) > 0.0 ? compatible : unitAcross(normal, along);
}

} // namespace pcl::repair
