// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: moves the new vertices of a patch to a smooth surface.

#include <pcl/surface_repair/fairing/relaxation.h>

#include "fairing_system.h"
#include "free_point_pulls.h"
#include "joined_surface.h"
#include "rim_curvature.h"

#include <algorithm>

namespace pcl {
namespace repair {

namespace {

/** Rings of the model that tell its curvature at the rim. */
constexpr std::size_t RINGS = 3;
/** Of the patch's size: what moves further is no surface any more. */
constexpr double LARGEST_MOVE = 3.0;

bool
isSane(const JoinedSurface& surface, const Positions& positions)
{
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (!((positions[v] - surface.positions[v]).norm() < LARGEST_MOVE))
      return false;
  return !positions.empty();
}

std::vector<char>
fixedVertices(const JoinedSurface& surface, const Patch& patch)
{
  std::vector<char> fixed(surface.positions.size(), 1);
  for (std::size_t v = 0; v < surface.patch_vertices; ++v)
    fixed[v] = patch.isHeld(v) ? 1 : 0;
  return fixed;
}

/** \return the largest move */
double
takeOver(const JoinedSurface& surface, Patch& patch)
{
  double largest = 0.0;
  for (std::size_t v = 0; v < surface.patch_vertices; ++v) {
    if (patch.isHeld(v))
      continue;
    const Position place = surface.size * surface.positions[v] + surface.centre;
    largest = std::max(largest, (place - patch.positions[v]).norm());
    patch.positions[v] = place;
  }
  return largest;
}

} // namespace

RelaxationReport
relaxPatch(const IncompleteModel& model,
           const Positions& free_points,
           const RelaxationParameters& parameters,
           Patch& patch)
{
  RelaxationReport report;
  JoinedSurface surface = joinSurface(model, patch, RINGS);
  FairingTask task;
  task.fixed = fixedVertices(surface, patch);
  const std::vector<double> rim = rimCurvatures(surface, patch.rim.size());
  const FreePointPulls pulls(model, free_points, parameters, surface);
  for (std::size_t round = 0; round < parameters.rounds; ++round) {
    if (round > 0) { // the first surface is the thin plate, with normals to go on from
      task.curvatures = harmonicValues(surface, rim);
      task.pulls = pulls.attach(surface);
    }
    const Positions positions = fairPositions(surface, task);
    if (!isSane(surface, positions))
      break;
    std::copy(positions.begin(), positions.end(), surface.positions.begin());
    report.solved = true;
    report.free_points = task.pulls.size();
  }
  if (report.solved)
    report.largest_move = takeOver(surface, patch);
  return report;
}

} // namespace repair
} // namespace pcl
