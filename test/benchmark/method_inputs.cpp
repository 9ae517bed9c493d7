// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds that tell methods of reconstruction apart.
#include "method_inputs.h"

#include "support/random_source.h"
#include "support/scanned_scene.h"

#include <cmath>
#include <functional>
#include <utility>

namespace bench {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::Positions;
namespace test = pcl::ccaa::test;

constexpr std::size_t POINTS = 10000;
constexpr double SPACING = 0.0354; // of so many points on a unit sphere

Position
randomDirection(test::RandomSource& random)
{
  return Position(random.normal(), random.normal(), random.normal()).normalized();
}

/** A closed surface with bumps, above each direction. */
Position
bump(const Position& direction)
{
  const double height =
      0.15 * std::sin(4 * direction.x()) * std::cos(3 * direction.y() + direction.z());
  return (1 + height) * direction;
}

test::Shape
bumpyShape()
{
  test::Shape shape = test::icosphere(5);
  for (Position& vertex : shape.vertices)
    vertex = bump(vertex.normalized());
  return shape;
}

/** Points of the bumpy surface where \a keeps says so of a direction and a random
 * number, with noise along the ray. */
Positions
bumpyPoints(std::uint64_t seed,
            double noise,
            const std::function<bool(const Position&, double)>& keeps)
{
  test::RandomSource random(seed);
  Positions points;
  while (points.size() < POINTS) {
    const Position direction = randomDirection(random);
    if (keeps(direction, random.uniform()))
      points.push_back(bump(direction) + noise * SPACING * random.normal() * direction);
  }
  return points;
}

bool
everywhere(const Position&, double)
{
  return true;
}

MethodInput
bumpy(std::string name, Positions points)
{
  return {std::move(name), cloudOf(points), bumpyShape(), {}, {}, {0.3, 0.2, 1.0}};
}

/** Half of the surface from each of six sides, each scan moved by half a spacing. */
Positions
scans()
{
  test::RandomSource random(5);
  Positions points;
  for (const double side : {1.0, -1.0})
    for (int axis = 0; axis < 3; ++axis) {
      const Position shift = 0.5 * SPACING * randomDirection(random);
      for (std::size_t left = POINTS / 3; left > 0; --left) {
        const Position direction = randomDirection(random);
        if (side * direction[axis] > 0.1)
          points.push_back(bump(direction) +
                           0.3 * SPACING * random.normal() * direction + shift);
      }
    }
  return points;
}

Positions
withOutliers(Positions points)
{
  test::RandomSource random(10);
  for (std::size_t left = POINTS / 20; left > 0; --left)
    points.emplace_back(random.uniform(-1.4, 1.4),
                        random.uniform(-1.4, 1.4),
                        random.uniform(-1.4, 1.4));
  return points;
}

/** Both sides of a plate without its narrow ones. */
MethodInput
sheets()
{
  constexpr int COLUMNS = 70;
  constexpr double THICKNESS = 3.0 / COLUMNS;
  test::RandomSource random(6);
  test::Shape truth;
  for (const double height : {0.0, THICKNESS}) {
    test::Shape sheet = test::scaled(test::grid(COLUMNS, COLUMNS), 1.0 / COLUMNS);
    truth = test::joined(truth, test::translated(sheet, {0.0, 0.0, height}));
  }
  Positions points = truth.vertices;
  for (Position& point : points)
    for (int axis = 0; axis < 2; ++axis)
      point[axis] += random.uniform(-0.3, 0.3) / COLUMNS;
  return {"two sheets", cloudOf(points), truth, {}, {}, {0.1, -1.0, 0.25}};
}

MethodInput
edges()
{
  test::RandomSource random(7);
  const test::Shape truth = test::cube(40);
  Positions points = truth.vertices;
  for (Position& point : points) // within the faces
    for (int axis = 0; axis < 3; ++axis)
      if (point[axis] > point.minCoeff() + 1e-9 &&
          point[axis] < point.maxCoeff() - 1e-9)
        point[axis] += random.uniform(-0.2, 0.2) / 40;
  return {"sharp edges", cloudOf(points), truth, {}, {}, {0.6, 0.5, 1.0}};
}

MethodInput
objects()
{
  const test::Scene scene = test::randomScene(3);
  test::ViewSettings settings;
  settings.pixels = 140;
  const test::Shape map = test::rangeMap(scene, settings);
  return {"several objects",
          cloudOf(map.vertices),
          test::asShape(scene),
          map,
          settings.sensor,
          {0.25, 0.1, 1.0}};
}

} // namespace

std::vector<MethodInput>
makeMethodInputs()
{
  const auto uneven = [](const Position& direction, double chance) {
    return chance < std::pow(10.0, -0.5 - 0.5 * direction.x());
  };
  const auto has_holes = [](const Position& direction, double) {
    for (const Position& hole :
         {Position(0, 0, 1), Position(1, 0.3, 0.4), Position(-0.8, 0.5, 0.6)})
      if (direction.dot(hole.normalized()) > 0.94)
        return false;
    return true;
  };
  std::vector<MethodInput> inputs;
  inputs.push_back(bumpy("clean", bumpyPoints(1, 0.0, everywhere)));
  inputs.push_back(bumpy("uneven", bumpyPoints(2, 0.0, uneven)));
  inputs.push_back(bumpy("noise 0.3", bumpyPoints(3, 0.3, everywhere)));
  inputs.push_back(bumpy("noise 1.5", bumpyPoints(4, 1.5, everywhere)));
  inputs.push_back(bumpy("six scans", scans()));
  inputs.push_back(sheets());
  inputs.push_back(edges());
  inputs.push_back(objects());
  inputs.push_back(bumpy("large holes", bumpyPoints(9, 0.0, has_holes)));
  inputs.push_back(bumpy("outliers", withOutliers(bumpyPoints(10, 0.0, everywhere))));
  return inputs;
}

} // namespace bench
