// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which two of the triangles on an edge belong together.
#pragma once

#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief An edge with more triangles than this is not looked into: all pairs would
 * have to be compared. */
constexpr std::size_t MAXIMUM_WINGS = 64;

/** \brief A triangle as seen from one of its edges. */
struct Wing {
  Position direction; /**< unit, from the edge to the third corner, perpendicular to the
                         edge; zero when the triangle has no area */
  int support = 0;    /**< how many of its other edges have exactly two triangles */
};

/** \brief The direction does not depend on the order of the edge's or the triangle's
 * corners, not even in the last digit. */
Wing
describeWing(const TriangleAdjacency::Edge& edge,
             const Triangle& triangle,
             int support,
             const Positions& positions);

/** \brief The most plausible pair (lower place first); nothing when it is not unique.
 * For the order of pairs see repairNonManifoldEdges(). */
std::optional<std::pair<std::size_t, std::size_t>>
bestWingPair(const std::vector<Wing>& wings);

} // namespace pcl::ccaa
