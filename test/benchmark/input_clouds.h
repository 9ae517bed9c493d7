// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: clouds for benchmarks, from files or made to order.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <string>

namespace bench {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief The cloud that a word of the command line names:
 * - FILE.ply or FILE.pcd: its finite points;
 * - bumpy:N: N points spread at random over a closed bumpy sphere, in random order;
 * - sample:FILE.ply:N:NOISE: N points spread at random over the triangles of a mesh,
 * each moved by gaussian noise of NOISE mean spacings, in random order. Seeded, so
 * always the same. Throws std::runtime_error for what it cannot read. */
Cloud::Ptr
makeCloud(const std::string& word);

/** \brief The last part of a word, to print. */
std::string
shortName(const std::string& word);

} // namespace bench
