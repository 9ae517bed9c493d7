// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a hole closed by the base algorithm with its free points.

#pragma once

#include "filling/filling_method.h"

namespace pcl::repair {

/** \brief The base algorithm of surface_ccaa (thesis 3.5) on the free points in a hole,
 * which become inner vertices where it takes them; what it leaves open is closed by
 * MinimumWeightFilling.
 *
 * The surroundings are a collar of triangles that continues the surface outwards from
 * the polygon by its normals. A free point far from all others, or at which the new
 * surface would be a spike, does not become a vertex. Without usable free points it is
 * MinimumWeightFilling. Cost: some 20 us a point, then see there. */
class CompletionFilling : public FillingMethod {
public:
  const char*
  name() const override
  {
    return "completion";
  }

  std::size_t
  simpleEdges() const override
  {
    return 400;
  }

  Filling
  close(const FillingTask& task) const override;
};

} // namespace pcl::repair
