// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how far apart the samples lie around open points.
#include "advancing_front/spacing.h"

#include "advancing_front/tuning.h"
#include "mesh/corners.h"
#include "mesh/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Of every open point, the longest edge between closed points that lies across a
 * triangle from it or from an open point next to it. */
std::vector<double>
longestClosedEdges(const OpenSurface& open)
{
  const auto position = [&](pcl::index_t v) -> const Position& {
    return open.positions[static_cast<std::size_t>(v)];
  };
  const auto is_open = [&](pcl::index_t v) {
    return static_cast<std::size_t>(v) < open.open_points;
  };
  std::vector<double> across(open.open_points, 0.0);
  for (const Triangle& t : open.rim)
    for (std::size_t i = 0; i < 3; ++i) {
      const pcl::index_t a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      if (!is_open(t[i]) || is_open(a) || is_open(b))
        continue;
      double& longest = across[static_cast<std::size_t>(t[i])];
      longest = std::max(longest, (position(a) - position(b)).norm());
    }
  std::vector<double> around = across;
  for (const Triangle& t : open.rim)
    for (const pcl::index_t a : t)
      for (const pcl::index_t b : t)
        if (is_open(a) && is_open(b))
          around[static_cast<std::size_t>(a)] = std::max(
              around[static_cast<std::size_t>(a)], across[static_cast<std::size_t>(b)]);
  return around;
}

/** Radius of the smallest circle around a triangle: half of the longest side where the
 * angle across it is obtuse, the circumradius elsewhere. */
double
enclosingRadius(const Corners& corners)
{
  std::array<double, 3> squared;
  for (std::size_t i = 0; i < 3; ++i)
    squared[i] = (corners[(i + 1) % 3] - corners[i]).squaredNorm();
  std::sort(squared.begin(), squared.end());
  const double twice_area = areaNormal(corners).norm();
  if (squared[2] >= squared[0] + squared[1] || twice_area <= 0.0)
    return 0.5 * std::sqrt(squared[2]);
  return std::sqrt(squared[0] * squared[1] * squared[2]) / (2.0 * twice_area);
}

} // namespace

double
spacingFromNeighbors(const OpenSurface& open, pcl::index_t point)
{
  const unsigned int count =
      std::min(tuning::SPACING_NEIGHBORS, open.neighbors.count(point));
  double sum = 0.0;
  for (unsigned int j = 0; j < count; ++j) {
    const auto near = static_cast<std::size_t>(open.neighbors.row(point)[j]);
    sum += (open.positions[static_cast<std::size_t>(point)] - open.positions[near])
               .squaredNorm();
  }
  return count > 0 ? std::sqrt(sum / count) : 0.0;
}

void
completeSpacings(OpenSurface& open)
{
  open.spacings.resize(open.open_points, 0.0);
  const std::vector<double> closed = longestClosedEdges(open);
  for (std::size_t i = 0; i < open.open_points; ++i) {
    double& spacing = open.spacings[i];
    if (spacing <= 0.0)
      spacing = spacingFromNeighbors(open, static_cast<pcl::index_t>(i));
    spacing = std::max(spacing, tuning::CLOSED_EDGE_SHARE * closed[i]);
  }
}

double
usualSpacing(const Triangles& given, const PointView& points)
{
  std::vector<double> lengths;
  for (std::size_t t = 0; t < given.size(); t += tuning::SPACING_STRIDE)
    lengths.push_back((points[given[t][0]] - points[given[t][1]]).norm());
  return medianOf(std::move(lengths));
}

double
largestRoom(const PartialSurface& surface,
            const Triangles& given,
            const PointView& points)
{
  std::vector<double> rooms;
  const std::size_t stride = 1 + given.size() / tuning::ROOM_TRIANGLES;
  for (std::size_t t = 0; t < given.size(); t += stride) {
    std::array<double, 3> spacings;
    std::transform(given[t].begin(), given[t].end(), spacings.begin(), [&](auto v) {
      return surface.spacingAt(v);
    });
    std::sort(spacings.begin(), spacings.end());
    if (spacings[1] > 0.0)
      rooms.push_back(enclosingRadius(cornersOf(given[t], points)) / spacings[1]);
  }
  const double room = quantile(std::move(rooms), tuning::ROOM_SHARE);
  return std::clamp(tuning::LARGEST_ROOM_OF_SAMPLES * room * room,
                    tuning::LARGEST_ROOM,
                    tuning::MOST_ROOM);
}

double
cellSize(const OpenSurface& open, double usual)
{
  std::vector<double> distances;
  for (std::size_t i = 0; i < open.open_points; ++i) {
    const auto point = static_cast<pcl::index_t>(i);
    const unsigned int count =
        std::min(tuning::SPACING_NEIGHBORS, open.neighbors.count(point));
    if (count > 0)
      distances.push_back(
          (open.positions[i] - open.positions[static_cast<std::size_t>(
                                   open.neighbors.row(point)[count - 1])])
              .norm());
  }
  return tuning::CELL_FACTOR *
         (distances.empty() ? usual : medianOf(std::move(distances)));
}

} // namespace pcl::ccaa
