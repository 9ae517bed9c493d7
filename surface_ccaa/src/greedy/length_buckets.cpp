// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges in the order of their lengths, in linear time.
#include "greedy/length_buckets.h"

#include <algorithm>

namespace pcl::ccaa {

void
LengthBuckets::sort(std::vector<CandidateEdge>& edges)
{
  if (edges.size() < 2)
    return;
  float shortest = edges.front().length, longest = shortest;
  for (const CandidateEdge& edge : edges) {
    shortest = std::min(shortest, edge.length);
    longest = std::max(longest, edge.length);
  }
  const float range = longest - shortest;
  const float cells_per_unit = range > 0 ? static_cast<float>(CELLS) / range : 0.0f;
  const auto cell = [&](const CandidateEdge& edge) {
    const float place = (edge.length - shortest) * cells_per_unit;
    // Written so that an overflowing or undefined product lands in the last cell.
    return place < static_cast<float>(CELLS) ? static_cast<std::size_t>(place)
                                             : CELLS - 1;
  };
  starts_.assign(CELLS + 1, 0);
  for (const CandidateEdge& edge : edges)
    ++starts_[cell(edge) + 1];
  for (std::size_t c = 0; c < CELLS; ++c)
    starts_[c + 1] += starts_[c];
  sorted_.resize(edges.size());
  for (const CandidateEdge& edge : edges)
    sorted_[starts_[cell(edge)]++] = edge;
  edges.swap(sorted_);
}

} // namespace pcl::ccaa
