// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: counts that tell the topology of a mesh. They share no code
// with the library, so that they can judge it.
#pragma once

#include "shapes.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa::test {

/** \brief What tells surfaces apart: each number is a sum over the components. */
struct Topology {
  std::size_t components = 0; /**< connected over edges */
  long characteristic = 0;    /**< of Euler: used vertices - edges + triangles */
  std::size_t borders = 0;    /**< closed walks along edges of one triangle */
};

/** \brief Count. Triangles must be an ICADM, see isIcadm(). */
Topology
topologyOf(const Triangles& triangles);

/** \brief The number of the edge-connected component of each triangle; numbered by
 * their first triangle. */
std::vector<std::size_t>
componentOfTriangles(const Triangles& triangles);

/** \brief The largest fans of all vertices: triangles are taken away until every vertex
 * has one fan, and so are components of fewer than `fewest` triangles. Edges must have
 * two triangles at the most. */
Triangles
manifoldPart(Triangles triangles, std::size_t fewest);

/** \brief Triangles of `part` that `whole` does not have with the same winding; order
 * and rotation of corners do not matter. */
std::size_t
countMissing(const Triangles& part, const Triangles& whole);

} // namespace pcl::ccaa::test
