// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges of the greedy start that wait for their level.
#pragma once

#include "greedy/block_schedule.h"
#include "greedy/candidate_edges.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief The edges of one task, by standing. */
struct EdgeQueue {
  std::array<std::vector<CandidateEdge>, 3> by_standing;

  void
  add(const CandidateEdge& edge, EdgeStanding standing)
  {
    by_standing[static_cast<std::size_t>(standing)].push_back(edge);
  }
};

/** \brief Edges that blocks have found and that groups of several blocks insert. Each
 * block has a list of its own, so that blocks may add at the same time. */
class WaitingEdges {
public:
  explicit WaitingEdges(const BlockSchedule& schedule) : blocks_(schedule.blockCount())
  {}

  void
  add(std::size_t block,
      const CandidateEdge& edge,
      unsigned int level,
      EdgeStanding standing)
  {
    blocks_[block].push_back({edge, level, standing});
  }

  /** \brief No more comes from a block: its edges are sorted by level. */
  void
  close(std::size_t block)
  {
    std::stable_sort(blocks_[block].begin(),
                     blocks_[block].end(),
                     [](const Entry& e, const Entry& f) { return e.level < f.level; });
  }

  /** \brief Hand over the edges that wait for a group of a level, block by block. */
  void
  collect(unsigned int level, std::size_t group, EdgeQueue& queue) const
  {
    const std::size_t last = std::min(blocks_.size(), (group + 1) << level);
    for (std::size_t block = group << level; block < last; ++block) {
      const std::vector<Entry>& entries = blocks_[block];
      auto next = std::lower_bound(
          entries.begin(), entries.end(), level, [](const Entry& e, unsigned int l) {
            return e.level < l;
          });
      for (; next != entries.end() && next->level == level; ++next)
        queue.add(next->edge, next->standing);
    }
  }

private:
  struct Entry {
    CandidateEdge edge;
    unsigned int level;
    EdgeStanding standing;
  };

  std::vector<std::vector<Entry>> blocks_;
};

} // namespace pcl::ccaa
