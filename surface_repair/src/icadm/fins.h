// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: small islands that hang on a surface that is whole.

#pragma once

#include "icadm/incomplete_model.h"

#include <set>
#include <utility>

namespace pcl::repair {

/** \brief Points of the cloud, the lower one first. */
using PointEdge = std::pair<pcl::index_t, pcl::index_t>;

/** \brief Edges of small islands that two triangles of another island have, too,
 * between the same points. The islands were cut off where three triangles met; nothing
 * is missing between them and the surface. To be asked of the input: a patch may have
 * an edge of a crumb that it covers. Linear in the triangles of the model. */
std::set<PointEdge>
edgesWithFins(const IncompleteModel& model);

/** \brief Mark small islands on such edges as fins.
 * Cost: linear in the triangles of the model. */
void
markFins(const std::set<PointEdge>& edges, IncompleteModel& model);

} // namespace pcl::repair
