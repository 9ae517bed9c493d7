// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the border between edge certificates and their kernels.
#pragma once

#include "greedy/edge_votes.h"

#include <cstddef>
#include <cstdint>

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define PCL_CCAA_HAS_AVX2_CERTIFICATE
#endif

namespace pcl::ccaa::certificate {

/** Plain data only: the other side is compiled for several instruction sets. */
struct CertificateInput {
  const float* coordinates; /**< three per rank */
  const std::int32_t* rows; /**< k per rank, negative from the end of a short row on */
  unsigned int k;           /**< at most 64 */
  float reach;              /**< longest edge in local spacings */
};

using Certify = void (*)(const CertificateInput& input,
                         std::size_t first,
                         std::size_t last,
                         EdgeVotes* votes);

extern const Certify BASELINE_CERTIFY;
extern const Certify AVX2_CERTIFY;

} // namespace pcl::ccaa::certificate
