// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: changes to the named test meshes (declared in shapes.h).
#include <Eigen/Geometry>

#include "random_source.h"
#include "shapes.h"

#include <numeric>
#include <utility>

namespace pcl::ccaa::test {

Shape
joined(const Shape& first, const Shape& second)
{
  Shape both = first;
  const auto shift = static_cast<index_t>(first.vertices.size());
  both.vertices.insert(
      both.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (const Triangle& t : second.triangles)
    both.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return both;
}

Shape
translated(Shape shape, const Position& shift)
{
  for (Position& vertex : shape.vertices)
    vertex += shift;
  return shape;
}

Shape
scaled(Shape shape, double factor)
{
  for (Position& vertex : shape.vertices)
    vertex *= factor;
  return shape;
}

Triangles
reversed(Triangles triangles)
{
  for (Triangle& triangle : triangles)
    std::swap(triangle[1], triangle[2]);
  return triangles;
}

Triangles
randomlyReversed(Triangles triangles, std::uint64_t seed)
{
  RandomSource random(seed);
  for (Triangle& triangle : triangles)
    if (random.uniform() < 0.5)
      std::swap(triangle[1], triangle[2]);
  return triangles;
}

Shape
shuffled(const Shape& shape, std::uint64_t seed)
{
  RandomSource random(seed);
  std::vector<index_t> number(shape.vertices.size());
  std::iota(number.begin(), number.end(), 0);
  random.shuffle(number);
  Shape result = shape;
  for (std::size_t i = 0; i < number.size(); ++i)
    result.vertices[static_cast<std::size_t>(number[i])] = shape.vertices[i];
  for (Triangle& triangle : result.triangles) {
    const Triangle old = triangle;
    const std::size_t start = random.below(3);
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] = number[static_cast<std::size_t>(old[(start + k) % 3])];
  }
  random.shuffle(result.triangles);
  return result;
}

Shape
withoutTriangles(const Shape& shape, const std::vector<std::size_t>& removed)
{
  Shape rest;
  rest.vertices = shape.vertices;
  auto next = removed.begin();
  for (std::size_t i = 0; i < shape.triangles.size(); ++i) {
    if (next != removed.end() && *next == i)
      ++next;
    else
      rest.triangles.push_back(shape.triangles[i]);
  }
  return rest;
}

double
signedVolume(const Shape& shape)
{
  double six_volumes = 0.0;
  for (const Triangle& t : shape.triangles) {
    const Position& a = shape.vertices[static_cast<std::size_t>(t[0])];
    const Position& b = shape.vertices[static_cast<std::size_t>(t[1])];
    const Position& c = shape.vertices[static_cast<std::size_t>(t[2])];
    six_volumes += a.dot(b.cross(c));
  }
  return six_volumes / 6.0;
}

} // namespace pcl::ccaa::test
