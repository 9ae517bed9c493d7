// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds for benchmarks, from files or made to order.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "mesh/triangle.h"

#include <string>

namespace bench {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief The cloud that a word of the command line names:
 * - FILE.ply or FILE.pcd: its finite points;
 * - bumpy:N: N points spread at random over a closed bumpy sphere, in random order;
 * - office:SEED, aerial:SEED: a frame of a depth camera, a tile of laser points from
 * the air (single_view.h);
 * - sample:FILE.ply:N:NOISE: N points spread at random over the triangles of a mesh,
 * each moved by gaussian noise of NOISE mean spacings, in random order;
 * - noisy:FILE:SIGMA: each point of FILE moved along each axis by gaussian noise of
 * SIGMA mean spacings (see meanSpacing());
 * - thinned:FILE:SHARE:SIGMA: a random SHARE (0 to 1) of the points, then moved by
 * noise of SIGMA mean spacings of what is left;
 * - outliers:FILE:SHARE: all points, then SHARE times as many spread at random over the
 * bounding box, grown on each side by 5 % of its diagonal;
 * - graded:FILE:FACTOR: a point is kept with probability FACTOR^(-x), where x runs from
 * 0 to 1 along the longest axis of the bounding box, so that the density varies
 * FACTOR-fold (1 or more).
 *
 * Seeded, so always the same. Throws std::runtime_error for what it cannot read,
 * std::invalid_argument for a number that is none. */
Cloud::Ptr
makeCloud(const std::string& word);

/** \brief Points as a cloud. */
Cloud::Ptr
cloudOf(const pcl::ccaa::Positions& points);

/** \brief The file that holds the true surface of the cloud that a word names, if any
 * does: FILE.ply itself, whose triangles makeCloud() does not look at. Empty for clouds
 * without a file and for .pcd, which has no triangles. */
std::string
referenceFile(const std::string& word);

/** \brief A word without the folders in it, to print. */
std::string
shortName(const std::string& word);

} // namespace bench
