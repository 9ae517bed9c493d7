// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: telling holes from rims and the outer border (4.1).
#include "boundary/classification.h"

#include "boundary/facing_search.h"
#include "boundary/loop_evidence.h"

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

namespace {

/** Loops are long or short; few of them make a block. */
constexpr std::size_t BLOCK_LOOPS = 8;

BoundaryClass
decide(const LoopClass& loop, const ClassificationParameters& parameters)
{
  const double score = loop.evidence.score();
  if (loop.confidence < parameters.decided_from || score == 0.0)
    return BoundaryClass::UNDECIDED;
  if (score > 0.0)
    return BoundaryClass::HOLE;
  return loop.faced >= parameters.faced_from ? BoundaryClass::ISLAND_RIM
                                             : BoundaryClass::OUTER_BORDER;
}

} // namespace

std::vector<LoopClass>
classifyBoundaries(const IncompleteModel& model,
                   const BoundaryLoops& loops,
                   const ClassificationParameters& parameters,
                   const ccaa::LoopContext& context)
{
  ccaa::LoopContext by_loop = context;
  by_loop.block_size = BLOCK_LOOPS;
  const std::vector<LoopEvidence> evidence = collectEvidence(model, loops, by_loop);
  if (context.cancelled())
    return {};
  const FacingSearch facing(loops);
  std::vector<LoopClass> classes(loops.size());
  const auto classify = [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      LoopClass& result = classes[i];
      result.evidence = evidence[i];
      if (model.islands[loops[i].island].one_sided)
        continue;
      const double score = evidence[i].score();
      result.confidence = std::tanh(0.5 * std::abs(score));
      if (score < 0.0)
        result.faced = facing.facedShare(i);
      result.boundary_class = decide(result, parameters);
    }
  };
  return ccaa::forEachBlock(loops.size(), by_loop, classify) ? classes
                                                             : std::vector<LoopClass>();
}

} // namespace repair
} // namespace pcl
