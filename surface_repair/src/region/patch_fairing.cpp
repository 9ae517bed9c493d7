// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch refined and relaxed as far as it runs into nothing.

#include "region/patch_fairing.h"

#include "fairing/edge_collapse.h"
#include "fairing/flat_cap.h"
#include "fairing/refinement.h"
#include "fairing/relaxation.h"
#include "patch/patch_assembly.h"
#include "patch/relaxation_rollback.h"

#include <array>

namespace pcl::repair {

namespace {

/** Rings around what runs into something that go back, one try after the other. */
constexpr std::array<std::size_t, 4> CALMED_RINGS = {0, 2, 4, 8};
class Fairing {
public:
  Fairing(const ClosingPlace& place,
          const SurfaceObstacle& obstacle,
          const PatchFairing& how,
          const ccaa::LoopContext& context,
          Patch& patch)
  : place_(place), obstacle_(obstacle), how_(how), context_(context), patch_(patch)
  {}

  FairedPatch
  run()
  {
    const RepairParameters& parameters = place_.parameters;
    if (how_.keeps_shape || !parameters.refine) {
      findCollisions();
      if (!parameters.refine || !obstructed_.empty())
        return {std::move(obstructed_), !parameters.refine};
    }
    refinePatch(place_.model,
                parameters.refinement,
                patch_,
                how_.keeps_shape,
                context_.control);
    if (parameters.relax)
      relax();
    else
      findCollisions();
    if (obstructed_.empty() && !context_.cancelled())
      collapse();
    return {std::move(obstructed_), true};
  }

private:
  void
  relax();
  void
  findCollisions();
  void
  collapse();

  const ClosingPlace& place_;
  const SurfaceObstacle& obstacle_;
  const PatchFairing& how_;
  const ccaa::LoopContext& context_;
  Patch& patch_;
  std::vector<std::size_t> obstructed_; /**< triangles of the patch as it is */
};

void
Fairing::relax()
{
  const Positions before = patch_.positions;
  RelaxationParameters relaxation = place_.parameters.relaxation;
  relaxation.trust = place_.parameters.survey.field.trust;
  if (how_.is_flat)
    flattenPatch(place_.model, patch_, context_.control);
  else
    relaxPatch(place_.model,
               place_.model.free_points,
               relaxation,
               patch_,
               context_.control,
               how_.noise);
  findCollisions();
  for (const std::size_t rings : CALMED_RINGS) {
    if (obstructed_.empty() || context_.cancelled())
      return;
    rollBackRelaxation(before, obstructed_, rings, patch_);
    findCollisions();
  }
  if (!obstructed_.empty() && how_.keeps_shape) {
    patch_.positions = before;
    findCollisions();
  }
}

/** Unless it would run into something then. */
void
Fairing::collapse()
{
  const Patch before = patch_;
  if (collapseShortEdges(patch_) == 0)
    return;
  findCollisions();
  if (!obstructed_.empty()) {
    patch_ = before;
    obstructed_.clear();
  }
}

/** What the patch, as it would be written, runs into. */
void
Fairing::findCollisions()
{
  if (place_.frame.float_positions)
    roundToFloats(place_.frame.origin, patch_);
  obstructed_ = obstructedTriangles(patch_, obstacle_, context_.control);
}

} // namespace

FairedPatch
fairPatch(const ClosingPlace& place,
          const SurfaceObstacle& obstacle,
          const PatchFairing& how,
          const ccaa::LoopContext& context,
          Patch& patch)
{
  return Fairing(place, obstacle, how, context, patch).run();
}

} // namespace pcl::repair
