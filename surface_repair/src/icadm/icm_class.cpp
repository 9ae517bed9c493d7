// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the classes of incomplete models (D4.1-4).
#include "icadm/icm_class.h"

namespace pcl::repair {

IcmClass
classOf(const IcmCounts& counts)
{
  if (counts.islands > 1)
    return IcmClass::ICM3;
  return counts.complex_holes > 0 ? IcmClass::ICM2 : IcmClass::ICM1;
}

IcmCounts
countHoles(std::size_t islands,
           const std::vector<std::size_t>& hole_edges,
           std::size_t simple_edges)
{
  IcmCounts counts;
  counts.islands = islands;
  for (const std::size_t edges : hole_edges)
    ++(edges <= simple_edges ? counts.simple_holes : counts.complex_holes);
  return counts;
}

} // namespace pcl::repair
