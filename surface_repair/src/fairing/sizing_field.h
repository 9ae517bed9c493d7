// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how long the edges of a patch should be.

#pragma once

#include "filling/patch.h"
#include "run/run_control.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief Mean length of the model's edges at a vertex of the rim. */
double
meanEdgeLength(const IncompleteModel& model, pcl::index_t vertex);

/** \brief The sizing field: the wanted length of an edge at each vertex: along the rim
 * that of the model around, averaged with the neighbours on the rim against the jags of
 * scans; within the patch the logarithm is harmonic over its edges. \param[in] sweeps
 * over the inner vertices, at least 1 */
std::vector<double>
sizingField(const IncompleteModel& model,
            const Patch& patch,
            std::size_t sweeps,
            ccaa::RunControl* control = nullptr);

/** \brief Average the inner vertices' logarithms over their neighbours once more.
 * \param[in] control of the work, or null */
void
interpolateLengths(const Patch& patch,
                   std::size_t sweeps,
                   std::vector<double>& lengths,
                   ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
