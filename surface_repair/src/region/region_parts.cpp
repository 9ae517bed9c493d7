// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the holes of a region, divided and filled in several ways.

#include "region/region_parts.h"

#include "fairing/flat_cap.h"
#include "filling/completion_filling.h"
#include "patch/taken_edges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::repair {

namespace {

/** Operations of a region: at least, and for each of its edges and samples by their
 * logarithm. The dearest of the scans' holes take half of that. */
constexpr std::uint64_t LEAST_WORK = 400000000;
constexpr double WORK = 400000.0;

} // namespace

std::uint64_t
workFor(std::size_t size)
{
  const auto n = static_cast<double>(size);
  return LEAST_WORK + static_cast<std::uint64_t>(WORK * n * std::log2(n + 2.0));
}

std::uint64_t
workFor(const Region& region)
{
  std::size_t size = region.samples.size();
  for (const HolePolygon& hole : region.holes)
    size += hole.size();
  return workFor(size);
}

RegionParts::RegionParts(const ClosingPlace& place,
                         const Region& region,
                         const SurfaceObstacle& obstacle,
                         const ccaa::LoopContext& context)
: place_(place)
, region_(region)
, obstacle_(obstacle)
, context_(context)
, flat_(isToBeFlat())
{}

bool
RegionParts::isToBeFlat() const
{
  if (region_.cap != Cap::AUTO)
    return region_.cap == Cap::FLAT;
  const HolePolygon& hole = region_.holes.front();
  return isBase(hole.curve,
                place_.model,
                *place_.model.adjacency.begin(hole.vertices.front())) &&
         region_.samples.empty() && !hasSamples(hole);
}

/** Whether free points tell the surface within a large rim: such as were given for
 * that, or enough of them to be its vertices. */
bool
RegionParts::hasSamples(const HolePolygon& hole) const
{
  const FreePointField* free_points = place_.guides.free_points.get();
  if (free_points == nullptr)
    return false;
  const RimPlane plane = planeOf(hole.curve);
  const std::vector<pcl::index_t> near =
      free_points->within(plane.center, 0.5 * plane.size);
  const bool has_given = std::any_of(near.begin(), near.end(), [&](pcl::index_t i) {
    return place_.model.point_of_free_point[static_cast<std::size_t>(i)] ==
           pcl::UNAVAILABLE;
  });
  if (has_given || near.empty())
    return has_given;
  const TakenEdges taken(place_.model);
  return fillHole(fillingTask(hole, taken, nullptr, context_.control),
                  place_.parameters.filling.choice,
                  free_points)
             .method == CompletionFilling().name();
}

void
RegionParts::divide(const std::vector<std::size_t>& strategies,
                    std::vector<HoleOutcome>& holes)
{
  const SubdivisionGuides guides{place_.guides.free_points.get(),
                                 place_.guides.surface.get()};
  std::size_t next = place_.model.positions.size() + region_.bridge_vertices;
  for (std::size_t h = 0; h < region_.holes.size(); ++h) {
    // Bridges would follow the surface around: out of the plane, or past the samples.
    if (flat_ || !region_.samples.empty() || strategies[h] == GIVEN_UP ||
        region_.holes[h].second_loop > 0) {
      parts.push_back({region_.holes[h], {}, h});
      continue;
    }
    DividedHole divided = divideHole(region_.holes[h],
                                     static_cast<pcl::index_t>(next),
                                     place_.parameters.survey,
                                     guides,
                                     context_);
    next += divided.new_vertices.size();
    for (HolePolygon& polygon : divided.holes)
      parts.push_back({std::move(polygon), {}, h});
    holes[h].bridges = std::move(divided.bridges);
  }
}

const std::vector<ChosenFilling>&
RegionParts::fills(const FillStrategy& strategy,
                   const std::vector<std::size_t>& strategies)
{
  std::vector<ChosenFilling>& made = fills_[fillsIn(strategy)];
  if (!made.empty())
    return made;
  TakenEdges taken(place_.model);
  for (const FilledPart& part : parts)
    taken.addPolygon(part.polygon);
  for (const FilledPart& part : parts) {
    made.emplace_back();
    if (strategies[part.hole] == GIVEN_UP)
      continue;
    made.back() =
        fillHole(fillingTask(part.polygon,
                             taken,
                             strategy.avoids ? &obstacle_ : nullptr,
                             context_.control),
                 strategy.without_free || flat_ ? FillingChoice::MINIMUM_WEIGHT
                                                : place_.parameters.filling.choice,
                 place_.guides.free_points.get());
    if (made.back().filling.closed())
      taken.addFilling(part.polygon, made.back().filling);
  }
  return made;
}

} // namespace pcl::repair
