// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: stable sort of points by their code along a curve.
#pragma once

#include <pcl/types.h>

#include <cstddef>
#include <cstdint>

namespace pcl::ccaa {

/** \brief A point and its place along the curve. */
struct CodedPoint {
  std::uint64_t code;
  index_t point_index;
};

/** \brief Sort by code; equal codes keep their order, whatever the number of threads.
 *
 * Digit by digit from the lowest; digits that are the same for all are skipped.
 * \param[in,out] points what to sort
 * \param[in,out] spare room for as many points
 * \param[in] size number of points
 * \param[in] bits how many low bits of the codes are in use
 * \param[in] threads number of threads, at least 1 */
void
radixSort(CodedPoint* points,
          CodedPoint* spare,
          std::size_t size,
          unsigned int bits,
          int threads);

} // namespace pcl::ccaa
