// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the field kernel for processors with AVX-512.
#include "field/field_kernel.h"

#ifdef PCL_REPAIR_HAS_X86_KERNELS

#include <immintrin.h>

// Not "fma": the tension must be the same bits on every processor.
#ifdef __clang__
#pragma clang attribute push(__attribute__((target("avx512f,avx512dq"))),              \
                             apply_to = function)
#else
#pragma GCC target("avx512f,avx512dq")
#endif

#define PCL_KERNEL avx512
#define PCL_REGISTER_BYTES 64
#define PCL_FIELD_CHAINS 3
#include "field/field_kernel_impl.h"

#ifdef __clang__
#pragma clang attribute pop
#endif

namespace pcl::repair::field_kernel {

const Kernel AVX512_KERNEL = {avx512::sum, avx512::select};

} // namespace pcl::repair::field_kernel

#endif
