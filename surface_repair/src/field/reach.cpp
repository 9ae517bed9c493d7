// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far the field has to reach, from the data (4.45).

#include <pcl/surface_repair/field/reach.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace repair {

double
GapFinder::gapAt(const Position& position, std::size_t silent_island) const
{
  double squared = std::numeric_limits<double>::infinity();
  for (const SourceCurve& curve : sources_.curves)
    if (curve.island != silent_island)
      for (const FieldSource& source : curve.sources)
        squared = std::min(squared, (source.position - position).squaredNorm());
  return std::sqrt(squared);
}

} // namespace repair
} // namespace pcl
