// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points with brute-force neighbor rows, for tests of
// greedy/.
#pragma once

#include "greedy/ranked_points.h"
#include "mesh/triangle.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::ccaa::test {

/** \brief Points in the order given, each with its k nearest neighbors. */
class RankedCloud {
public:
  RankedCloud(const Positions& positions, unsigned int k) : k_(k)
  {
    for (const Position& p : positions) {
      points_.point_indices.push_back(
          static_cast<index_t>(points_.point_indices.size()));
      points_.coordinates.push_back({float(p.x()), float(p.y()), float(p.z())});
    }
    for (const Position& p : positions)
      appendRow(positions, p);
  }

  const RankedPoints&
  points() const
  {
    return points_;
  }

  NeighborRows
  rows() const
  {
    return {rows_.data(), k_};
  }

private:
  void
  appendRow(const Positions& positions, const Position& centre)
  {
    std::vector<std::pair<double, index_t>> others;
    for (std::size_t j = 0; j < positions.size(); ++j)
      if (&positions[j] != &centre)
        others.emplace_back((positions[j] - centre).squaredNorm(), index_t(j));
    std::sort(others.begin(), others.end());
    for (std::size_t slot = 0; slot < k_; ++slot)
      rows_.push_back(slot < others.size() ? others[slot].second : NeighborRows::NONE);
  }

  unsigned int k_;
  RankedPoints points_;
  std::vector<index_t> rows_;
};

} // namespace pcl::ccaa::test
