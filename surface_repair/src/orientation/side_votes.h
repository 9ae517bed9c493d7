// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: votes for and against the winding of an island (4.48).

#pragma once

#include <cmath>

namespace pcl {
namespace repair {

/** \brief Weights that speak for and against the winding an island has. */
struct SideVotes {
  double keep = 0.0;
  double turn = 0.0;

  void
  add(double signed_weight)
  {
    (signed_weight > 0.0 ? keep : turn) += std::abs(signed_weight);
  }
  void
  add(const SideVotes& other)
  {
    keep += other.keep;
    turn += other.turn;
  }

  double
  total() const
  {
    return keep + turn;
  }
  /** \brief -1 (turn) to 1 (keep); 0 without votes. */
  double
  balance() const
  {
    return total() > 0.0 ? (keep - turn) / total() : 0.0;
  }
  /** \brief The votes had the island been wound the other way round. */
  SideVotes
  turned() const
  {
    return {turn, keep};
  }
};

} // namespace repair
} // namespace pcl
