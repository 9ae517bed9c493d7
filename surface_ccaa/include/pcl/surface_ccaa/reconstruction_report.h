// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the algorithms that reconstruct did and what it cost.
#pragma once

#include <pcl/surface_ccaa/side_settings.h>
#include <pcl/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
/** \brief Where no sampling tells the topology of a result. */
struct TopologyDoubts {
  /** \brief Handles of which some may be tunnels that nobody scanned, since the surface
   * has places so thin that their two sides cannot be told apart, or handles within
   * four edges of a vertex or through clefts, where it faces itself across hardly any
   * space. */
  std::uint64_t handles = 0;
  /** \brief A point at each of these places that a handle passes through, ascending:
   * they may be fewer than the handles, as one may have several, or none. */
  std::vector<index_t> thin_handles;
  /** \brief Where a closed piece comes nearer to another piece than its points lie
   * apart, or the end of a stem to another end, so that they may be one body, of which
   * a thin neck was cut: a point of each, by the first. */
  std::vector<std::array<index_t, 2>> touching_pieces;
  /** \brief A point on each ring of a few edges, and at each cleft around a rim, from
   * which the surface widens to both sides, so that it may be two bodies; ascending. */
  std::vector<index_t> thin_necks;
};

namespace ccaa {

/** \brief What one run of the greedy start did. Times are wall-clock seconds. */
struct GreedyReport {
  std::size_t points = 0; /**< usable points: finite, selected, places counted once */
  std::size_t skipped_points =
      0; /**< selected points with a NaN or infinite coordinate */
  std::size_t duplicate_points = 0; /**< further points at a place that is taken */
  double line_gap = 0; /**< where points lie in lines: how far the next line is, in
                            spacings along it; else 0 */
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

/** \brief What one run of the base algorithm did. */
struct CompletionReport {
  std::size_t given_triangles = 0;
  std::size_t kept_triangles = 0; /**< given ones in the result */
  std::size_t new_triangles = 0;
  std::size_t open_points = 0; /**< boundary points and free points before */
  std::size_t free_points = 0; /**< points without a triangle after */
  TopologyDoubts doubts;       /**< about the result */
  SideTally sides;             /**< what told the outer side of the result */
  double seconds = 0;
  bool cancelled = false;
};

} // namespace ccaa

/** \brief One algorithm of a chain. Times are wall-clock seconds. */
struct ChainStageReport {
  std::string name;   /**< "start", "start 2", ..., "base" */
  double seconds = 0; /**< of the algorithm itself */
  double filter_seconds =
      0; /**< of the filter run after it; 0 for the base algorithm */
  std::size_t triangles = 0;       /**< of the result that it made */
  std::size_t internal_points = 0; /**< with a closed umbrella, after its filter run */
  bool kept = true; /**< false: dropped, because internal points became fewer, or not
                         run, because fewer than three points were left to it */
};

/** \brief What one run of ConsecutiveReconstruction did. */
struct ConsecutiveReport {
  std::size_t points = 0;         /**< N: the points selected, repeated ones as often */
  std::size_t skipped_points = 0; /**< of these with a NaN or infinite coordinate */
  std::size_t connected_points = 0;     /**< with triangles after the last filter run */
  std::size_t internal_points = 0;      /**< with a closed umbrella after it */
  std::size_t free_points = 0;          /**< without a triangle in the result */
  TopologyDoubts doubts;                /**< of the base algorithm */
  std::size_t invalid_polygons = 0;     /**< given by start algorithms, left out */
  std::vector<ChainStageReport> stages; /**< one an algorithm; its place is the label of
                                             its triangles */
  double start_seconds = 0;             /**< of all start algorithms */
  double filter_seconds = 0;            /**< of all filter runs */
  double base_seconds = 0;              /**< of the base algorithm */
  double normals_seconds = 0;           /**< only when asked for */
  double total_seconds = 0; /**< of all this, and of what joins it; normals not in it */
  bool cancelled = false;

  /** \brief k of E3.1-2: share of the points that have triangles after the filter. */
  double
  connectedShare() const
  {
    return share(connected_points);
  }

  /** \brief The stricter share: points inside of a surface after the filter. */
  double
  internalShare() const
  {
    return share(internal_points);
  }

  /** \brief c_B of E3.1-2, in seconds a point. */
  double
  startCost() const
  {
    return perPoint(start_seconds, points);
  }

  /** \brief c_F of E3.1-2, in seconds a point. */
  double
  filterCost() const
  {
    return perPoint(filter_seconds, points);
  }

  /** \brief Seconds of the base algorithm for each point that the filter left open,
   * that is free or at a boundary: c_A as this run shows it. The c_A of E3.1-1, of the
   * base algorithm alone, takes a run of its own: see measureSpeedup(). */
  double
  baseCost() const
  {
    return perPoint(base_seconds, points - internal_points);
  }

private:
  double
  share(std::size_t count) const
  {
    return perPoint(static_cast<double>(count), points);
  }

  static double
  perPoint(double amount, std::size_t count)
  {
    return count == 0 ? 0.0 : amount / static_cast<double>(count);
  }
};

/** \brief Whether the chain pays: the figures of thesis 3.1 for one cloud. */
struct SpeedupReport {
  std::size_t points = 0;       /**< N */
  double base_seconds = 0;      /**< t_A: the base algorithm alone */
  double chain_seconds = 0;     /**< t_BA: the whole chain */
  double speedup = 0;           /**< S = t_A / t_BA; 0 when there is no result */
  double base_cost = 0;         /**< c_A = t_A / N (E3.1-1), in seconds a point */
  double start_cost = 0;        /**< c_B (E3.1-2), in seconds a point */
  double filter_cost = 0;       /**< c_F (E3.1-2), in seconds a point */
  double connected_share = 0;   /**< k */
  bool is_advantageous = false; /**< C3.1-1: k c_A > c_B + c_F (EC3.1-1) */
  bool cancelled = false;
};

} // namespace pcl
