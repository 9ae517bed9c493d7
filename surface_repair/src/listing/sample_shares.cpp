// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which free points are samples of which missing area.

#include "listing/sample_shares.h"

#include "fairing/triangle_search.h"
#include "field/float_tree.h"
#include "mesh/box_tree.h"
#include "mesh/corners.h"
#include "region/sample_evidence.h"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace pcl::repair {

namespace {

/** Neighbours that a hop may lead to. */
constexpr std::size_t NEIGHBOURS = 8;
/** Longest hop, in spacings of the denser end. */
constexpr double LONGEST_HOP = 3.0;
/** Longest hop from a rim, in diagonals of the box around it. */
constexpr double FIRST_HOP = 0.75;
/** A free point so close over the given surface tells nothing new, in spacings. */
constexpr double CLOSE = 0.5;
/** Samples that tell a surface. */
constexpr std::size_t FEWEST = 4;
/** Hops between the samples of two regions that make these one, both ways counted. */
constexpr std::size_t FEWEST_MEETINGS = 8;

/** Operations for a sample, and for a triangle that may pass by. */
constexpr std::uint64_t SAMPLE_WORK = 200;
constexpr std::uint64_t TRIANGLE_WORK = 10;

/** A free point and those around it. */
struct Sample {
  std::vector<pcl::index_t> neighbours; /**< nearest first */
  double spacing = 0.0;
  bool is_given = false; /**< the given surface passes by */
};

std::vector<Sample>
samplesOf(const FreePointField& free_points, ccaa::RunControl* control)
{
  const Positions& points = free_points.points();
  std::vector<Sample> samples(points.size());
  ccaa::WorkCount work(control);
  for (std::size_t i = 0; i < points.size() && work.add(SAMPLE_WORK); ++i) {
    Sample& one = samples[i];
    one.neighbours = free_points.nearest(points[i], NEIGHBOURS + 1);
    one.neighbours.erase(std::remove(one.neighbours.begin(),
                                     one.neighbours.end(),
                                     static_cast<pcl::index_t>(i)),
                         one.neighbours.end());
    if (one.neighbours.size() < SPACING_NEIGHBOUR)
      continue;
    const auto other = one.neighbours[SPACING_NEIGHBOUR - 1];
    one.spacing = (points[static_cast<std::size_t>(other)] - points[i]).norm();
  }
  return samples;
}

bool
isOnBoundary(const IncompleteModel& model, pcl::index_t vertex)
{
  return !model.normals[static_cast<std::size_t>(vertex)].isZero();
}

/** What is close to the surface and nearest to it away from its boundary lies over it;
 * beyond the boundary the surface goes on. */
void
markGiven(const IncompleteModel& model,
          const Positions& points,
          ccaa::RunControl* control,
          std::vector<Sample>& samples)
{
  std::vector<ccaa::Box> boxes;
  std::vector<double> nearest;
  for (std::size_t i = 0; i < points.size(); ++i) {
    nearest.push_back(CLOSE * samples[i].spacing);
    boxes.push_back(ccaa::widened(ccaa::Box(points[i]), nearest.back()));
  }
  const ccaa::BoxTree tree(boxes, 1, control);
  ccaa::WorkCount work(control);
  for (const Triangle& triangle : model.triangles) {
    if (!work.add(TRIANGLE_WORK))
      return;
    const ccaa::Corners corners = ccaa::cornersOf(triangle, model.positions);
    const bool at_boundary = std::any_of(triangle.begin(), triangle.end(), [&](auto v) {
      return isOnBoundary(model, v);
    });
    tree.forEachMeeting(ccaa::boxOf(corners), [&](pcl::index_t i) {
      const auto point = static_cast<std::size_t>(i);
      const double distance = nearestPlace(points[point], corners).distance;
      if (distance > nearest[point] ||
          (distance == nearest[point] && !samples[point].is_given))
        return;
      nearest[point] = distance;
      samples[point].is_given = !at_boundary;
    });
  }
}

/** Points of all rims, and the region of each. */
struct Rims {
  Positions points;
  std::vector<std::size_t> region;
  std::vector<double> reach; /**< of a region */
  FloatTree tree;

  explicit Rims(const std::vector<Region>& regions)
  {
    for (std::size_t r = 0; r < regions.size(); ++r) {
      ccaa::Box box;
      for (const HolePolygon& hole : regions[r].holes)
        for (const Position& point : hole.curve.points) {
          points.push_back(point);
          region.push_back(r);
          box.extend(point);
        }
      reach.push_back(FIRST_HOP * box.diagonal().norm());
    }
    tree = FloatTree(points);
  }
};

/** Where ways have come. */
struct Ways {
  std::vector<std::vector<std::size_t>> shares; /**< samples of each region, in order */
  std::vector<std::size_t> region_of;           /**< of each sample, or NONE */
};

bool
isHop(const Positions& points,
      const std::vector<Sample>& samples,
      std::size_t from,
      std::size_t to)
{
  return (points[to] - points[from]).norm() <=
         LONGEST_HOP * std::min(samples[from].spacing, samples[to].spacing);
}

/** The ways over free points, from all rims at once (Dijkstra's algorithm, the squares
 * of the hops added: many short ones go before a long one). */
Ways
nearestRegions(const Positions& points,
               const std::vector<Sample>& samples,
               const Rims& rims)
{
  using Step = std::tuple<double, std::size_t, std::size_t>; // cost, sample, region
  std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].is_given || samples[i].neighbours.size() < SPACING_NEIGHBOUR)
      continue;
    const auto rim = static_cast<std::size_t>(rims.tree.nearest(points[i], 1).front());
    const double hop = (rims.points[rim] - points[i]).norm();
    const std::size_t region = rims.region[rim];
    if (hop <= rims.reach[region])
      open.emplace(hop * hop, i, region);
  }
  Ways ways;
  ways.shares.resize(rims.reach.size());
  ways.region_of.assign(samples.size(), NONE);
  while (!open.empty()) {
    const auto [cost, i, region] = open.top();
    open.pop();
    if (ways.region_of[i] != NONE)
      continue;
    ways.region_of[i] = region;
    ways.shares[region].push_back(i);
    for (const pcl::index_t neighbour : samples[i].neighbours) {
      const auto next = static_cast<std::size_t>(neighbour);
      if (ways.region_of[next] == NONE && !samples[next].is_given &&
          isHop(points, samples, i, next))
        open.emplace(cost + (points[next] - points[i]).squaredNorm(), next, region);
    }
  }
  return ways;
}

std::vector<Sample>
missingSamples(const IncompleteModel& model,
               const FreePointField& free_points,
               ccaa::RunControl* control)
{
  std::vector<Sample> samples = samplesOf(free_points, control);
  markGiven(model, free_points.points(), control, samples);
  return samples;
}

} // namespace

std::vector<std::vector<std::size_t>>
shareSamples(const IncompleteModel& model,
             const FreePointField& free_points,
             const std::vector<Region>& regions,
             ccaa::RunControl* control)
{
  const Positions& points = free_points.points();
  if (regions.empty() || points.size() < FEWEST)
    return std::vector<std::vector<std::size_t>>(regions.size());
  const std::vector<Sample> samples = missingSamples(model, free_points, control);
  auto shares = std::move(nearestRegions(points, samples, Rims(regions)).shares);
  for (std::vector<std::size_t>& share : shares)
    if (share.size() < FEWEST)
      share.clear();
  return shares;
}

std::vector<std::pair<std::size_t, std::size_t>>
regionsThatSamplesLink(const IncompleteModel& model,
                       const FreePointField& free_points,
                       const std::vector<Region>& regions)
{
  const Positions& points = free_points.points();
  if (regions.size() < 2 || points.size() < FEWEST)
    return {};
  const std::vector<Sample> samples = missingSamples(model, free_points, nullptr);
  const Ways ways = nearestRegions(points, samples, Rims(regions));
  std::vector<std::map<std::size_t, std::size_t>> meetings(regions.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (const pcl::index_t neighbour : samples[i].neighbours) {
      const auto next = static_cast<std::size_t>(neighbour);
      const std::size_t own = ways.region_of[i];
      const std::size_t other = ways.region_of[next];
      if (own == NONE || other == NONE || own == other ||
          !isHop(points, samples, i, next))
        continue;
      ++meetings[own][other];
      ++meetings[other][own];
    }
  const auto most = [&](std::size_t region) {
    std::pair<std::size_t, std::size_t> best(0, NONE); // meetings, with whom
    for (const auto& [other, count] : meetings[region])
      if (count > best.first)
        best = {count, other};
    return best;
  };
  std::vector<std::pair<std::size_t, std::size_t>> linked;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const auto [count, other] = most(r);
    if (count >= FEWEST_MEETINGS && r < other && most(other).second == r)
      linked.emplace_back(r, other);
  }
  return linked;
}

} // namespace pcl::repair
