// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the search kernel for processors with AVX2.
#include "search/block_kernel.h"

#ifdef PCL_CCAA_HAS_AVX2_KERNEL

#include <immintrin.h>

// Not "fma": distances must be the same bits on every processor.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2,popcnt,bmi"))),               \
                             apply_to = function)
#else
#pragma GCC target("avx2,popcnt,bmi")
#endif

#define PCL_KERNEL avx2
#define PCL_REGISTER_BYTES 32
#include "search/kernel/block_kernel_impl.h"

#ifdef __clang__
#pragma clang attribute pop
#endif

namespace pcl::ccaa::block_kernel {

const Kernel AVX2_KERNEL = {avx2::nearestOfBlock, avx2::nearestOfPlace, avx2::within};

} // namespace pcl::ccaa::block_kernel

#endif
