// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether triangles are what a filling promises to be.

#pragma once

#include "filling/filling_method.h"

#include <cstddef>

namespace pcl::repair {

/** \brief Whether triangles are a disc over vertices 0 to vertices - 1 whose border is
 * the polygon 0, 1, .. polygon_size - 1, run through against its direction.
 *
 * That is: corners are different and in range, every vertex is used, every edge of the
 * polygon is run through once, backwards, every other edge once each way, the triangles
 * are connected, and vertices - edges + triangles is 1. Then every vertex has exactly
 * one fan. Cost: n log n. */
bool
isDisc(const Triangles& triangles, std::size_t polygon_size, std::size_t vertices);

/** \brief The same of a filling that closes a polygon of so many points. */
bool
isDisc(const Filling& filling, std::size_t polygon_size);

} // namespace pcl::repair
