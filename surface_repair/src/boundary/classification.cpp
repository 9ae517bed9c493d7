// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: telling holes from rims and the outer border (4.1).
#include <pcl/surface_repair/boundary/classification.h>

#include "facing_search.h"
#include "loop_evidence.h"

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
  const std::vector<LoopEvidence> evidence = collectEvidence(model, loops);
  const FacingSearch facing(loops);
  std::vector<LoopClass> classes(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    LoopClass& result = classes[i];
    result.evidence = evidence[i];
    if (model.islands[loops[i].island].one_sided)
      continue;
    const double score = evidence[i].score();
    result.confidence = std::tanh(0.5 * std::abs(score));
    if (score < 0.0)
      result.faced = facing.facedShare(i);
    if (result.confidence < parameters.decided_from || score == 0.0)
      continue;
    if (score > 0.0)
      result.boundary_class = BoundaryClass::HOLE;
    else
      result.boundary_class = result.faced >= parameters.faced_from
                                  ? BoundaryClass::ISLAND_RIM
                                  : BoundaryClass::OUTER_BORDER;
  }
  return classes;
}

} // namespace repair
} // namespace pcl
