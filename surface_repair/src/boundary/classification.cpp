// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: telling holes from rims and the outer border (4.1).
#include <pcl/surface_repair/boundary/classification.h>

#include <cmath>

namespace pcl {
namespace repair {

const char*
describe(BoundaryClass boundary_class)
{
  switch (boundary_class) {
  case BoundaryClass::HOLE:
    return "hole";
  case BoundaryClass::ISLAND_RIM:
    return "island rim";
  case BoundaryClass::OUTER_BORDER:
    return "outer border";
  case BoundaryClass::UNDECIDED:
    break;
  }
  return "undecided";
}

std::vector<LoopClass>
classifyBoundaries(const IncompleteModel& model,
                   const BoundaryLoops& loops,
                   const ClassificationParameters& parameters)
{
  std::vector<LoopClass> classes(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    LoopClass& result = classes[i];
    result.integral = boundaryIntegral(loops[i].curve);
    result.confidence = std::abs(result.integral.relative());
    if (model.islands[loops[i].island].one_sided ||
        result.confidence <= parameters.decided_from)
      continue;
    result.boundary_class = result.integral.value > 0.0 ? BoundaryClass::HOLE // D4.1-1
                                                        : BoundaryClass::ISLAND_RIM;
  }
  return classes;
}

} // namespace repair
} // namespace pcl
