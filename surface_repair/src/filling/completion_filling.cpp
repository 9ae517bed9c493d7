// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a hole closed by the base algorithm with its free points.

#include "filling/completion_filling.h"

#include "filling/collared_completion.h"
#include "filling/disc_check.h"
#include "filling/minimum_weight_filling.h"
#include "filling/partial_filling.h"
#include "filling/sample_choice.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

namespace pcl::repair {

namespace {

/** How often triangles are taken away again to get rid of spikes, or to make room where
 * the rest cannot be closed. */
constexpr std::size_t ROUNDS = 8;

/** Operations of a round for each triangle: maps of edges and vertices. */
constexpr std::uint64_t ROUND_WORK = 100;

/** How often it is tried, each time with half of the samples: where noise is as large
 * as their spacing, fewer show the surface better. */
constexpr std::size_t THINNINGS = 4;

/** Corners of triangles: below the polygon's size its points, then the samples. */
using Corner = pcl::index_t;

/** Whether a triangle of the base algorithm may be kept at all. */
bool
isAllowed(const Triangle& triangle, const FillingTask& task, const Positions& points)
{
  const std::size_t n = task.polygon.size();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto a = static_cast<std::size_t>(triangle[i]);
    const auto b = static_cast<std::size_t>(triangle[(i + 1) % 3]);
    const bool neighbours =
        a < n && b < n && (task.polygon.next(a) == b || task.polygon.next(b) == a);
    if (a < n && b < n && !neighbours && task.joined && task.joined(a, b))
      return false;
  }
  return !task.obstructed || !task.obstructed(ccaa::cornersOf(triangle, points));
}

/** Close what is open by least weight. \param[out] stuck vertices of the loops that
 * cannot be closed */
Triangles
finished(const PartialFilling& partial, std::set<Corner>& stuck)
{
  Triangles all = partial.triangles();
  for (const std::vector<Corner>& loop : partial.openLoops()) {
    const Filling rest = MinimumWeightFilling().close(partial.taskFor(loop));
    if (!rest.closed())
      stuck.insert(loop.begin(), loop.end());
    for (Triangle triangle : rest.triangles) {
      for (Corner& corner : triangle)
        corner = loop[static_cast<std::size_t>(corner)];
      all.push_back(triangle);
    }
  }
  return all;
}

Triangles
withoutThoseAt(const std::set<Corner>& corners, Triangles triangles)
{
  const auto touches = [&](const Triangle& t) {
    return std::any_of(
        t.begin(), t.end(), [&](Corner corner) { return corners.count(corner) > 0; });
  };
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(), touches),
                  triangles.end());
  return triangles;
}

/** The filling of some triangles: inner points are the samples that they use. */
Filling
fillingOf(Triangles triangles,
          const FillingTask& task,
          const std::vector<std::size_t>& samples)
{
  Filling filling;
  const std::size_t n = task.polygon.size();
  std::vector<pcl::index_t> number(samples.size(), -1);
  for (Triangle& triangle : triangles)
    for (pcl::index_t& corner : triangle) {
      if (static_cast<std::size_t>(corner) < n)
        continue;
      const std::size_t sample = static_cast<std::size_t>(corner) - n;
      if (number[sample] < 0) {
        number[sample] = static_cast<pcl::index_t>(n + filling.inner.size());
        filling.inner.push_back(task.free_points[samples[sample]]);
        filling.free_point.push_back(samples[sample]);
      }
      corner = number[sample];
    }
  filling.triangles = std::move(triangles);
  return filling;
}

Triangles
allowedTriangles(const FillingTask& task,
                 const std::vector<std::size_t>& samples,
                 const Positions& points)
{
  Triangles inside = completeWithin(task, samples);
  inside.erase(
      std::remove_if(inside.begin(),
                     inside.end(),
                     [&](const Triangle& t) { return !isAllowed(t, task, points); }),
      inside.end());
  return inside;
}

/** With a problem when it comes to nothing. */
Filling
closeWith(const FillingTask& task, const std::vector<std::size_t>& samples)
{
  Filling failed;
  failed.problem = "the free points do not lead to a disc";
  const std::size_t n = task.polygon.size();
  Positions points = task.polygon.points;
  for (const std::size_t i : samples)
    points.push_back(task.free_points[i]);
  Triangles triangles = allowedTriangles(task, samples, points);
  for (std::size_t round = 0; round < ROUNDS && !triangles.empty(); ++round) {
    if (!ccaa::spend(task.control, ROUND_WORK * (triangles.size() + n)))
      return failed;
    const PartialFilling partial(task, triangles, points);
    std::set<Corner> bad;
    triangles = finished(partial, bad);
    if (bad.empty()) {
      Filling filling = fillingOf(triangles, task, samples);
      if (!isDisc(filling, n))
        return failed;
      bad = spikesOf(triangles, points, n);
      if (bad.empty())
        return filling;
    }
    triangles = withoutThoseAt(bad, std::move(triangles));
  }
  return failed;
}

std::vector<std::size_t>
everySecond(const std::vector<std::size_t>& samples)
{
  std::vector<std::size_t> second;
  for (std::size_t i = 0; i < samples.size(); i += 2)
    second.push_back(samples[i]);
  return samples.size() > 1 ? second : std::vector<std::size_t>{};
}

} // namespace

Filling
CompletionFilling::close(const FillingTask& task) const
{
  std::vector<std::size_t> samples;
  if (task.polygon.size() >= 3)
    samples = usableSamples(task);
  for (std::size_t i = 0; i < THINNINGS && !samples.empty(); ++i) {
    Filling filling = closeWith(task, samples);
    if (filling.closed())
      return filling;
    samples = everySecond(samples);
  }
  return MinimumWeightFilling().close(task);
}

} // namespace pcl::repair
