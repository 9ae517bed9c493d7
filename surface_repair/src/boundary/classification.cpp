// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: telling holes from rims and the outer border (4.1).
#include "boundary/classification.h"

#include "boundary/facing_search.h"
#include "boundary/loop_evidence.h"
#include "mesh/corners.h"

#include <cmath>

namespace pcl::repair {

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

/** A body with a third of its surface lost on one side. */
constexpr double BODY_FACING = 0.35;

} // namespace

double
facingOf(const IncompleteModel& model)
{
  return facingOf(model, model.triangles.size());
}

double
facingOf(const IncompleteModel& model, std::size_t triangles)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0.0;
  for (std::size_t t = 0; t < triangles; ++t) {
    const Eigen::Vector3d normal =
        ccaa::areaNormal(ccaa::cornersOf(model.triangles[t], model.positions));
    sum += normal;
    area += normal.norm();
  }
  return area > 0.0 ? sum.norm() / area : 0.0;
}

bool
isSeenFromAllSides(double facing)
{
  return facing < BODY_FACING;
}

namespace {

/** Loops are long or short; few of them make a block. */
constexpr std::size_t BLOCK_LOOPS = 8;

BoundaryClass
decide(const LoopClass& loop,
       bool is_of_body,
       const ClassificationParameters& parameters)
{
  const double score = loop.evidence.score();
  if (loop.confidence < parameters.decided_from || score == 0.0)
    return BoundaryClass::UNDECIDED;
  if (score > 0.0)
    return BoundaryClass::HOLE;
  return is_of_body || loop.faced >= parameters.faced_from
             ? BoundaryClass::ISLAND_RIM
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
  const bool are_of_body =
      model.islands.size() > 1 && isSeenFromAllSides(facingOf(model));
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
      result.boundary_class = decide(result, are_of_body, parameters);
    }
  };
  return ccaa::forEachBlock(loops.size(), by_loop, classify) ? classes
                                                             : std::vector<LoopClass>();
}

} // namespace pcl::repair
