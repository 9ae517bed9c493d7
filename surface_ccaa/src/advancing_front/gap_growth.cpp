// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the gaps of a surface, and how it grows into them.
#include "advancing_front/gap_growth.h"

#include "advancing_front/loop_closure.h"
#include "advancing_front/open_regions.h"
#include "advancing_front/scattered_points.h"
#include "advancing_front/spacing.h"
#include "advancing_front/surface_growth.h"
#include "advancing_front/tuning.h"
#include "mesh/sort_unique.h"

#include <utility>

namespace pcl::ccaa {
namespace {

/** What grew in one region, in vertices of the gap. */
struct Grown {
  Triangles triangles;
  std::vector<pcl::index_t> obstructed;
};

Grown
growRegion(const OpenSurface& region,
           const std::vector<pcl::index_t>& vertices,
           const NearbyTriangles& nearby,
           const CompletionParameters& parameters,
           RunControl* control)
{
  SurfaceGrowth growth(region, parameters, &nearby);
  growth.run(control);
  Grown grown;
  const Triangles& triangles = growth.surface().triangles();
  const auto rim = static_cast<std::ptrdiff_t>(region.rim.size());
  grown.triangles = inTheWhole({triangles.begin() + rim, triangles.end()}, vertices);
  for (const pcl::index_t point : growth.obstructedPoints())
    grown.obstructed.push_back(vertices[static_cast<std::size_t>(point)]);
  return grown;
}

std::vector<Grown>
growRegions(const OpenSurface& gap,
            const NearbyTriangles& nearby,
            const CompletionParameters& parameters,
            LoopContext context)
{
  const auto regions = openRegions(gap, 2.0 * parameters.support);
  const auto rims = rimOfRegions(gap, regions);
  std::vector<Grown> grown(regions.size());
  context.block_size = 1;
  if (gap.open_points < tuning::SMALL_GAP)
    context.threads = 1;
  forEachBlock(regions.size(), context, [&](std::size_t i, std::size_t, std::size_t) {
    std::vector<pcl::index_t> vertices;
    const OpenSurface region =
        regionOf(gap, regions[i], rims[i], vertices, context.control);
    grown[i] = growRegion(region, vertices, nearby, parameters, context.control);
  });
  return grown;
}

} // namespace

Gap
openGap(PartialSurface& surface,
        std::vector<pcl::index_t> open,
        std::vector<pcl::index_t> table,
        double usual_spacing,
        unsigned int k,
        const NeighborSearch& search,
        RunControl* control)
{
  Gap gap;
  gap.open = std::move(open);
  for (int round = 0;; ++round) {
    gap.surface = surface.openAt(gap.open, {}, gap.vertices, control);
    if (isCancelled(control))
      return gap;
    gap.surface.neighbor_table = std::move(table);
    gap.surface.neighbors = {gap.surface.neighbor_table.data(), k};
    if (round == tuning::SCATTER_ROUNDS)
      break;
    const std::vector<std::uint8_t> scattered =
        findScatteredPoints(gap.surface, usual_spacing);
    std::vector<pcl::index_t> remaining;
    for (std::size_t i = 0; i < gap.open.size(); ++i)
      if (scattered[i] == 0)
        remaining.push_back(gap.open[i]);
    if (remaining.size() == gap.open.size())
      break;
    gap.open = std::move(remaining);
    table.clear();
    if (!search(gap.open, k, table))
      return gap;
  }
  for (std::size_t i = 0; i < gap.open.size(); ++i)
    if (gap.surface.spacings[i] <= 0.0)
      surface.noteSpacing(
          gap.open[i], spacingFromNeighbors(gap.surface, static_cast<pcl::index_t>(i)));
  completeSpacings(gap.surface);
  return gap;
}

std::vector<pcl::index_t>
growInto(const Gap& gap,
         const NearbyTriangles& nearby,
         const CompletionParameters& parameters,
         const ComponentRule& rule,
         const LoopContext& context,
         PartialSurface& surface)
{
  const std::vector<Grown> grown =
      growRegions(gap.surface, nearby, parameters, context);
  if (context.cancelled())
    return {};
  Triangles all = gap.surface.rim;
  std::vector<pcl::index_t> obstructed;
  for (const Grown& region : grown) {
    all.insert(all.end(), region.triangles.begin(), region.triangles.end());
    for (const pcl::index_t point : region.obstructed)
      obstructed.push_back(gap.vertices[static_cast<std::size_t>(point)]);
  }
  spend(context.control, all.size());
  const Triangles made =
      largeComponents(all, gap.surface.rim.size(), gap.surface.positions, rule);
  for (const Triangle& triangle : inTheWhole(made, gap.vertices))
    surface.add(triangle);
  spend(context.control, all.size());
  return obstructed;
}

void
dropCrossings(PartialSurface& surface,
              const PointView& points,
              const LoopContext& context)
{
  std::vector<pcl::index_t> added;
  Triangles triangles;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t)
    if (const auto triangle = static_cast<pcl::index_t>(t);
        !surface.isGiven(triangle) && surface.isAlive(triangle)) {
      added.push_back(triangle);
      triangles.push_back(surface[triangle]);
    }
  const SelfIntersections found =
      findSelfIntersections(triangles, points, context.threads, *context.control);
  for (const TrianglePair& pair : found.pairs)
    surface.remove(added[static_cast<std::size_t>(pair.second)]);
}

bool
closeBetween(const std::vector<pcl::index_t>& open,
             const Gap& grown,
             const NearbyTriangles& nearby,
             const CompletionParameters& parameters,
             PartialSurface& surface,
             RunControl* control)
{
  if (open.empty())
    return false;
  std::vector<pcl::index_t> vertices;
  OpenSurface gap = surface.openAt(open, {}, vertices, control);
  if (isCancelled(control))
    return false;
  completeSpacings(gap);
  const IndexSet numbers(grown.open);
  for (std::size_t i = 0; i < open.size(); ++i)
    if (const pcl::index_t number = numbers.placeOf(open[i]); number >= 0)
      gap.spacings[i] = grown.surface.spacings[static_cast<std::size_t>(number)];
  GrowingSurface growing(gap);
  TriangleTrial trial(gap, growing, parameters.support, &nearby);
  closeLoops(growing, trial, control);
  const auto& all = growing.triangles();
  const auto rim = static_cast<std::ptrdiff_t>(gap.rim.size());
  for (const Triangle& triangle : inTheWhole({all.begin() + rim, all.end()}, vertices))
    surface.add(triangle);
  return all.size() > gap.rim.size();
}

std::vector<pcl::index_t>
touchedVertices(const PartialSurface& surface,
                const std::vector<pcl::index_t>& open,
                RunControl* control)
{
  std::vector<pcl::index_t> touched = open;
  for (std::size_t t = 0; t < surface.triangleCount(); ++t) {
    const auto triangle = static_cast<pcl::index_t>(t);
    if (surface.isGiven(triangle) != surface.isAlive(triangle))
      touched.insert(touched.end(), surface[triangle].begin(), surface[triangle].end());
  }
  spend(control, touched.size());
  sortUnique(touched);
  spend(control, touched.size());
  return touched;
}

} // namespace pcl::ccaa
