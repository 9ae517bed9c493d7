// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: moves the new vertices of a patch to a smooth surface.

#include "fairing/relaxation.h"

#include "fairing/fairing_system.h"
#include "fairing/free_point_pulls.h"
#include "fairing/joined_surface.h"
#include "fairing/rim_curvature.h"
#include "mesh/corners.h"

#include <algorithm>

namespace pcl::repair {

namespace {

/** Rings of the model that tell its curvature at the rim. */
constexpr std::size_t RINGS = 3;
/** Of the patch's size: what moves further is no surface any more. */
constexpr double LARGEST_MOVE = 3.0;
/** By so many times the longest edge of the patch may grow in a round: spikes do. */
constexpr double LARGEST_GROWTH = 4.0;

/** In mean edge lengths, mean square over the vertices: rounds that move less end it.
 * What settles at once, as on spheres, takes half the time of six rounds. */
constexpr double SETTLED = 0.05;
/** Operations of a round for each triangle besides its systems, of these those that
 * free points are attached in, and those before the first one. */
constexpr std::size_t ROUND_WORK = 100;
constexpr std::size_t ATTACHING_WORK = 50;
constexpr std::size_t JOINING_WORK = 50;
/** Rounds that are done in any case: the plate, and the first two with curvature. */
constexpr std::size_t FEWEST_ROUNDS = 3;

double
longestEdge(const JoinedSurface& surface, const Positions& positions)
{
  double longest = 0.0;
  for (std::size_t t = 0; t < surface.patch_triangles; ++t)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto a = static_cast<std::size_t>(surface.triangles[t][c]);
      const auto b = static_cast<std::size_t>(surface.triangles[t][(c + 1) % 3]);
      longest = std::max(longest, (positions[a] - positions[b]).norm());
    }
  return longest;
}

bool
isSane(const JoinedSurface& surface, const Positions& positions)
{
  for (std::size_t v = 0; v < positions.size(); ++v)
    if (!((positions[v] - surface.positions[v]).norm() < LARGEST_MOVE))
      return false;
  return !positions.empty() &&
         longestEdge(surface, positions) <=
             LARGEST_GROWTH * longestEdge(surface, surface.positions);
}

/** Whether a round has changed next to nothing. */
bool
isSettled(const JoinedSurface& surface, const Positions& positions)
{
  double moves = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v)
    moves += (positions[v] - surface.positions[v]).squaredNorm();
  const double edge =
      ccaa::meanEdge(surface.triangles, surface.patch_triangles, positions);
  return moves <
         SETTLED * SETTLED * edge * edge * static_cast<double>(positions.size());
}

std::vector<char>
fixedVertices(const JoinedSurface& surface, const Patch& patch)
{
  std::vector<char> fixed(surface.positions.size(), 1);
  for (std::size_t v = 0; v < surface.patch_vertices; ++v)
    fixed[v] = patch.isHeld(v) || surface.whole[v] == 0 ? 1 : 0;
  return fixed;
}

std::vector<char>
creasedVertices(const JoinedSurface& surface, const Patch& patch)
{
  std::vector<char> creased(surface.patch_vertices, 0);
  for (std::size_t v = 0; v < surface.patch_vertices; ++v)
    creased[v] = patch.isOnCrease(v) ? 1 : 0;
  return creased;
}

/** \return the largest move */
double
takeOver(const JoinedSurface& surface, const std::vector<char>& fixed, Patch& patch)
{
  double largest = 0.0;
  for (std::size_t v = 0; v < surface.patch_vertices; ++v) {
    if (fixed[v] != 0)
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
           Patch& patch,
           ccaa::RunControl* control,
           double noise)
{
  RelaxationReport report;
  JoinedSurface surface = joinSurface(model, patch, RINGS);
  ccaa::spend(control, JOINING_WORK * surface.triangles.size());
  FairingTask task;
  task.fixed = fixedVertices(surface, patch);
  task.hinges = creasedVertices(surface, patch);
  const std::vector<double> rim = rimCurvatures(surface, patch.rim.size());
  const FreePointPulls pulls(model, free_points, parameters, patch, surface, noise);
  ccaa::spend(control, JOINING_WORK * surface.triangles.size());
  SparseFactorisation solver;
  bool settled = false;
  for (std::size_t round = 0; round < parameters.rounds && !settled; ++round) {
    if (!ccaa::spend(control, ROUND_WORK * surface.triangles.size()))
      break;
    // The first surface is the thin plate, with normals to go on from.
    if (round > 0)
      task.curvatures = harmonicValues(surface, rim, control);
    if (round > 0 || noise > 0.0) { // what has grown is near its samples already
      task.pulls = pulls.attach(surface);
      ccaa::spend(control, ATTACHING_WORK * surface.triangles.size());
    }
    const Positions positions = fairPositions(surface, task, solver, control);
    if (!isSane(surface, positions))
      break;
    settled = round + 1 >= FEWEST_ROUNDS && isSettled(surface, positions);
    std::copy(positions.begin(), positions.end(), surface.positions.begin());
    report.solved = true;
    report.free_points = task.pulls.size();
  }
  if (report.solved)
    report.largest_move = takeOver(surface, task.fixed, patch);
  return report;
}

} // namespace pcl::repair
