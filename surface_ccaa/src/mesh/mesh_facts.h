// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: everything that can be counted and measured about a mesh.
#pragma once

#include "mesh/point_view.h"
#include "mesh/triangle.h"
#include "run/run_control.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace pcl::ccaa {

/** \brief One walk along the boundary, from fan to fan. A bow-tie vertex belongs to as
 * many loops as it has open fans, so loops that only touch there count separately. */
struct BoundaryLoopFacts {
  std::size_t edges = 0;
  double length = 0.0; /**< in units of the cloud; edges that are not finite left out */
};

/** \brief What measureMesh() found. Counts are of valid triangles only. */
struct MeshFacts {
  static constexpr std::size_t MINIMUM_ANGLE_BINS = 12; /**< 5 degrees each, 0 to 60 */
  static constexpr std::size_t ANGLE_BINS = 18; /**< 10 degrees each, 0 to 180 */

  std::size_t vertices = 0;          /**< points of the cloud */
  std::size_t used_vertices = 0;     /**< points with a triangle */
  std::size_t internal_vertices = 0; /**< one closed fan */
  std::size_t boundary_vertices = 0; /**< used, but not internal */
  std::size_t free_vertices = 0;     /**< points without a triangle */

  std::size_t invalid_triangles = 0;    /**< index out of range or repeated */
  std::size_t triangles = 0;            /**< the valid ones */
  std::size_t non_finite_triangles = 0; /**< with a corner that is not finite */
  std::size_t degenerate_triangles = 0; /**< corners on one line, exactly */

  std::size_t components = 0; /**< connected over edges */
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;
  std::vector<BoundaryLoopFacts> boundary_loops; /**< most edges first */
  std::size_t non_manifold_edges = 0;            /**< more than two triangles */
  std::size_t non_manifold_vertices = 0;         /**< more than one fan */
  std::size_t misoriented_edges = 0; /**< both of two triangles run the same way */
  bool orientable = true;            /**< some winding has no misoriented edge */
  long euler_characteristic = 0;     /**< used vertices - edges + triangles */
  std::optional<long> genus; /**< of orientable manifolds, all components together, each
                                  boundary loop closed by a disc */

  double area = 0.0;            /**< in squared units of the cloud */
  std::optional<double> volume; /**< when closed and consistently wound; > 0: outward */
  double smallest_angle = 0.0;  /**< in degrees, of all triangles; 0 without any */
  std::array<std::size_t, MINIMUM_ANGLE_BINS> minimum_angles{}; /**< one a triangle */
  std::array<std::size_t, ANGLE_BINS> angles{};                 /**< three a triangle */

  std::optional<std::size_t> self_intersections; /**< pairs; only when asked for */
  bool cancelled = false; /**< stopped: the other fields mean nothing */

  /** \brief Share of the points, 0 to 1; 0 for an empty cloud. */
  double
  shareOfVertices(std::size_t count) const
  {
    return vertices == 0 ? 0.0
                         : static_cast<double>(count) / static_cast<double>(vertices);
  }

  /** \brief No boundary, and every edge and vertex manifold. */
  bool
  isClosedManifold() const
  {
    return triangles > 0 && boundary_edges == 0 && non_manifold_edges == 0 &&
           non_manifold_vertices == 0;
  }

  /** \brief It encloses a volume: closed, and no neighbours wound against each other.
   */
  bool
  isWatertight() const
  {
    return isClosedManifold() && misoriented_edges == 0;
  }
};

/** \brief How to measure. */
struct MeshFactsOptions {
  bool self_intersections = true; /**< costs more than all the rest */
  int threads = 1;                /**< at least 1; used for self-intersections */
};

/** \brief Measure any mesh: triangles may repeat, cross, be invalid or degenerate.
 *
 * Cost: about 1 us a triangle (sorting of edges), plus findSelfIntersections(); 100
 * bytes a triangle.
 *
 * \param[in] triangles any
 * \param[in] positions of all points of the cloud, used or not
 * \param[in] options see there
 * \param[in,out] control stages "topology", "shape", "self-intersections" */
MeshFacts
measureMesh(const Triangles& triangles,
            const PointView& positions,
            const MeshFactsOptions& options,
            RunControl& control);

} // namespace pcl::ccaa
