// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: settings and report of the greedy start.
#pragma once

#include <cstddef>

namespace pcl {
namespace ccaa {

/** \brief Settings of the greedy start; the defaults need no knowledge of the cloud. */
struct GreedyParameters {
  /** \brief k: neighbors of a point between which edges are considered, 3 to 64. */
  unsigned int neighbors = 16;
  /** \brief A_T of thesis 3.3 in radians, 0 to pi/3. Default 11 degrees. Holds for
   * every edge that has no certificate (see edge_certificate.h). */
  double minimum_angle = 0.19198621771937624;
  /** \brief A_T for certified edges in radians, 0 to pi/3. Default 1 degree: the
   * certificate already excludes the crossings that A_T is there to prevent, so only
   * slivers without a usable normal are refused. Set it to minimum_angle for the rule
   * of the thesis on all edges. */
  double certified_minimum_angle = 0.017453292519943295;
  /** \brief Longest edge as a multiple of the local spacing, the root mean square
   * distance to the six nearest neighbors of either end. At least 1; default 3. */
  double length_factor = 3.0;
  /** \brief Let certified edges go first. With false all candidate edges compete by
   * length and A_T alone: the plain algorithm of thesis 3.3. */
  bool certificates = true;
  /** \brief After the certified edges, try the other candidates between points whose
   * umbrella is still open. */
  bool second_pass = true;
};

/** \brief What one run of the greedy start did. Times are wall-clock seconds. */
struct GreedyReport {
  std::size_t points = 0; /**< usable points: finite, selected, places counted once */
  std::size_t skipped_points =
      0; /**< selected points with a NaN or infinite coordinate */
  std::size_t duplicate_points = 0; /**< further points at a place that is taken */
  std::size_t candidate_edges = 0;  /**< edges examined, over both passes */
  std::size_t joined_edges = 0;     /**< edges accepted */
  std::size_t refused_overfull = 0; /**< rule 1: an edge would get a third triangle */
  std::size_t refused_tetrahedron = 0; /**< rule 2 */
  std::size_t refused_angle = 0;       /**< rule 3: an angle under A_T */
  std::size_t triangles = 0;
  double search_seconds = 0; /**< ordering, building the search index, k-NN */
  double greedy_seconds = 0; /**< certificates, ordering by length, insertion */
  bool cancelled = false;
};

} // namespace ccaa
} // namespace pcl
