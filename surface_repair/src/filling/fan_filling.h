// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a hole closed by a fan around its centre (4.7).

#pragma once

#include "filling/filling_method.h"

namespace pcl::repair {

/** \brief The thesis' filling method (4.7): a fan around the geometrical centre of the
 * hole's boundary; a hole of three edges becomes one triangle.
 *
 * Right where the boundary is short, and convex in its mean plane. The one inner point
 * is a new one: free points, edges that exist and obstructions are not looked at. */
class FanFilling : public FillingMethod {
public:
  const char*
  name() const override
  {
    return "fan";
  }

  std::size_t
  simpleEdges() const override
  {
    return 12; // 4.7
  }

  Filling
  close(const FillingTask& task) const override;
};

} // namespace pcl::repair
