// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the greedy start on ranked points (thesis 3.3).
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/reconstruction_report.h>

#include "greedy/ranked_points.h"
#include "greedy/scan_lines.h"
#include "mesh/triangle.h"
#include "run/run_control.h"

namespace pcl::ccaa {

/** \brief Greedy triangulation extended to 3D.
 *
 * Candidate edges from the neighborhoods, certified ones first, each group of points
 * shortest first; every edge that passes the three-part test is added and gives a
 * triangle for each common neighbor of its ends. A second pass tries the other
 * candidates between points that are still open.
 *
 * The result may hold wrong triangles, holes and bow-ties but no edge with more than
 * two triangles, and is the same for any number of threads. Cost O(N k^2); about 110
 * bytes a point besides the neighbors. \param[in] points coordinates by rank \param[in]
 * neighbors their neighbor rows, k at most 64 \param[in] parameters settings, in range
 * \param[in] threads at least 1
 * \param[in,out] control progress, stages "edges" and "second pass"
 * \param[in,out] report counts of edges and triangles
 * \return triangles in ranks, no consistent winding; empty when cancelled */
Triangles
greedyTriangulation(const RankedPoints& points,
                    const NeighborRows& neighbors,
                    const ScanLines& lines,
                    const GreedyParameters& parameters,
                    int threads,
                    RunControl& control,
                    GreedyReport& report);

} // namespace pcl::ccaa
