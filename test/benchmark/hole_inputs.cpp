// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: meshes with holes that tell methods of filling apart.
#include "hole_inputs.h"

#include "lost_parts.h"

#include <cmath>

namespace bench {
namespace {

using namespace pcl::ccaa::test;
using pcl::ccaa::Position;

/** A ball with bumps, which no smooth patch repeats by chance. */
Shape
bumpyBall(double radius)
{
  Shape ball = icosphere(5, radius);
  for (Position& p : ball.vertices)
    p *= 1.0 + 0.05 * std::sin(4.0 * p.x() / radius) * std::cos(3.0 * p.y() / radius) +
         0.04 * std::sin(5.0 * p.z() / radius);
  return ball;
}

/** Without the vertices where \a goes says so, and the triangles at them. */
template <typename Goes>
HoleInput
damaged(const std::string& name, const Shape& truth, const Position& view, Goes goes)
{
  std::vector<bool> is_lost;
  for (const Position& position : truth.vertices)
    is_lost.push_back(goes(position));
  return {name, truth, without(truth, is_lost).left, view};
}

/** The middles of twenty holes that are spread evenly. */
bool
isInSmallHole(const Position& p)
{
  for (int i = 0; i < 20; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / 20.0;
    const double turn = 2.399963229728653 * i;
    const double r = std::sqrt(1.0 - z * z);
    if (p.normalized().dot(Position(r * std::cos(turn), r * std::sin(turn), z)) > 0.992)
      return true;
  }
  return false;
}

} // namespace

std::vector<HoleInput>
makeHoleInputs()
{
  const Shape ball = bumpyBall(1.0);
  const Shape shells =
      joined(ball, {scaled(ball, 0.93).vertices, reversed(ball.triangles)});
  const Position front(0.3, 0.3, 1.0);
  const auto distance = [](const Position& p, double z) {
    return std::acos(p.normalized().dot(Position(0.2, 0.2, z).normalized()));
  };
  return {damaged("small holes", ball, front, isInSmallHole),
          damaged("large hole",
                  ball,
                  front,
                  [&](const auto& p) { return distance(p, 1.0) < 0.75; }),
          damaged("corner",
                  cube(40),
                  {1.0, 0.8, 1.4},
                  [](const auto& p) { return p.sum() > 2.4; }),
          damaged("island in a hole",
                  ball,
                  front,
                  [&](const auto& p) {
                    return distance(p, 1.0) < 0.75 && distance(p, 1.0) > 0.35;
                  }),
          damaged("three pieces",
                  ball,
                  front,
                  [](const auto& p) {
                    return std::abs(p.x() - 0.4 * p.y() + 0.15) < 0.1 ||
                           std::abs(p.y() - 0.35) < 0.06;
                  }),
          damaged("border",
                  terrain(100, 100),
                  {0.3, -1.0, 1.2},
                  [](const auto& p) {
                    return (p.template head<2>() - Eigen::Vector2d(30.0, 35.0)).norm() <
                               12.0 ||
                           (p.template head<2>() - Eigen::Vector2d(70.0, 60.0)).norm() <
                               9.0;
                  }),
          damaged("two shells", shells, front, [&](const auto& p) {
            return distance(p, 1.0) < 0.6;
          })};
}

} // namespace bench
