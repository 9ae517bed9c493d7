// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: lengths as users give them.

#pragma once

namespace pcl {
namespace repair {

/** \brief A limit in units of the cloud, or as a share of the diagonal of the bounding
 * box of all triangles. */
struct Extent {
  Extent() = default;
  /** \param[in] limit at least 0; 0: no limit
   * \param[in] in_diagonals 0.05 is 5 % of the diagonal; else units of the cloud */
  Extent(double limit, bool in_diagonals = false)
  : value(limit), of_diagonal(in_diagonals)
  {}

  bool
  limits() const
  {
    return value > 0.0;
  }
  /** \brief In units of the cloud. */
  double
  length(double diagonal) const
  {
    return of_diagonal ? value * diagonal : value;
  }

  double value = 0.0;
  bool of_diagonal = false;
};

} // namespace repair
} // namespace pcl
