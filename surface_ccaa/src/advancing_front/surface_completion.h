// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm on index triangles (thesis 3.1, 3.5).
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>
#include <pcl/surface_ccaa/reconstruction_report.h>

#include "advancing_front/gap_growth.h"
#include "advancing_front/given_surface.h"
#include "mesh/surface_topology.h"
#include "mesh/thin_necks.h"
#include "mesh/triangle.h"
#include "run/run_control.h"

#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief A completed mesh. */
struct CompletedMesh {
  PartialMeshFault fault = PartialMeshFault::NONE; /**< if any, nothing else is set */
  Triangles triangles; /**< the given ones that stay, in order, then the new ones */
  std::vector<pcl::index_t> kept; /**< which of the given ones, ascending */
  double typical_fold = 0.0;      /**< of what was given, see Doubts */
  /** \name Unless all given ones are kept. */
  /** \{ */
  SurfaceTopology topology;
  TriangleAdjacency adjacency; /**< of the triangles, as long as they are worked on */
  /** \} */
  /** \name Where it is narrow (openTunnels()). */
  /** \{ */
  std::vector<ThinNeck> thin_necks;
  std::vector<std::uint8_t> is_cleft; /**< of a vertex */
  bool has_cleft_handle = false;      /**< a handle passes through a cleft */
  /** \} */
};

/** \brief Complete a partial mesh: keep what is given, close gaps where the sampling
 * supports a surface, use the free points.
 *
 * With an empty mesh it is a reconstruction by itself, the algorithm A of thesis 3.1.
 * The result is manifold: every edge has at most two triangles, every vertex one fan,
 * and neighbors are wound alike; outward where that can be told (orientTriangles()).
 * New triangles cross neither each other nor the given ones. Islands about whose sides
 * normals, viewpoints or what is told are clear are never turned against that, and not
 * joined where it contradicts itself (see alignIslands()).
 *
 * The result is the same for any number of threads; the growth itself is serial. Cost:
 * about 0.5 us per vertex of the given mesh, 15 us per open point; 100 bytes per
 * vertex, 600 per open point.
 *
 * \param[in] search among the open vertices
 * \param[in,out] control stages "partial mesh", "growth", "local regrowth",
 * "orientation", "outer side" \param[in,out] report counts; cancelled is set when it
 * was stopped */
CompletedMesh
completeSurface(PartialMesh mesh,
                const NeighborSearch& search,
                const CompletionParameters& parameters,
                int threads,
                RunControl& control,
                CompletionReport& report);

} // namespace pcl::ccaa
