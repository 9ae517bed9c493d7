// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: generated scenes of several objects, and what a sensor sees
// of them.
#include "scanned_scene.h"

#include "mesh/corners.h"
#include "random_source.h"
#include "repair_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::ccaa::test {
namespace {

constexpr int WAVES = 3;
constexpr double SCENE_RADIUS = 1.6;
/** Half the extent of what the sensor sees, at the origin. */
constexpr double VIEW_RADIUS = 2.6;

Position
randomUnit(RandomSource& random)
{
  return Position(random.normal(), random.normal(), random.normal()).normalized();
}

Eigen::Matrix3d
randomTurn(RandomSource& random)
{
  return Eigen::AngleAxisd(random.uniform(0.0, 2.0 * M_PI), randomUnit(random))
      .toRotationMatrix();
}

/** Waves over a body of about unit size, then other proportions. */
Shape
warped(Shape shape, RandomSource& random)
{
  std::array<Position, WAVES> along;
  std::array<Position, WAVES> push;
  std::array<double, WAVES> phase{};
  for (std::size_t w = 0; w < WAVES; ++w) {
    along[w] = random.uniform(1.0, 5.0) * randomUnit(random);
    push[w] = random.uniform(0.0, 0.5) / along[w].norm() * randomUnit(random);
    phase[w] = random.uniform(0.0, 2.0 * M_PI);
  }
  const Position stretch(1.0, random.uniform(0.35, 1.0), random.uniform(0.35, 1.0));
  for (Position& vertex : shape.vertices) {
    Position moved = vertex;
    for (std::size_t w = 0; w < WAVES; ++w)
      moved += std::sin(along[w].dot(vertex) + phase[w]) * push[w];
    vertex = moved.cwiseProduct(stretch);
  }
  return shape;
}

Shape
randomBody(RandomSource& random)
{
  const int fineness = 1 << random.below(2);
  switch (random.below(4)) {
  case 0:
    return translated(cube(16 * fineness, 1.4), Position(-0.7, -0.7, -0.7));
  case 1:
    return warped(torus(48 * fineness, 18 * fineness, 0.75, random.uniform(0.2, 0.35)),
                  random);
  default:
    return warped(icosphere(fineness > 1 ? 5 : 4), random);
  }
}

double
radiusOf(const Shape& shape)
{
  double radius = 0.0;
  for (const Position& vertex : shape.vertices)
    radius = std::max(radius, vertex.norm());
  return radius;
}

/** The nearest hit of every ray from the sensor. */
class DepthImage {
public:
  DepthImage(const ViewSettings& settings) : settings_(settings)
  {
    forward_ = -settings.sensor.normalized();
    right_ = forward_.unitOrthogonal();
    down_ = forward_.cross(right_);
    depths_.assign(settings.pixels * settings.pixels,
                   std::numeric_limits<double>::infinity());
  }

  void
  draw(const Shape& shape)
  {
    for (const Triangle& triangle : shape.triangles)
      draw(cornersOf(triangle, shape.vertices));
  }

  double&
  depth(std::size_t row, std::size_t column)
  {
    return depths_[row * settings_.pixels + column];
  }

  /** From the sensor through the middle of a pixel; its part along the view is 1. */
  Position
  ray(std::size_t row, std::size_t column) const
  {
    const auto offset = [&](std::size_t pixel) {
      return (static_cast<double>(pixel) + 0.5) * step() - halfView();
    };
    return forward_ + offset(column) * right_ + offset(row) * down_;
  }

  /** Distance between neighbouring rays at depth 1. */
  double
  step() const
  {
    return 2.0 * halfView() / static_cast<double>(settings_.pixels);
  }

private:
  double
  halfView() const
  {
    return VIEW_RADIUS / settings_.sensor.norm();
  }

  /** Column, row and inverse depth, which is linear over the image. */
  Position
  project(const Position& point) const
  {
    const Position seen = point - settings_.sensor;
    const double depth = seen.dot(forward_);
    const auto pixel = [&](const Position& axis) {
      return (seen.dot(axis) / depth + halfView()) / step() - 0.5;
    };
    return {pixel(right_), pixel(down_), 1.0 / depth};
  }

  void
  draw(const Corners& corners)
  {
    const Position a = project(corners[0]);
    const Position b = project(corners[1]) - a;
    const Position c = project(corners[2]) - a;
    const double area = b.x() * c.y() - b.y() * c.x();
    if (area == 0.0)
      return;
    const auto last = static_cast<double>(settings_.pixels - 1);
    const auto lowest = [&](int axis) {
      return std::max(0.0, std::ceil(a[axis] + std::min({0.0, b[axis], c[axis]})));
    };
    const auto highest = [&](int axis) {
      return std::min(last, std::floor(a[axis] + std::max({0.0, b[axis], c[axis]})));
    };
    for (double row = lowest(1); row <= highest(1); ++row)
      for (double column = lowest(0); column <= highest(0); ++column) {
        const double x = column - a.x();
        const double y = row - a.y();
        const double u = (x * c.y() - y * c.x()) / area;
        const double v = (b.x() * y - b.y() * x) / area;
        if (u < 0.0 || v < 0.0 || u + v > 1.0)
          continue;
        double& nearest =
            depth(static_cast<std::size_t>(row), static_cast<std::size_t>(column));
        nearest = std::min(nearest, 1.0 / (a.z() + u * b.z() + v * c.z()));
      }
  }

  ViewSettings settings_;
  Position forward_;
  Position right_;
  Position down_;
  std::vector<double> depths_;
};

void
loseSpots(const ViewSettings& settings, RandomSource& random, DepthImage& image)
{
  for (std::size_t s = 0; s < settings.spots; ++s) {
    const auto row = static_cast<double>(random.below(settings.pixels));
    const auto column = static_cast<double>(random.below(settings.pixels));
    const double radius =
        random.uniform(1.0, 0.06 * static_cast<double>(settings.pixels));
    for (std::size_t r = 0; r < settings.pixels; ++r)
      for (std::size_t c = 0; c < settings.pixels; ++c)
        if (std::hypot(static_cast<double>(r) - row, static_cast<double>(c) - column) <
            radius)
          image.depth(r, c) = std::numeric_limits<double>::infinity();
  }
}

void
addWhereShort(const Triangle& triangle, double longest, Shape& map)
{
  const Corners corners = cornersOf(triangle, map.vertices);
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = (corners[(k + 1) % 3] - corners[k]).norm();
    if (!(length <= longest)) // also where a corner has no depth
      return;
  }
  map.triangles.push_back(triangle);
}

} // namespace

Scene
randomScene(std::uint64_t seed)
{
  RandomSource random(seed);
  Scene scene;
  std::vector<std::pair<Position, double>> balls;
  const std::size_t wanted = 2 + random.below(4);
  for (int attempt = 0; attempt < 100 && scene.objects.size() < wanted; ++attempt) {
    const double scale = random.uniform(0.35, 1.0);
    const Position place(random.uniform(-1.0, 1.0) * SCENE_RADIUS,
                         random.uniform(-1.0, 1.0) * SCENE_RADIUS,
                         random.uniform(-1.0, 1.0) * SCENE_RADIUS);
    Shape body = scaled(randomBody(random), scale);
    const double radius = radiusOf(body);
    if (std::any_of(balls.begin(), balls.end(), [&](const auto& ball) {
          return (ball.first - place).norm() < ball.second + radius;
        }))
      continue;
    const Eigen::Matrix3d turn = randomTurn(random);
    for (Position& vertex : body.vertices)
      vertex = turn * vertex;
    balls.emplace_back(place, radius);
    scene.objects.push_back(translated(std::move(body), place));
  }
  return scene;
}

Shape
rangeMap(const Scene& scene, const ViewSettings& settings)
{
  RandomSource random(settings.seed);
  DepthImage image(settings);
  for (const Shape& object : scene.objects)
    image.draw(object);
  loseSpots(settings, random, image);
  Shape map;
  for (std::size_t row = 0; row < settings.pixels; ++row)
    for (std::size_t column = 0; column < settings.pixels; ++column) {
      const double depth = image.depth(row, column);
      const double off = settings.noise * depth * image.step() * random.normal();
      map.vertices.push_back(settings.sensor + (depth + off) * image.ray(row, column));
    }
  const double longest = settings.longest_edge * settings.sensor.norm() * image.step();
  const auto width = static_cast<index_t>(settings.pixels);
  for (index_t row = 0; row + 1 < width; ++row)
    for (index_t column = 0; column + 1 < width; ++column) {
      const index_t corner = row * width + column;
      addWhereShort({corner, corner + 1, corner + width + 1}, longest, map);
      addWhereShort({corner, corner + width + 1, corner + width}, longest, map);
    }
  const Triangle& first = map.triangles.empty() ? Triangle{0, 1, 2} : map.triangles[0];
  const Corners corners = cornersOf(first, map.vertices);
  if (areaNormal(corners).dot(settings.sensor - corners[0]) < 0.0)
    map.triangles = reversed(std::move(map.triangles));
  return withoutFreeVertices(map);
}

Shape
asShape(const Scene& scene)
{
  Shape all;
  for (const Shape& object : scene.objects)
    all = joined(all, object);
  return all;
}

} // namespace pcl::ccaa::test
