// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the given triangles before a surface grows from them.
#pragma once

#include "advancing_front/doubtful_triangles.h"
#include "mesh/block_loop.h"
#include "mesh/islands.h"
#include "mesh/orientation.h"
#include "mesh/point_view.h"
#include "mesh/side_hints.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief A cloud with a partial mesh. */
struct PartialMesh {
  PointView points;     /**< of all vertices that may be used: finite, one per place */
  PointView normals;    /**< outward, one per vertex, or empty */
  PointView viewpoints; /**< sensor positions, one per vertex, or empty */
  SideHints sides;      /**< what is told for the whole */
  Triangles given;      /**< three different vertices each */
  TriangleAdjacency adjacency;      /**< of these, or empty: to be built */
  std::vector<std::uint8_t> is_cut; /**< one flag per vertex, or empty: the surface goes
                                         on there outside of what is given */

  bool
  isCut(pcl::index_t vertex) const
  {
    return !is_cut.empty() && is_cut[static_cast<std::size_t>(vertex)] != 0;
  }
};

/** \brief What is wrong with a partial mesh. */
enum class PartialMeshFault : std::uint8_t {
  NONE,
  NON_MANIFOLD_EDGE,   /**< more than two triangles on an edge, or one of them twice */
  NON_MANIFOLD_VERTEX, /**< more than one fan at a vertex */
  BADLY_ORIENTED       /**< two triangles run through an edge in the same direction */
};

/** \brief The given triangles as they were read. */
struct GivenSurface {
  PartialMeshFault fault = PartialMeshFault::NONE; /**< if any, the rest is of no use */
  TriangleAdjacency adjacency;
  Islands islands;
  Doubts doubts; /**< triangles that are to go */
};

/** \brief What of a completed mesh is to grow anew. */
struct Reopening {
  bool is_again = false;               /**< no triangle is doubtful for its shape */
  bool alone = false;                  /**< boundaries elsewhere stay as they are */
  std::vector<pcl::index_t> triangles; /**< that are to go */
  std::vector<pcl::index_t> handles;   /**< points, ascending, around which local
                                            regrowth opens handles, if no triangles go */
  std::size_t pieces = 0;              /**< of the completed mesh */
  double typical_fold = 0.0;           /**< of what was given first, see Doubts */

  /** \brief One piece is wound outward already; several may have to be turned for what
   * grows between them. */
  bool
  isWound() const
  {
    return is_again && pieces == 1;
  }
};

/** \brief Read the given triangles of a mesh. Doubtful are, where they need not all be
 * kept, those of doubtfulTriangles() and of islands in which neighbors are wound
 * differently: one-sided ones, which no object has, and those wound at random. Of a
 * mesh that is completed again, those that are to go.
 * \param[in,out] mesh its adjacency is taken over
 * \return nothing of use after cancelling */
GivenSurface
readGiven(PartialMesh& mesh,
          const Reopening& reopening,
          bool keep_given,
          const LoopContext& context);

/** \brief Boundary points, free points, and the corners of doubtful triangles,
 * ascending; none at a cut. \param[in] reopening with boundary points that are no such
 * corners unless alone, and with those where handles are opened */
std::vector<pcl::index_t>
openVertices(const PartialMesh& mesh,
             const GivenSurface& given,
             const Reopening& reopening);

/** \brief All that is known about the outer side. */
OrientationHints
hintsOf(const PartialMesh& mesh, int threads);

/** \brief Islands that are to be joined must agree before growth begins: see
 * alignIslands(). Normals that are overruled, or that agree with each other on less
 * than half of the given surface, would only keep triangles from growing: they are
 * dropped. \param[in,out] mesh its given triangles are re-wound, its normals perhaps
 * left out \param[in,out] given its adjacency follows \param[in] open points that may
 * get triangles \param[in] table of their neighbors among themselves, k a row, see
 * NeighborSearch */
void
alignGiven(PartialMesh& mesh,
           GivenSurface& given,
           const std::vector<pcl::index_t>& open,
           const std::vector<pcl::index_t>& table,
           const LoopContext& context);

} // namespace pcl::ccaa
