// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: surfaces to be completed, and ways to take parts of them.
#include "completion_shapes.h"

#include "random_source.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace pcl::ccaa::test {

namespace {

using Place = std::array<int, 3>;

/** \brief Vertices of a lattice, made when they are first asked for. */
class LatticeVertices {
public:
  explicit LatticeVertices(Positions& positions) : positions_(positions) {}

  index_t
  at(const Place& place)
  {
    const auto made = made_.emplace(place, static_cast<index_t>(positions_.size()));
    if (made.second)
      positions_.emplace_back(place[0], place[1], place[2]);
    return made.first->second;
  }

private:
  Positions& positions_;
  std::map<Place, index_t> made_;
};

/** \brief One side of a box: across the axis, at its low or high end. */
void
addSide(Shape& shape,
        LatticeVertices& vertices,
        const Place& size,
        std::size_t axis,
        bool high)
{
  const std::size_t along = (axis + 1) % 3, up = (axis + 2) % 3;
  const auto vertex = [&](int u, int v) {
    Place place{};
    place[axis] = high ? size[axis] : 0;
    place[along] = u;
    place[up] = v;
    return vertices.at(place);
  };
  for (int u = 0; u < size[along]; ++u)
    for (int v = 0; v < size[up]; ++v) {
      index_t a = vertex(u, v), b = vertex(u + 1, v), c = vertex(u + 1, v + 1),
              d = vertex(u, v + 1);
      if (!high)
        std::swap(b, d);
      shape.triangles.push_back({a, b, c});
      shape.triangles.push_back({a, c, d});
    }
}

/** \brief Marks the vertices within so many edges of one. */
void
markAround(const Shape& shape, index_t vertex, int rings, std::vector<bool>& marked)
{
  marked[static_cast<std::size_t>(vertex)] = true;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<bool> wider = marked;
    for (const Triangle& t : shape.triangles)
      if (std::any_of(t.begin(), t.end(), [&](index_t corner) {
            return marked[static_cast<std::size_t>(corner)];
          }))
        for (const index_t corner : t)
          wider[static_cast<std::size_t>(corner)] = true;
    marked = std::move(wider);
  }
}

std::size_t
headOf(std::vector<std::size_t>& heads, std::size_t triangle)
{
  while (heads[triangle] != triangle)
    triangle = heads[triangle] = heads[heads[triangle]];
  return triangle;
}

} // namespace

Shape
box(int columns, int rows, int layers)
{
  Shape shape;
  LatticeVertices vertices(shape.vertices);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true})
      addSide(shape, vertices, {columns, rows, layers}, axis, high);
  return shape;
}

Shape
noisyIcosphere(int subdivisions, double deviation, std::uint64_t seed)
{
  Shape shape = icosphere(subdivisions);
  RandomSource random(seed);
  for (Position& vertex : shape.vertices)
    vertex *= 1.0 + deviation * random.normal();
  return shape;
}

Positions
roundedToFloat(Positions positions)
{
  for (Position& position : positions)
    for (double& coordinate : position.reshaped()) {
      // volatile: GCC 12 drops the way to float and back when it vectorises it
      volatile const float rounded = static_cast<float>(coordinate);
      coordinate = static_cast<double>(rounded);
    }
  return positions;
}

Shape
roundedToFloat(Shape shape)
{
  shape.vertices = roundedToFloat(std::move(shape.vertices));
  return shape;
}

Shape
withoutRandomTriangles(const Shape& shape, double share, std::uint64_t seed)
{
  RandomSource random(seed);
  std::vector<std::size_t> removed;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t)
    if (random.uniform() < share)
      removed.push_back(t);
  return withoutTriangles(shape, removed);
}

Shape
withoutPatches(const Shape& shape, int count, int rings, std::uint64_t seed)
{
  RandomSource random(seed);
  std::vector<bool> marked(shape.vertices.size(), false);
  for (int i = 0; i < count; ++i) {
    std::vector<bool> patch(shape.vertices.size(), false);
    const auto middle = static_cast<index_t>(random.below(shape.vertices.size()));
    markAround(shape, middle, rings, patch);
    for (std::size_t v = 0; v < patch.size(); ++v)
      marked[v] = marked[v] || patch[v];
  }
  std::vector<std::size_t> removed;
  for (std::size_t t = 0; t < shape.triangles.size(); ++t)
    for (const index_t corner : shape.triangles[t])
      if (marked[static_cast<std::size_t>(corner)]) {
        removed.push_back(t);
        break;
      }
  return withoutTriangles(shape, removed);
}

std::vector<std::size_t>
pieceOfTriangles(const Triangles& triangles)
{
  std::vector<std::size_t> heads(triangles.size());
  std::map<std::pair<index_t, index_t>, std::size_t> first_on_edge;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    heads[t] = t;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto edge = std::minmax(triangles[t][i], triangles[t][(i + 1) % 3]);
      const std::size_t other = first_on_edge.emplace(edge, t).first->second;
      const std::size_t one = headOf(heads, t), two = headOf(heads, other);
      heads[std::max(one, two)] = std::min(one, two);
    }
  }
  std::vector<std::size_t> pieces(triangles.size());
  std::size_t count = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::size_t head = headOf(heads, t);
    pieces[t] = head == t ? count++ : pieces[head];
  }
  return pieces;
}

Triangles
withEverySecondPieceReversed(Triangles triangles)
{
  const std::vector<std::size_t> pieces = pieceOfTriangles(triangles);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (pieces[t] % 2 == 1)
      std::swap(triangles[t][1], triangles[t][2]);
  return triangles;
}

} // namespace pcl::ccaa::test
