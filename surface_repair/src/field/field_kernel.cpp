// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which field kernel a processor gets.
#include "field/field_kernel.h"

namespace pcl::repair::field_kernel {

const Kernel&
bestKernel()
{
#ifdef PCL_REPAIR_HAS_X86_KERNELS
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    return AVX512_KERNEL;
  if (__builtin_cpu_supports("avx2"))
    return AVX2_KERNEL;
#endif
  return BASELINE_KERNEL;
}

} // namespace pcl::repair::field_kernel
