// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a closed boundary of the reconstructed region A.
#include "boundary/boundary_loop.h"

namespace pcl {
namespace repair {

double
lengthOf(const BoundaryCurve& curve)
{
  double length = 0.0;
  for (std::size_t k = 0; k < curve.size(); ++k)
    length += curve.edge(k).norm();
  return length;
}

} // namespace repair
} // namespace pcl
