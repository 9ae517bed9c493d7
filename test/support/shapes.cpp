// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: small named meshes with known facts, for tests.
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace pcl::ccaa::test {

namespace {

using VertexPair = std::pair<index_t, index_t>;

/** \brief Appends the two triangles of a square a b c d given counter-clockwise. */
void
addSquare(Triangles& triangles, index_t a, index_t b, index_t c, index_t d)
{
  triangles.push_back({a, b, c});
  triangles.push_back({a, c, d});
}

Shape
icosahedron()
{
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  Shape shape;
  shape.vertices = {{-1, g, 0},
                    {1, g, 0},
                    {-1, -g, 0},
                    {1, -g, 0},
                    {0, -1, g},
                    {0, 1, g},
                    {0, -1, -g},
                    {0, 1, -g},
                    {g, 0, -1},
                    {g, 0, 1},
                    {-g, 0, -1},
                    {-g, 0, 1}};
  shape.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  return shape;
}

/** \brief Index of the vertex in the middle of an edge, made on first use. */
index_t
middleOf(index_t a, index_t b, Positions& vertices, std::map<VertexPair, index_t>& made)
{
  const auto next = static_cast<index_t>(vertices.size());
  const auto entry = made.emplace(std::minmax(a, b), next);
  if (entry.second) {
    const Position middle = (vertices[static_cast<std::size_t>(a)] +
                             vertices[static_cast<std::size_t>(b)]) /
                            2.0;
    vertices.push_back(middle);
  }
  return entry.first->second;
}

/** \brief Each triangle into four. */
void
split(Shape& shape)
{
  std::map<VertexPair, index_t> made;
  Triangles finer;
  for (const Triangle& t : shape.triangles) {
    const index_t ab = middleOf(t[0], t[1], shape.vertices, made);
    const index_t bc = middleOf(t[1], t[2], shape.vertices, made);
    const index_t ca = middleOf(t[2], t[0], shape.vertices, made);
    finer.insert(finer.end(),
                 {{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
  }
  shape.triangles = std::move(finer);
}

/** \brief Triangles of a lattice with wrap-around where asked. */
Triangles
latticeTriangles(int columns, int rows, bool wrap_columns, bool wrap_rows)
{
  Triangles triangles;
  const auto at = [&](int x, int y) { return (y % rows) * columns + x % columns; };
  for (int y = 0; y < (wrap_rows ? rows : rows - 1); ++y)
    for (int x = 0; x < (wrap_columns ? columns : columns - 1); ++x)
      addSquare(triangles, at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
  return triangles;
}

/** \brief Index of a cube's surface vertex at integer coordinates, made on first use.
 */
index_t
cubeVertex(const std::array<int, 3>& place,
           double spacing,
           Positions& vertices,
           std::map<std::array<int, 3>, index_t>& made)
{
  const auto entry = made.emplace(place, static_cast<index_t>(vertices.size()));
  if (entry.second)
    vertices.push_back(Position(place[0], place[1], place[2]) * spacing);
  return entry.first->second;
}

} // namespace

Shape
tetrahedron()
{
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

Shape
icosphere(int subdivisions, double radius)
{
  Shape shape = icosahedron();
  for (int i = 0; i < subdivisions; ++i)
    split(shape);
  for (Position& vertex : shape.vertices)
    vertex *= radius / vertex.norm();
  return shape;
}

Shape
ellipsoid(int subdivisions, double length)
{
  Shape shape = icosphere(subdivisions);
  for (Position& vertex : shape.vertices)
    vertex.z() *= length;
  return shape;
}

Shape
torus(int around, int across, double major_radius, double minor_radius)
{
  Shape shape;
  for (int j = 0; j < across; ++j)
    for (int i = 0; i < around; ++i) {
      const double u = 2.0 * M_PI * i / around, v = 2.0 * M_PI * j / across;
      const double ring = major_radius + minor_radius * std::cos(v);
      shape.vertices.emplace_back(
          ring * std::cos(u), ring * std::sin(u), minor_radius * std::sin(v));
    }
  shape.triangles = latticeTriangles(around, across, true, true);
  return shape;
}

Shape
cylinder(int around, int along, double radius, double height)
{
  Shape shape;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double u = 2.0 * M_PI * i / around;
      shape.vertices.emplace_back(
          radius * std::cos(u), radius * std::sin(u), height * j / along);
    }
  shape.triangles = latticeTriangles(around, along + 1, true, false);
  return shape;
}

Shape
cube(int divisions, double side)
{
  Shape shape;
  std::map<std::array<int, 3>, index_t> made;
  const auto vertexAt = [&](int axis, int face, int u, int v) {
    std::array<int, 3> place{};
    place[static_cast<std::size_t>(axis)] = face * divisions;
    place[static_cast<std::size_t>((axis + 1) % 3)] = u;
    place[static_cast<std::size_t>((axis + 2) % 3)] = v;
    return cubeVertex(place, side / divisions, shape.vertices, made);
  };
  for (int side_index = 0; side_index < 6; ++side_index)
    for (int u = 0; u < divisions; ++u)
      for (int v = 0; v < divisions; ++v) {
        const int axis = side_index / 2, face = side_index % 2;
        const index_t a = vertexAt(axis, face, u, v);
        const index_t b = vertexAt(axis, face, u + 1, v);
        const index_t c = vertexAt(axis, face, u + 1, v + 1);
        const index_t d = vertexAt(axis, face, u, v + 1);
        if (face == 1)
          addSquare(shape.triangles, a, b, c, d);
        else
          addSquare(shape.triangles, a, d, c, b);
      }
  return shape;
}

Shape
grid(int columns, int rows)
{
  Shape shape;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      shape.vertices.emplace_back(x, y, 0.0);
  shape.triangles = latticeTriangles(columns, rows, false, false);
  return shape;
}

Shape
terrain(int columns, int rows, double amplitude)
{
  Shape shape = grid(columns, rows);
  for (Position& vertex : shape.vertices)
    vertex.z() = amplitude * std::sin(0.21 * vertex.x()) * std::cos(0.17 * vertex.y());
  return shape;
}

Shape
thinPlate(int columns, int rows, double thickness)
{
  Shape lower = grid(columns, rows);
  lower.triangles = reversed(lower.triangles);
  return joined(translated(grid(columns, rows), {0, 0, thickness}), lower);
}

Shape
spheresJoinedByTube(double gap, int rings)
{
  const Shape sphere = icosphere(3);
  const auto most =
      std::max_element(sphere.vertices.begin(),
                       sphere.vertices.end(),
                       [](const auto& a, const auto& b) { return a.x() < b.x(); });
  const auto tip = static_cast<pcl::index_t>(most - sphere.vertices.begin());
  const auto count = static_cast<pcl::index_t>(sphere.vertices.size());
  Shape shape;
  for (int copy = 0; copy <= rings; ++copy)
    for (const Position& place : sphere.vertices)
      shape.vertices.emplace_back((place.x() - most->x() - 0.5 * gap) *
                                      (1.0 - 2.0 * copy / rings),
                                  place.y(),
                                  place.z());
  const pcl::index_t last = rings * count;
  for (const Triangle& triangle : sphere.triangles) {
    const auto* at = std::find(triangle.begin(), triangle.end(), tip);
    if (at == triangle.end()) {
      const auto [a, b, c] = triangle;
      shape.triangles.push_back(triangle);
      shape.triangles.push_back({a + last, c + last, b + last});
      continue;
    }
    const auto place = static_cast<std::size_t>(at - triangle.begin());
    const pcl::index_t from = triangle[(place + 1) % 3], to = triangle[(place + 2) % 3];
    for (pcl::index_t here = 0; here < last; here += count) {
      const pcl::index_t next = here + count;
      shape.triangles.push_back({from + here, to + here, from + next});
      shape.triangles.push_back({to + here, to + next, from + next});
    }
  }
  return shape;
}

Shape
nestedSpheres(int subdivisions)
{
  return joined(icosphere(subdivisions), icosphere(subdivisions, 0.5));
}

Shape
moebiusBand(int around)
{
  Shape shape;
  for (int i = 0; i < around; ++i) {
    const double angle = 2.0 * M_PI * i / around;
    const Position outward(std::cos(angle), std::sin(angle), 0.0);
    const Position across =
        std::cos(angle / 2.0) * Position::UnitZ() + std::sin(angle / 2.0) * outward;
    shape.vertices.push_back(outward - 0.3 * across);
    shape.vertices.push_back(outward + 0.3 * across);
  }
  for (int i = 0; i + 1 < around; ++i)
    addSquare(shape.triangles, 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
  const int last = 2 * (around - 1);
  addSquare(shape.triangles, last, 1, 0, last + 1);
  return shape;
}

Shape
bowTie()
{
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}},
          {{0, 1, 2}, {0, 3, 4}}};
}

Shape
twoFansAtApex()
{
  Shape shape;
  shape.vertices = {{0, 0, 0},
                    {1, 0, 1},
                    {0, 1, 1},
                    {-1, 0, 1},
                    {0, -1, 1},
                    {1, 0, -1},
                    {0, 1, -1},
                    {-1, 0, -1},
                    {0, -1, -1}};
  for (int i = 0; i < 4; ++i) {
    const index_t next = (i + 1) % 4;
    shape.triangles.push_back({0, 1 + i, 1 + next});
    shape.triangles.push_back({0, 5 + next, 5 + i});
  }
  return shape;
}

Shape
threeOnEdge()
{
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 1}, {0, -1, -1}},
          {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
}

} // namespace pcl::ccaa::test
