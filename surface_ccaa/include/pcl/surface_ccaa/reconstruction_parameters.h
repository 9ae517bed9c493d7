// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: all options of the algorithms that reconstruct.
#pragma once

#include <cstddef>

namespace pcl::ccaa {

/** \brief Settings of the greedy start; the defaults need no knowledge of the cloud. */
struct GreedyParameters {
  /** \brief k: neighbors of a point between which edges are considered, 3 to 64. Where
   * points lie in lines, as of the profiles of a scanner, and hardly see the next line,
   * it is doubled until they do. Set it higher where density changes within a few
   * points. */
  unsigned int neighbors = 16;
  /** \brief A_T of thesis 3.3 in radians, 0 to pi/3. Default 11 degrees. Holds for
   * every edge that has no certificate (see edge_certificate.h). Set it lower where
   * narrow triangles are better than holes. */
  double minimum_angle = 0.19198621771937624;
  /** \brief A_T for certified edges in radians, 0 to pi/3. Default 1 degree: the
   * certificate already excludes the crossings that A_T is there to prevent, so only
   * slivers without a usable normal are refused. Set it to minimum_angle for the rule
   * of the thesis on all edges. */
  double certified_minimum_angle = 0.017453292519943295;
  /** \brief Longest edge as a multiple of the local spacing, the root mean square
   * distance to the six nearest neighbors of either end. At least 1; default 3. For
   * points in lines it is at least one and a half times the usual distance of the next
   * line. Set it higher where thin regions stay open, lower where separate parts get
   * joined. */
  double length_factor = 3.0;
  /** \brief Let certified edges go first. With false all candidate edges compete by
   * length and A_T alone: the plain algorithm of thesis 3.3, which does not look for
   * lines either. Set it false to compare with that. */
  bool certificates = true;
  /** \brief After the certified edges, try the other candidates between points whose
   * umbrella is still open. Set it false to hand on what is certain only. */
  bool second_pass = true;
};

/** \brief Settings of the base algorithm; the defaults need no knowledge of the cloud.
 */
struct CompletionParameters {
  /** \brief Open points around an open point among which its triangles are sought, 6 to
   * 64. Set it higher where density changes within a few points. */
  unsigned int neighbors = 20;
  /** \brief Largest circumradius of a new triangle as a multiple of the local spacing:
   * wider gaps have no samples to support a surface and stay open. Set it higher where
   * sparse regions stay open, lower where gaps are bridged. */
  double support = 2.0;
  /** \brief Angle in radians between the normals of neighboring triangles up to which
   * the surface counts as smooth; 30 degrees. Folds beyond wait until last. Set it
   * higher for coarse samples of tight curves. */
  double smooth_fold = 0.5235987755982988;
  /** \brief Largest angle between the normals of neighboring triangles; 150 degrees.
   * Set it lower where the surface turns back on itself in noise. */
  double largest_fold = 2.6179938779914944;
  /** \brief A region that grew by itself stays only with so many internal points. Set
   * it to 0 where small separate parts are wanted. */
  std::size_t minimum_internal_points = 10;
  /** \brief Keep every given triangle, whatever it looks like. With false the given
   * ones that are doubtful (see doubtfulTriangles()) or that obstruct the completion
   * may be replaced. Set it false where the points are more to be trusted than
   * the mesh. */
  bool keep_given = true;
};

} // namespace pcl::ccaa
