// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: long polygons triangulated at some of their points first.

#include "filling/coarse_to_fine.h"

#include <algorithm>

namespace pcl::repair {

namespace {

/** Points up to which all diagonals are looked at. */
constexpr std::size_t FULL_SEARCH = 160;
/** Points by which the ends of a diagonal may be away from those of a coarse one. */
constexpr std::size_t LEEWAY = 3;

/** Every second point; the normals are those of both edges together. */
BoundaryCurve
everySecond(const BoundaryCurve& polygon)
{
  BoundaryCurve coarse;
  const std::size_t n = polygon.size();
  for (std::size_t k = 0; k + 1 < n; k += 2) {
    coarse.points.push_back(polygon.points[k]);
    const std::size_t end = k + 3 == n ? n : k + 2; // an odd one out goes with the last
    Direction sum = Direction::Zero();
    for (std::size_t edge = k; edge < end; ++edge)
      if (polygon.normals[edge].allFinite())
        sum += polygon.edge(edge).norm() * polygon.normals[edge];
    coarse.normals.push_back(sum.normalized());
  }
  return coarse;
}

/** Diagonals whose ends lie near those of an edge of the coarse triangulation, and all
 * short ones: so the coarse triangulation itself is among what they allow. */
class NearbyDiagonals {
public:
  explicit NearbyDiagonals(std::size_t points) : n_(points)
  {
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t step = 2; step <= 2 * LEEWAY; ++step)
        add(i, i + step);
  }

  void
  addAround(std::size_t i, std::size_t j)
  {
    for (std::size_t a = 0; a <= 2 * LEEWAY; ++a)
      for (std::size_t b = 0; b <= 2 * LEEWAY; ++b)
        add(i + n_ + a - LEEWAY, j + n_ + b - LEEWAY);
  }

  std::vector<Diagonal>
  sorted()
  {
    std::sort(diagonals_.begin(), diagonals_.end());
    diagonals_.erase(std::unique(diagonals_.begin(), diagonals_.end()),
                     diagonals_.end());
    return std::move(diagonals_);
  }

private:
  void
  add(std::size_t i, std::size_t j)
  {
    const Diagonal d = std::minmax({i % n_, j % n_});
    if (isDiagonal(d, n_))
      diagonals_.push_back(d);
  }

  std::size_t n_;
  std::vector<Diagonal> diagonals_;
};

std::vector<Diagonal>
diagonalsNear(const Triangles& coarse, std::size_t points)
{
  NearbyDiagonals near(points);
  for (const Triangle& t : coarse)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<std::size_t>(t[k]);
      const auto j = static_cast<std::size_t>(t[(k + 1) % 3]);
      if (i < j)
        near.addAround(2 * i, 2 * j);
    }
  return near.sorted();
}

} // namespace

bool
areAllLookedAt(std::size_t points)
{
  return points <= FULL_SEARCH;
}

TriangulationTable
triangulateCoarseToFine(const BoundaryCurve& polygon,
                        const FillingWeights& weights,
                        const FillingLimits& limits)
{
  const std::size_t n = polygon.size();
  if (areAllLookedAt(n))
    return {polygon, nullptr, weights, limits};
  FillingLimits unlimited;
  unlimited.control = limits.control;
  FillingLimits coarse = unlimited;
  if (limits.joined)
    coarse.joined = [&](std::size_t i, std::size_t j) {
      return limits.joined(2 * i, 2 * j);
    };
  if (limits.obstructed)
    coarse.obstructed = [&](std::size_t i, std::size_t m, std::size_t j) {
      return limits.obstructed(2 * i, 2 * m, 2 * j);
    };
  if (limits.crossed)
    coarse.crossed = [&](std::size_t i, std::size_t j) {
      return limits.crossed(2 * i, 2 * j);
    };
  const BoundaryCurve every_second = everySecond(polygon);
  const auto start = [&](const FillingLimits& within) {
    return triangulateCoarseToFine(every_second, weights, within).triangles();
  };
  Triangles first = start(coarse);
  if (first.empty()) // what is in the way of the coarse one need not be in ours
    first = start(unlimited);
  const std::vector<Diagonal> near = diagonalsNear(first, n);
  return {polygon, &near, weights, limits};
}

} // namespace pcl::repair
