// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points that lie in lines, as the profiles of a scanner.
#pragma once

#include "greedy/ranked_points.h"

#include <functional>
#include <vector>

namespace pcl::ccaa {

/** \brief How far apart the lines lie that the points of a cloud were taken in. */
struct ScanLines {
  /** Median distance of the next line, in spacings along the line (see
   * GreedyParameters::length_factor); 0 where points do not lie in lines, or most in
   * lines see none on both sides of theirs. */
  double gap = 0.0;
  /** So many points in lines have neighbors of their own line alone that more neighbors
   * are needed. */
  bool is_blind = false;
};

/** \brief Whether the ten nearest neighbors of a point lie in a line with it. */
bool
isInLine(const RankedPoints& points, const NeighborRows& neighbors, index_t rank);

/** \brief Ask a thousand points, evenly spread over the ranks. */
ScanLines
findScanLines(const RankedPoints& points, const NeighborRows& neighbors);

/** \brief The same where neighbors, nearest first, are searched for those alone that
 * are asked. */
ScanLines
findScanLines(const RankedPoints& points,
              const std::function<std::vector<index_t>(index_t)>& neighborsOf);

/** \brief Longest edge of a point in a line, in local spacings; no less than the
 * factor that holds for others. */
double
reachInLines(const ScanLines& lines, double length_factor);

} // namespace pcl::ccaa
