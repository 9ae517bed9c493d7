// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: open surfaces of small shapes, for tests of the rooms.
#pragma once

#include "advancing_front/growing_surface.h"
#include "advancing_front/open_surface.h"
#include "advancing_front/partial_surface.h"
#include "advancing_front/spacing.h"
#include "support/completion_shapes.h"
#include "support/random_source.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa::test {

inline Triangles
liveTriangles(const PartialSurface& surface)
{
  Triangles live;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t)
    if (surface.isAlive(static_cast<index_t>(t)))
      live.push_back(surface[static_cast<index_t>(t)]);
  return live;
}

/** \brief A shape as a partial surface, whose parts it keeps alive. */
struct PartialShape {
  explicit PartialShape(const Shape& whole)
  : shape(whole)
  , adjacency(adjacencyOf(shape))
  , surface(shape.triangles, adjacency, shape.vertices, {})
  {}
  PartialShape(const PartialShape&) = delete;
  PartialShape&
  operator=(const PartialShape&) = delete;

  /** \brief Free and boundary vertices, ascending. */
  std::vector<index_t>
  openVertices() const
  {
    std::vector<index_t> open;
    for (std::size_t v = 0; v < shape.vertices.size(); ++v)
      if (adjacency.fan(static_cast<index_t>(v)) != Fan::CLOSED)
        open.push_back(static_cast<index_t>(v));
    return open;
  }

  Shape shape;
  TriangleAdjacency adjacency;
  PartialSurface surface;
};

/** \brief The open surface of a shape. \param[out] vertices of the shape */
inline OpenSurface
openSurfaceOf(const Shape& shape,
              std::vector<index_t>& vertices,
              unsigned int neighbors = 20)
{
  const PartialShape partial(shape);
  OpenSurface open = partial.surface.openAt(partial.openVertices(), {}, vertices);
  findNeighborsDirectly(open, neighbors);
  completeSpacings(open);
  return open;
}

inline OpenSurface
openSurfaceOf(const Shape& shape, unsigned int neighbors = 20)
{
  std::vector<index_t> vertices;
  return openSurfaceOf(shape, vertices, neighbors);
}

/** \brief Points without triangles. */
inline OpenSurface
openPoints(const Positions& points, unsigned int neighbors = 20)
{
  return openSurfaceOf({points, {}}, neighbors);
}

inline Positions
randomPositions(std::size_t count, std::uint64_t seed)
{
  RandomSource random(seed);
  Positions positions(count);
  for (Position& position : positions)
    for (double& coordinate : position.reshaped())
      coordinate = random.uniform(-1.0, 1.0);
  return positions;
}

} // namespace pcl::ccaa::test
