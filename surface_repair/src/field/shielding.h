// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether the surface stands between two points (E4.43-6).

#pragma once

#include "icadm/incomplete_model.h"
#include "run/run_control.h"

#include <memory>

namespace pcl::repair {

/** \brief The reconstructed region A as an obstacle. Built once; const methods may be
 * called from several threads. */
class Shield {
public:
  /** \brief Triangles without an area never stand in the way. Builds a tree: half a
   * microsecond a triangle. */
  explicit Shield(const IncompleteModel& model,
                  int threads = 1,
                  ccaa::RunControl* control = nullptr);
  ~Shield();

  /** \brief Whether the open segment from a to b crosses the surface. Crossings closer
   * than `tolerance` (units of the cloud) to either end do not count: this leaves out
   * the triangles that touch the end of a segment at a boundary,
   * and what the roughness of the surface puts in the way of a segment that ends on it.
   * Exact but for the place where the segment is cut off. Some 0.2 us. */
  bool
  crosses(const Position& a, const Position& b, double tolerance) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace pcl::repair
