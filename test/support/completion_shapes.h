// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: surfaces to be completed, and ways to take parts of them.
#pragma once

#include "mesh/triangle_adjacency.h"
#include "shapes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa::test {

inline TriangleAdjacency
adjacencyOf(const Shape& shape)
{
  TriangleAdjacency adjacency;
  adjacency.build(shape.triangles, shape.vertices.size());
  return adjacency;
}

/** \brief Closed box of columns * rows * layers cubes of side 1 with sharp edges,
 * vertices at integer coordinates. With few layers a thin plate with a rim. */
Shape
box(int columns, int rows, int layers);

/** \brief Icosphere of radius 1 whose vertices move along their radius by normal noise;
 * star-shaped, so it does not intersect itself. */
Shape
noisyIcosphere(int subdivisions, double deviation, std::uint64_t seed = 1);

/** \brief The same with its positions rounded to float, as a cloud holds them. */
Shape
roundedToFloat(Shape shape);

Positions
roundedToFloat(Positions positions);

/** \brief The shape without a share of its triangles, chosen at random. */
Shape
withoutRandomTriangles(const Shape& shape, double share, std::uint64_t seed);

/** \brief The shape without `count` patches: all triangles with a corner within so many
 * edges of a random vertex. The vertices inside become free. */
Shape
withoutPatches(const Shape& shape, int count, int rings, std::uint64_t seed);

/** \brief The number of the edge-connected piece of each triangle; pieces are numbered
 * by their first triangle. Edges with three triangles connect all of these. */
std::vector<std::size_t>
pieceOfTriangles(const Triangles& triangles);

/** \brief Every second piece wound the other way. */
Triangles
withEverySecondPieceReversed(Triangles triangles);

} // namespace pcl::ccaa::test
