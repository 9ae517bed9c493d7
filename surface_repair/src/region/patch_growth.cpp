// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the coarse patch of a region grows over its samples.

#include "region/patch_growth.h"

#include "fairing/crossing_flips.h"
#include "fairing/sample_growth.h"
#include "fairing/sample_noise.h"
#include "fairing/triangle_search.h"
#include "mesh/corners.h"
#include "region/patch_mending.h"
#include "region/sample_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl::repair {

namespace {

/** Noise of samples that are held with a trust of one half, in edges of the patch: more
 * has detail of exact ones nowhere in 32 damaged models (0.27 at most). */
constexpr double HELD_NOISE = 0.28;
/** Root mean square distance of samples from what they have drawn, in their noise, at
 * most: 0.5 to 1 where it is the surface, up to 2.2 where a limb has shrunk. */
constexpr double MOST_APART = 1.25;
/** Tries to draw a patch, each with half the noise of the one before. */
constexpr std::size_t DRAWING_TRIES = 4;

/** Root mean square distance of samples from a patch. */
double
distanceOf(const std::vector<std::size_t>& samples,
           const Positions& free_points,
           const Patch& patch)
{
  const TriangleSearch surface(ccaa::cornersOf(patch.triangles, patch.positions));
  double sum = 0.0;
  for (const std::size_t sample : samples) {
    const double distance =
        surface.nearest(free_points[sample], std::numeric_limits<double>::max())
            .distance;
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

} // namespace

bool
growPatch(const ClosingPlace& place,
          const std::vector<std::size_t>& samples,
          const SurfaceObstacle& obstacle,
          const ccaa::LoopContext& context,
          Patch& patch)
{
  const auto is_obstructed = [&](const ccaa::Corners& corners) {
    return obstacle.meets(corners, context.control);
  };
  std::vector<std::size_t> crossing;
  if (place.mends && patch.creases.empty()) // which mending does not know
    crossing = obstructedTriangles(patch, obstacle, context.control);
  // A patch with a handle is wrong as a whole.
  if (!crossing.empty() && surfaceKindOf(patch).genus == 0) {
    flipCrossings(
        place.model, std::move(crossing), is_obstructed, patch, context.control);
    mendPatch(place, obstacle, context, patch);
  }
  growOver(place.model, samples, is_obstructed, patch, context.control);
  return samplesDescribe(place.model.free_points, samples, patch);
}

FairedPatch
fairGrown(const ClosingPlace& place,
          const std::vector<std::size_t>& samples,
          const SurfaceObstacle& obstacle,
          PatchFairing how,
          const ccaa::LoopContext& context,
          Patch& patch)
{
  const SampleNoise noise =
      place.parameters.relax ? noiseOfSamples(patch) : SampleNoise();
  const double trust = place.parameters.survey.field.trust;
  const double belief = std::sqrt(trust / (1.0 - trust)); // squares of noise weigh
  const std::size_t tries = noise.share > HELD_NOISE * belief ? DRAWING_TRIES : 0;
  how.noise = noise.deviation;
  for (std::size_t i = 0; i < tries; ++i, how.noise *= 0.5) {
    Patch drawn = patch;
    std::fill(drawn.free_point.begin(), drawn.free_point.end(), NONE);
    FairedPatch faired = fairPatch(place, obstacle, how, context, drawn);
    if (!faired.is_faired || !faired.obstructed.empty() || context.cancelled())
      break;
    if (distanceOf(samples, place.model.free_points, drawn) >
        MOST_APART * noise.deviation)
      continue;
    patch = std::move(drawn);
    return faired;
  }
  how.noise = 0.0;
  return fairPatch(place, obstacle, how, context, patch);
}

} // namespace pcl::repair
