// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: votes for and against the winding of a surface (4.48).
#pragma once

#include <cmath>

namespace pcl::ccaa {

/** \brief Weighted votes for (positive) and against the winding a surface has. */
struct SideVotes {
  double sum = 0.0;
  double total = 0.0;

  /** \brief Count a vote; one that is not finite says nothing. */
  void
  add(double vote)
  {
    if (!std::isfinite(vote))
      return;
    sum += vote;
    total += std::abs(vote);
  }

  /** \brief Add those of another surface. \param[in] weight of each of them; negative:
   * it is wound the other way round */
  void
  add(const SideVotes& other, double weight = 1.0)
  {
    sum += weight * other.sum;
    total += std::abs(weight) * other.total;
  }

  /** \brief -1 (turn) to 1 (keep); 0 without votes. */
  double
  balance() const
  {
    return total > 0.0 ? sum / total : 0.0;
  }

  /** \brief How clear the result is, 0 to 1. */
  double
  margin() const
  {
    return std::abs(balance());
  }
};

} // namespace pcl::ccaa
