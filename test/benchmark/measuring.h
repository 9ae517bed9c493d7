// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: time and memory of a piece of work.
#pragma once

#include <pcl/PolygonMesh.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace bench {

/** \brief Wall-clock seconds that \a work takes. */
double
secondsOf(const std::function<void()>& work);

/** \brief Seconds since some time in the past. */
double
wallSeconds();

/** \brief Seconds of a processor that the calling thread has taken. Needs POSIX. */
double
ownSeconds();

/** \brief The middle value, the upper one of two; 0 of none. */
double
median(std::vector<double> values);

/** \brief Bytes that the contents of a mesh occupy: a polygon is a vector and the block
 * of memory that it points to. */
std::size_t
bytesOf(const pcl::PolygonMesh& mesh);

/** \brief Largest memory of this process while \a work runs, above what it had before,
 * in bytes. Needs Linux; elsewhere 0. */
double
peakBytesOf(const std::function<void()>& work);

} // namespace bench
