// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: small named meshes with known facts, for tests.
#pragma once

#include "mesh/triangle.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa::test {

/** \brief A mesh as the rooms see it: positions and triangles. Unless said otherwise
 * the triangles are wound counter-clockwise seen from outside (or above). */
struct Shape {
  Positions vertices;
  Triangles triangles;
};

/** \brief 4 vertices, 4 triangles, closed; corners at the origin and the unit axes. */
Shape
tetrahedron();

/** \brief Icosahedron split `subdivisions` times: 10 * 4^s + 2 vertices, 20 * 4^s
 * triangles, closed, genus 0. */
Shape
icosphere(int subdivisions, double radius = 1.0);

/** \brief The icosphere of radius 1 drawn out along z: half axes 1, 1, length. */
Shape
ellipsoid(int subdivisions, double length);

/** \brief Closed, genus 1: around * across vertices, twice as many triangles. The axis
 * is z; around, across >= 3. */
Shape
torus(int around, int across, double major_radius = 1.0, double minor_radius = 0.35);

/** \brief Open tube around z without lids, two boundary loops of `around` edges. */
Shape
cylinder(int around, int along, double radius = 1.0, double height = 2.0);

/** \brief Closed cube [0, side]^3 with sharp edges, `divisions` squares along an edge;
 * vertices on the edges are shared by the faces. */
Shape
cube(int divisions, double side = 1.0);

/** \brief Flat square of columns * rows vertices at spacing 1 in z = 0, wound upward.
 */
Shape
grid(int columns, int rows);

/** \brief Open rolling terrain over the grid, heights within +-amplitude. */
Shape
terrain(int columns, int rows, double amplitude = 2.0);

/** \brief Two parallel grids `thickness` apart, not joined: the upper one wound upward,
 * the lower one downward. */
Shape
thinPlate(int columns, int rows, double thickness = 0.2);

/** \brief An icosphere and its mirror image along x, where they are nearest to each
 * other a tube of so many rings instead of a vertex of each. What belongs to no
 * triangle has vertices, too. \param[in] gap between the spheres \param[in] rings at
 * least 1 */
Shape
spheresJoinedByTube(double gap, int rings);

/** \brief Icosphere of radius 1 and, as a second component, one of radius 0.5 inside;
 * both wound outward, each by its own volume. */
Shape
nestedSpheres(int subdivisions);

/** \brief One-sided band with one boundary loop of 2 * around edges; around >= 5. No
 * winding of it is consistent. */
Shape
moebiusBand(int around);

/** \brief Two triangles that share only vertex 0. */
Shape
bowTie();

/** \brief Two closed fans (pyramids without base) that share only their apex 0. */
Shape
twoFansAtApex();

/** \brief Three triangles on the edge 0-1. */
Shape
threeOnEdge();

/** \brief Both shapes as one; the second one's vertices come after the first one's. */
Shape
joined(const Shape& first, const Shape& second);

Shape
translated(Shape shape, const Position& shift);

Shape
scaled(Shape shape, double factor);

/** \brief Every triangle wound the other way. */
Triangles
reversed(Triangles triangles);

/** \brief Each triangle wound the other way with probability one half. */
Triangles
randomlyReversed(Triangles triangles, std::uint64_t seed);

/** \brief The same surface with vertices renumbered, triangles reordered and each
 * triangle rotated at random; the windings stay. */
Shape
shuffled(const Shape& shape, std::uint64_t seed);

/** \brief The shape without the triangles given by ascending index. */
Shape
withoutTriangles(const Shape& shape, const std::vector<std::size_t>& removed);

/** \brief Volume enclosed by a closed mesh: positive when it is wound outward. */
double
signedVolume(const Shape& shape);

} // namespace pcl::ccaa::test
