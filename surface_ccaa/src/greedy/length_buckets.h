// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges in the order of their lengths, in linear time.
#pragma once

#include <pcl/types.h>

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief An edge that may join two points. */
struct CandidateEdge {
  index_t a = 0; /**< rank */
  index_t b = 0; /**< rank */
  float length = 0;
};

/** \brief The one-dimensional grid of thesis 3.3: edges are put into some 1000 cells of
 * equal width by length, a counting sort. Within a cell they keep the order in which
 * they came, so the result is determined. Keeps its memory from call to call. */
class LengthBuckets {
public:
  /** \brief Cells of the grid, "about 1000". */
  static constexpr std::size_t CELLS = 1024;

  /** \brief Order the edges by length, shortest cell first. Lengths are finite and not
   * negative. Cost linear in their number. */
  void
  sort(std::vector<CandidateEdge>& edges);

private:
  std::vector<CandidateEdge> sorted_;
  std::vector<std::size_t> starts_;
};

} // namespace pcl::ccaa
