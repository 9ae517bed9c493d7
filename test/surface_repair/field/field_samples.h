// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: sources and surroundings with known facts, for tests of the
// field.
#pragma once

#include "field/free_point_field.h"
#include "field/indicator_field.h"
#include "field/shielding.h"
#include "support/random_source.h"
#include "support/shapes.h"

#include <cstdint>
#include <vector>

namespace pcl::repair::test {

using ccaa::test::RandomSource;

/** \brief Regular polygon around z at a height, with normals away from the axis. Walked
 * counter-clockwise seen from above: the boundary of a surface that lies above it. */
BoundaryCurve
ring(int edges, double radius, double height, bool surface_above);

/** \brief The boundaries of two caps of the unit sphere that face each other across a
 * gap around the equator: island 0 above, island 1 below. */
SourceSet
twoCaps(int edges, double gap);

/** \brief Sources anywhere in the unit box, charges within +-2, three curves on islands
 * 0 to 2. */
SourceSet
randomSources(std::size_t count, std::uint64_t seed);

Position
randomPosition(RandomSource& random);
Direction
randomDirection(RandomSource& random);

/** \brief Queries at random places of the unit box, L_1 0.05, L_2 0.8. */
std::vector<FieldQuery>
randomQueries(std::size_t count, std::uint64_t seed);

/** \brief H by the formulas as the thesis has them, E4.43-3 to E4.43-6 with both
 * matrices, source by source. */
Tension
plainTension(const SourceSet& sources,
             const FieldQuery& query,
             double interpolation,
             const FreePointField* free_points = nullptr,
             const Shield* shield = nullptr);

/** \brief Sum of the weights h q_12 of all sources: what errors are measured by. */
double
weightAt(const SourceSet& sources, const FieldQuery& query);

/** \brief A shape as a model without more than positions and triangles. */
IncompleteModel
modelOf(const ccaa::test::Shape& shape);

} // namespace pcl::repair::test
