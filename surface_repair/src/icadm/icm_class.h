// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the classes of incomplete models (D4.1-4).

#pragma once

#include <pcl/surface_repair/model_findings.h>
#include <pcl/surface_repair/repair_parameters.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

IcmClass
classOf(const IcmCounts& counts);

/** \brief Count holes by their number of edges.
 * \param[in] hole_edges of each hole \param[in] simple_edges at most so many: simple */
IcmCounts
countHoles(std::size_t islands,
           const std::vector<std::size_t>& hole_edges,
           std::size_t simple_edges = SIMPLE_HOLE_EDGES);

} // namespace pcl::repair
