// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: random damage to random shapes (declared in
// repair_shapes.h).
#include <Eigen/Geometry>

#include "completion_shapes.h"
#include "random_source.h"
#include "repair_shapes.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl::ccaa::test {
namespace {

Shape
randomShape(RandomSource& random)
{
  switch (random.below(10)) {
  case 0:
    return torus(48, 20);
  case 1:
    return translated(cube(10, 2.0), Position(-1, -1, -1));
  case 2:
    return frame(4);
  case 3:
    return translated(scaled(terrain(30, 30, 1.5), 0.07), Position(-1, -1, 0));
  case 4:
    return nestedSpheres(3);
  case 5:
    return translated(cylinder(40, 30, 1.0, 4.0), Position(0, 0, -2));
  case 6:
    return saddle(25);
  case 7:
    return noisyIcosphere(3, 0.03, random.below(1000));
  case 8:
    return translated(scaled(box(16, 10, 1), 0.15), Position(-1.2, -0.75, 0));
  default:
    return icosphere(3);
  }
}

Position
randomDirection(RandomSource& random)
{
  Position direction(random.normal(), random.normal(), random.normal());
  return direction.normalized();
}

/** Balls around places of the surface, and slabs through it. */
PieceOf
randomCuts(const Shape& shape, RandomSource& random)
{
  std::vector<std::pair<Position, double>> balls;
  for (std::size_t i = random.below(6); i > 0; --i)
    balls.emplace_back(shape.vertices[random.below(shape.vertices.size())],
                       random.uniform(0.05, 0.5));
  std::vector<std::pair<Position, double>> slabs;
  std::vector<double> widths;
  for (std::size_t i = random.below(4); i > 0; --i) {
    slabs.emplace_back(randomDirection(random), random.uniform(-0.7, 0.7));
    widths.push_back(random.uniform(0.01, 0.15));
  }
  return [=](const Position& p) {
    for (const auto& [middle, radius] : balls)
      if ((p - middle).norm() < radius)
        return -1;
    int piece = 0;
    for (std::size_t i = 0; i < slabs.size(); ++i) {
      const double height = slabs[i].first.dot(p) - slabs[i].second;
      if (std::abs(height) < widths[i])
        return -1;
      piece = 2 * piece + (height > 0.0 ? 1 : 0);
    }
    return piece;
  };
}

void
turnSomeIslands(RandomSource& random, Triangles& triangles)
{
  const std::vector<std::size_t> component = componentOfTriangles(triangles);
  const double share = random.uniform() < 0.5 ? 0.0 : 0.3;
  std::vector<char> turned;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    while (turned.size() <= component[t])
      turned.push_back(random.uniform() < share ? 1 : 0);
    if (turned[component[t]] != 0)
      std::swap(triangles[t][1], triangles[t][2]);
  }
}

/** Lost points: none, some or all, on the surface or beside it. */
Shape
withSomeFreePoints(const Shape& shape, RandomSource& random)
{
  Shape rest = withoutFreeVertices(shape);
  std::vector<char> used(shape.vertices.size(), 0);
  for (const Triangle& triangle : shape.triangles)
    for (const index_t corner : triangle)
      used[static_cast<std::size_t>(corner)] = 1;
  const double share = std::max(0.0, random.uniform(-1.0, 1.0));
  const double noise = std::max(0.0, random.uniform(-0.05, 0.05));
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i] == 0 && random.uniform() < share)
      rest.vertices.push_back(shape.vertices[i] +
                              noise * random.normal() * randomDirection(random));
  return rest;
}

} // namespace

DamagedModel
randomlyDamaged(std::uint64_t seed)
{
  RandomSource random(seed);
  DamagedModel model;
  model.truth = randomShape(random);
  Shape damaged = inPieces(model.truth, randomCuts(model.truth, random), true);
  if (random.uniform() < 0.5) {
    const double share = random.uniform(0.0, 0.1);
    damaged = withoutRandomTriangles(damaged, share, seed);
    damaged.triangles = manifoldPart(std::move(damaged.triangles), 1);
  }
  damaged = withSomeFreePoints(damaged, random);
  turnSomeIslands(random, damaged.triangles);
  if (random.uniform() < 0.5)
    damaged = shuffled(damaged, seed);
  model.damaged = std::move(damaged);
  model.wound = model.damaged.triangles;
  model.whole = topologyOf(model.wound);
  return model;
}

} // namespace pcl::ccaa::test
