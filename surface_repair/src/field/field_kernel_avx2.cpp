// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the field kernel for processors with AVX2.
#include "field/field_kernel.h"

#ifdef PCL_REPAIR_HAS_X86_KERNELS

#include <immintrin.h>

// Not "fma": the tension must be the same bits on every processor.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC target("avx2")
#endif

#define PCL_KERNEL avx2
#define PCL_REGISTER_BYTES 32
#define PCL_FIELD_CHAINS 2
#include "field/field_kernel_impl.h"

#ifdef __clang__
#pragma clang attribute pop
#endif

namespace pcl::repair::field_kernel {

const Kernel AVX2_KERNEL = {avx2::sum, avx2::select};

} // namespace pcl::repair::field_kernel

#endif
