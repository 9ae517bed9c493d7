// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the empty-circle test for processors with AVX2.
#include "greedy/edge_certificate_kernel.h"

#ifdef PCL_CCAA_HAS_AVX2_CERTIFICATE

#include <immintrin.h>

// Not "fma": votes must be the same on every processor.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC target("avx2")
#endif

#define PCL_KERNEL avx2
#define PCL_REGISTER_BYTES 32
#include "greedy/edge_certificate_kernel_impl.h"

#ifdef __clang__
#pragma clang attribute pop
#endif

namespace pcl::ccaa::certificate {

const Certify AVX2_CERTIFY = avx2::certify;

} // namespace pcl::ccaa::certificate

#endif
