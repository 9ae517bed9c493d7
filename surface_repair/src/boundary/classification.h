// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: telling holes from rims and the outer border (4.1).

#pragma once

#include <pcl/surface_repair/model_findings.h>
#include <pcl/surface_repair/repair_parameters.h>

#include "boundary/boundary_integral.h"
#include "mesh/block_loop.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief Length of the mean normal of a model, or of its first triangles, weighted by
 * area: 0 for a body seen from all sides, 1 for a flat sheet. */
double
facingOf(const IncompleteModel& model);
double
facingOf(const IncompleteModel& model, std::size_t triangles);

/** \brief Whether a model that faces so much is a body or parts of one, rather than a
 * sheet: what is lost of a body turns as much of it one way. */
bool
isSeenFromAllSides(double facing);

/** \brief Classify all loops of a model.
 *
 * D decides together with two witnesses that know what D cannot: how the loop turns on
 * the surface, and how large its island is. On a sphere with one round opening all
 * three agree; the stump of a limb, where D is about 0 or below, is known for a hole by
 * its island's size. Loops of one-sided islands are UNDECIDED. Several islands that
 * together are seen from all sides are parts of a body: their rims are no outer
 * borders, whatever faces them.
 *
 * Cost: about 3 us a boundary edge (see farthestPoints()), 0.1 us a triangle.
 * The result is the same for any number of threads.
 * \param[in] loops of this model, all of them: others of the same island matter
 * \param[in] context a thread takes whole loops \return empty after cancelling */
std::vector<LoopClass>
classifyBoundaries(const IncompleteModel& model,
                   const BoundaryLoops& loops,
                   const ClassificationParameters& parameters = {},
                   const ccaa::LoopContext& context = {});

} // namespace pcl::repair
