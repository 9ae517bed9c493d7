// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which free points may become vertices of a filling.

#pragma once

#include "filling/filling_method.h"

#include <cstddef>
#include <set>
#include <vector>

namespace pcl::repair {

/** \brief The free points, ascending, that are finite, not at a place of the polygon or
 * of an earlier one, and not outliers: those whose nearest neighbours, among polygon
 * and free points, are much further away than is usual here. */
std::vector<std::size_t>
usableSamples(const FillingTask& task);

/** \brief Vertices from number \a first on at which triangles are a spike: they stand
 * higher above the plane of the vertices around than these are apart. All of them must
 * be inner vertices, with one closed fan. */
std::set<pcl::index_t>
spikesOf(const Triangles& triangles, const Positions& points, std::size_t first);

} // namespace pcl::repair
