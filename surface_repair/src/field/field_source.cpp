// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the elementary sources of the indicator field (4.43, 4.46).
#include "field/field_source.h"

namespace pcl::repair {

std::size_t
SourceSet::size() const
{
  std::size_t count = 0;
  for (const SourceCurve& curve : curves)
    count += curve.sources.size();
  return count;
}

} // namespace pcl::repair
