// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: inputs and brute-force answers for the search tests.
#pragma once

#include <pcl/surface_ccaa/impl/point_blocks.h>

#include "support/clouds.h"
#include "support/random_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pcl::ccaa::test {

/** \brief Coordinates in a row, three per point. */
using Coordinates = std::vector<float>;

inline PointArray
arrayOf(const Coordinates& coordinates)
{
  return {coordinates.data(), 3, coordinates.size() / 3};
}

inline Coordinates
toCoordinates(const Positions& points)
{
  Coordinates coordinates;
  for (const Position& point : points)
    for (int axis = 0; axis < 3; ++axis)
      coordinates.push_back(static_cast<float>(point[axis]));
  return coordinates;
}

/** \brief Integer lattice n x n x n: many exactly equal distances. */
inline Positions
lattice(int n)
{
  Positions points;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        points.push_back({double(x), double(y), double(z)});
  return points;
}

/** \brief Clusters from size 1 down to 1e-6, and three points very far away. */
inline Positions
clustersAndOutliers()
{
  RandomSource random(3);
  Positions points;
  for (int i = 0; i < 1400; ++i) {
    const double size = std::pow(10.0, -(i % 7));
    points.push_back(Position(i % 7, 0, 0) + size * Position(random.normal(),
                                                             random.normal(),
                                                             random.normal()));
  }
  points.push_back({1e5, 3, -2});
  points.push_back({-4, 1e12, 0});
  points.push_back({1e30, 1e30, -1e30});
  return points;
}

/** \brief Scan lines: dense along x, sparse across. */
inline Positions
scanLines()
{
  RandomSource random(5);
  Positions points;
  for (int line = 0; line < 20; ++line)
    for (int i = 0; i < 150; ++i)
      points.push_back({i + 0.1 * random.normal(), 20.0 * line, 0.2 * random.normal()});
  return points;
}

inline Positions
onALine(int count)
{
  RandomSource random(6);
  Positions points;
  for (int i = 0; i < count; ++i)
    points.push_back({random.uniform(), 0, 0});
  return points;
}

/** \brief An input by name, so that every test can run over all of them. */
struct NamedInput {
  std::string name;
  Coordinates coordinates;
};

inline std::vector<NamedInput>
allInputs()
{
  const Positions sphere = noisySphere(1500, 0.01);
  const Positions identical(1000, Position(1, 2, 3));
  Positions half_identical = sphere;
  half_identical.insert(half_identical.end(), identical.begin(), identical.end());
  return {{"Empty", {}},
          {"OnePoint", toCoordinates({{1, 2, 3}})},
          {"FivePoints", toCoordinates(noisySphere(5, 0.1))},
          {"NinePoints", toCoordinates(noisySphere(9, 0.1))},
          {"Sphere", toCoordinates(shuffled(sphere, 2))},
          {"Lattice", toCoordinates(shuffled(lattice(12), 2))},
          {"Identical", toCoordinates(identical)},
          {"HalfIdentical", toCoordinates(shuffled(half_identical, 2))},
          {"FiveCopies", toCoordinates(shuffled(withDuplicates(sphere, 5), 2))},
          {"OnALine", toCoordinates(onALine(1000))},
          {"NonFinite", toCoordinates(withNonFinite(sphere, 200))},
          {"ClustersAndOutliers", toCoordinates(clustersAndOutliers())},
          {"ScanLines", toCoordinates(scanLines())},
          {"Tiny", toCoordinates(scaled(sphere, 1e-4))},
          {"Huge", toCoordinates(scaled(sphere, 1e6))},
          {"SquaresUnderflow", toCoordinates(scaled(sphere, 1e-25))},
          {"SquaresOverflow", toCoordinates(scaled(sphere, 1e30))},
          {"FarFromOrigin", toCoordinates(shifted(sphere, Position(1e6, -1e6, 1e6)))}};
}

inline float
sqrDistance(const std::array<float, 3>& a, const std::array<float, 3>& b)
{
  const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

/** \brief Squared distance and rank of all points, nearest first. */
inline std::vector<std::pair<float, index_t>>
bruteForce(const PointBlocks& blocks, const std::array<float, 3>& query)
{
  std::vector<std::pair<float, index_t>> all(blocks.size());
  for (std::size_t rank = 0; rank < blocks.size(); ++rank)
    all[rank] = {sqrDistance(query, blocks.point(rank)), static_cast<index_t>(rank)};
  std::sort(all.begin(), all.end());
  return all;
}

} // namespace pcl::ccaa::test
