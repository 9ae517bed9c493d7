// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: seeded point sets for tests and benchmarks.
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "mesh/triangle.h"

#include <cstddef>
#include <cstdint>

namespace pcl::ccaa::test {

/** \brief Evenly spread points on a sphere, in spiral order. */
Positions
fibonacciSphere(std::size_t count, double radius = 1.0);

/** \brief Fibonacci sphere of radius 1 with radial noise of the given deviation. */
Positions
noisySphere(std::size_t count, double deviation, std::uint64_t seed = 1);

/** \brief Closed bumpy surface, points jittered by a share of their spacing, in random
 * order: the cloud of the growth benchmark. Mean spacing about sqrt(12.6 / count). */
Positions
bumpySphere(std::size_t count, std::uint64_t seed = 1);

/** \brief Jittered points on a torus about z. */
Positions
torusCloud(std::size_t count,
           double major_radius = 1.0,
           double minor_radius = 0.35,
           std::uint64_t seed = 1);

/** \brief Points on the six faces of the cube [0, 1]^3, edges and corners included:
 * 6 n^2 + 2 points at spacing 1 / n. */
Positions
cubeCloud(int divisions);

/** \brief Two jittered sheets [0, 1]^2 at z = 0 and z = thickness, columns^2 points
 * each. */
Positions
thinPlateCloud(int columns, double thickness, std::uint64_t seed = 1);

/** \brief Jittered open rolling terrain, columns^2 points, spacing about 1. */
Positions
terrainCloud(int columns, std::uint64_t seed = 1);

/** \brief Rolling terrain taken along lines, as by a scanner: points 1 apart, lines
 * `gap` apart, each beginning anywhere. */
Positions
terrainLines(int lines, int points_a_line, double gap, std::uint64_t seed = 1);

/** \brief A sphere taken along circles of latitude, `gap` times as far apart as their
 * points: about `count` of these. */
Positions
sphereLines(std::size_t count, double gap);

/** \brief Jittered points on an open tube about z, radius 1, height 2. */
Positions
cylinderCloud(std::size_t count, std::uint64_t seed = 1);

/** \brief Points on one line, exactly. */
Positions
lineCloud(int count);

/** \brief `count` of the points replaced by non-finite ones: NaN or infinity in turn.
 */
Positions
withNonFinite(Positions points, std::size_t count, std::uint64_t seed = 1);

/** \brief Every point `copies` times; the copies follow as whole blocks. */
Positions
withDuplicates(const Positions& points, int copies);

Positions
scaled(Positions points, double factor);

Positions
shifted(Positions points, const Position& shift);

Positions
shuffled(Positions points, std::uint64_t seed);

/** \brief Independent normal noise of the given deviation on each coordinate. */
Positions
withNoise(Positions points, double deviation, std::uint64_t seed = 1);

/** \brief As an unorganised cloud; is_dense tells whether all points are finite. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
toCloud(const Positions& points);

/** \brief Whether clouds have the same points to the last bit, NaN and padding
 * included.
 */
bool
sameBytes(const pcl::PointCloud<pcl::PointXYZ>& one,
          const pcl::PointCloud<pcl::PointXYZ>& other);

/** \brief As the raw cloud a PolygonMesh carries. */
pcl::PCLPointCloud2
toRawCloud(const Positions& points);

/** \brief The same with x, y and z as doubles. */
pcl::PCLPointCloud2
toDoubleCloud(const Positions& points);

/** \brief Each coordinate at the nearest multiple of 2^-16, so that it stays exact in
 * doubles millions of units away, and in floats near the origin. */
Positions
onGrid(Positions points);

/** \brief A place on a map in metres. */
const Position MAP_PLACE(596648.0, 5420317.0, 251.0);

} // namespace pcl::ccaa::test
