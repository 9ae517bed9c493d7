// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: seeded scenes of several objects as one sensor sees them.
#include "single_view.h"

#include <Eigen/Geometry>

#include "mesh/turn_between.h"
#include "random_source.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::ccaa::test {
namespace {

constexpr double NO_HIT = std::numeric_limits<double>::infinity();

struct Ball {
  Position center;
  double radius;
};

/** Distance along a unit direction. */
double
hit(const Ball& ball, const Position& from, const Position& direction)
{
  const Position way = ball.center - from;
  const double along = way.dot(direction);
  const double apart = way.squaredNorm() - along * along;
  return apart < ball.radius * ball.radius
             ? along - std::sqrt(ball.radius * ball.radius - apart)
             : NO_HIT;
}

double
hit(const Eigen::AlignedBox3d& box, const Position& from, const Position& direction)
{
  double enter = 0.0, leave = NO_HIT;
  for (int axis = 0; axis < 3; ++axis) {
    double in = (box.min()[axis] - from[axis]) / direction[axis];
    double out = (box.max()[axis] - from[axis]) / direction[axis];
    if (in > out)
      std::swap(in, out);
    enter = std::max(enter, in);
    leave = std::min(leave, out);
  }
  return enter < leave ? enter : NO_HIT;
}

/** The floor is a piece of 4 by 4 around the origin. */
double
floorHeight(double x, double y)
{
  return 0.12 * std::sin(2.1 * x) * std::cos(1.7 * y);
}

double
hitFloor(const Position& from, const Position& direction)
{
  double distance = -from.z() / direction.z();
  for (int round = 0; round < 30; ++round) {
    const Position at = from + distance * direction;
    distance += (floorHeight(at.x(), at.y()) - at.z()) / direction.z();
  }
  const Position at = from + distance * direction;
  return at.head<2>().cwiseAbs().maxCoeff() < 2.0 ? distance : NO_HIT;
}

struct Bodies {
  std::vector<Ball> balls;
  std::vector<Eigen::AlignedBox3d> boxes;

  /** \brief Where a ray meets one, or what is behind them. */
  double
  nearest(const Position& from, const Position& direction, double behind) const
  {
    double distance = behind;
    for (const Ball& ball : balls)
      distance = std::min(distance, hit(ball, from, direction));
    for (const Eigen::AlignedBox3d& box : boxes)
      distance = std::min(distance, hit(box, from, direction));
    return distance;
  }
};

/** The scene, standing upright. */
struct ViewedScene : Bodies {
  explicit ViewedScene(RandomSource& random)
  {
    for (int i = 0; i < 4; ++i) {
      const double radius = random.uniform(0.25, 0.45);
      const Position center(random.uniform(-1.6, 1.6),
                            random.uniform(-1.6, 1.6),
                            random.uniform(0.6, 1.6));
      balls.push_back({center, radius});
    }
    for (int i = 0; i < 3; ++i) {
      const Position low(random.uniform(-1.8, 1.0),
                         random.uniform(-1.8, 1.0),
                         random.uniform(0.2, 0.6));
      const Position size(
          random.uniform(0.3, 0.9), random.uniform(0.3, 0.9), random.uniform(0.3, 0.9));
      boxes.emplace_back(low, low + size);
    }
  }
};

/** Distance at which a ray from within leaves a box. */
double
leave(const Eigen::AlignedBox3d& box, const Position& from, const Position& direction)
{
  double distance = NO_HIT;
  for (int axis = 0; axis < 3; ++axis)
    for (const double wall : {box.min()[axis], box.max()[axis]})
      if ((wall - from[axis]) * direction[axis] > 0.0)
        distance = std::min(distance, (wall - from[axis]) / direction[axis]);
  return distance;
}

/** A room with furniture. */
struct Office : Bodies {
  Eigen::AlignedBox3d room{Position(0.0, 0.0, 0.0), Position(6.0, 5.0, 2.6)};

  explicit Office(RandomSource& random)
  {
    for (int i = 0; i < 10; ++i) { // desks with things on them
      const Position low(random.uniform(1.2, 5.0), random.uniform(0.0, 4.2), 0.7);
      boxes.emplace_back(low, low + Position(random.uniform(0.6, 1.4), 0.7, 0.04));
      for (int k = 0; k < 2; ++k) {
        const Position foot =
            low + Position(random.uniform(0.0, 0.5), random.uniform(0.0, 0.5), 0.06);
        const Position size(random.uniform(0.03, 0.4),
                            random.uniform(0.03, 0.3),
                            random.uniform(0.02, 0.4));
        boxes.emplace_back(foot, foot + size);
      }
      balls.push_back({low + Position(0.3, -0.4, random.uniform(-0.3, 0.4)),
                       random.uniform(0.05, 0.25)});
    }
  }
};

} // namespace

SingleView
officeFrame(std::uint64_t seed, std::size_t columns)
{
  RandomSource random(seed);
  const Office office(random);
  const Position camera(0.4, random.uniform(1.5, 3.5), 1.5);
  const Position ahead(1.0, random.uniform(-0.2, 0.2), -0.25);
  const auto looking = turnBetween(Position::UnitZ(), ahead);
  const std::size_t rows = columns * 3 / 4;
  const double step = 1.1 / static_cast<double>(columns);
  const auto ray = [&](std::size_t column, std::size_t row) -> Position {
    return {step * (static_cast<double>(column) - 0.5 * static_cast<double>(columns)),
            step * (static_cast<double>(row) - 0.5 * static_cast<double>(rows)),
            1.0};
  };
  std::vector<Position> spots; // column, row, radius
  for (int i = 0; i < 12; ++i)
    spots.emplace_back(random.uniform(0.0, static_cast<double>(columns)),
                       random.uniform(0.0, static_cast<double>(rows)),
                       random.uniform(0.01, 0.04) * static_cast<double>(columns));
  SingleView view;
  for (std::size_t row = 0; row < rows; ++row) {
    double before = 0.0;
    for (std::size_t column = 0; column < columns; ++column) {
      const Position way = ray(column, row);
      const double scale = way.norm();
      const Position direction = looking * (way / scale);
      const double depth =
          office.nearest(camera, direction, leave(office.room, camera, direction)) /
          scale;
      const bool jumps = std::abs(depth - before) > 0.05 * depth;
      before = depth;
      const bool is_in_spot =
          std::any_of(spots.begin(), spots.end(), [&](const auto& s) {
            return std::hypot(static_cast<double>(column) - s.x(),
                              static_cast<double>(row) - s.y()) < s.z();
          });
      const double noisy = depth + 0.001 * depth * depth * random.normal();
      if (noisy > 4.5 || is_in_spot || (jumps && random.uniform() < 0.5))
        continue;
      view.points.push_back(way / (0.00285 * std::round(1.0 / (0.00285 * noisy))));
    }
  }
  return view;
}

SingleView
aerialView(std::uint64_t seed, double side)
{
  RandomSource random(seed);
  std::vector<Ball> crowns;
  std::vector<Eigen::AlignedBox3d> houses;
  for (double area = side * side; area > 0.0; area -= 800.0) {
    const Position low(random.uniform(0.0, side), random.uniform(0.0, side), -50.0);
    const Position size(random.uniform(8.0, 20.0), random.uniform(8.0, 14.0), 0.0);
    const double roof = random.uniform(4.0, 15.0);
    houses.emplace_back(low, low + size + Position(0.0, 0.0, 50.0 + roof));
    for (int i = 0; i < 4; ++i)
      crowns.push_back({Position(random.uniform(0.0, side),
                                 random.uniform(0.0, side),
                                 random.uniform(4.0, 9.0)),
                        random.uniform(1.5, 4.0)});
  }
  SingleView view;
  view.sensor = Position(0.5 * side, 0.5 * side, 800.0);
  for (std::size_t left = static_cast<std::size_t>(2.0 * side * side); left > 0;
       --left) {
    const Position foot(random.uniform(0.0, side), random.uniform(0.0, side), -20.0);
    const Position down = (foot - view.sensor).normalized();
    double distance = (foot - view.sensor).norm();
    const Position ground = view.sensor + distance * down;
    distance +=
        (10.0 * floorHeight(0.02 * ground.x(), 0.02 * ground.y()) + 20.0) / down.z();
    for (const Eigen::AlignedBox3d& house : houses)
      distance = std::min(distance, hit(house, view.sensor, down));
    for (const Ball& crown : crowns) {
      const double enter = hit(crown, view.sensor, down);
      if (enter < distance && random.uniform() < 0.7)
        distance = std::min(distance, enter + random.uniform(0.0, 2.0 * crown.radius));
    }
    view.points.push_back(view.sensor + (distance + 0.03 * random.normal()) * down);
  }
  return view;
}

SingleView
singleView(std::uint64_t seed, std::size_t rays)
{
  RandomSource random(seed);
  const ViewedScene scene(random);
  SingleView view;
  view.sensor = Position(
      random.uniform(-2.5, 2.5), random.uniform(-2.5, 2.5), random.uniform(4.5, 7.0));
  const auto looking = turnBetween(Position::UnitZ(), -view.sensor);
  const double step = 0.9 / static_cast<double>(rays);
  const double noise = 0.1 * step * view.sensor.norm();
  for (std::size_t row = 0; row < rays; ++row)
    for (std::size_t column = 0; column < rays; ++column) {
      const Position direction =
          (looking * Position(static_cast<double>(column) * step - 0.45,
                              static_cast<double>(row) * step - 0.45,
                              1.0))
              .normalized();
      const double distance =
          scene.nearest(view.sensor, direction, hitFloor(view.sensor, direction));
      if (distance < NO_HIT)
        view.points.push_back(view.sensor + distance * direction +
                              noise * Position(random.uniform(-1.0, 1.0),
                                               random.uniform(-1.0, 1.0),
                                               random.uniform(-1.0, 1.0)));
    }
  const Position axis(
      random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(0.1, 1.0));
  const Eigen::AngleAxisd turn(random.uniform(0.0, 3.0), axis.normalized());
  const Position shift(3.0, -2.0, 1.0);
  for (Position& point : view.points)
    point = turn * point + shift;
  view.sensor = turn * view.sensor + shift;
  return view;
}

SingleView
inSensorFrame(SingleView view)
{
  for (Position& point : view.points)
    point -= view.sensor;
  view.sensor.setZero();
  return view;
}

double
facingShare(const std::vector<pcl::Vertices>& triangles,
            const Positions& points,
            const Position& place)
{
  std::size_t facing = 0;
  for (const pcl::Vertices& triangle : triangles) {
    const auto corner = [&](std::size_t k) -> const Position& {
      return points[static_cast<std::size_t>(triangle.vertices[k])];
    };
    const Position normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    const Position center = (corner(0) + corner(1) + corner(2)) / 3.0;
    facing += normal.dot(place - center) > 0.0 ? 1 : 0;
  }
  return triangles.empty()
             ? 0.0
             : static_cast<double>(facing) / static_cast<double>(triangles.size());
}

} // namespace pcl::ccaa::test
