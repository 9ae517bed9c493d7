// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether samples tell the surface that was lost.

#pragma once

#include "filling/patch.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief The distance to the so many-th neighbour is the spacing at a free point. */
constexpr std::size_t SPACING_NEIGHBOUR = 3;

/** \brief Whether samples tell the surface of the patch that has grown over them,
 * rather than being stray points, as depth jumps leave them.
 *
 * Samples of a surface cover it, lie evenly on it, begin at its rim, and it is smooth.
 * So triangles at samples that have edges of more than three spacings (the median
 * distance to the third neighbour) take a fifth of the area at most, or else: the
 * spacing of a tenth of them is at most four times that of another tenth (six times
 * where few edges are long beside the spacing at their own ends), half of the rim has
 * one within three spacings, and at most a tenth of the length of their edges is folded
 * by more than a right angle (doc/concepts/repair.md: samples of a lost part). Cost:
 * log-linear in the samples and the patch. \param[in] free_points of the model
 * \param[in] places of the samples, four at least */
bool
samplesDescribe(const Positions& free_points,
                const std::vector<std::size_t>& places,
                const Patch& patch);

} // namespace pcl::repair
