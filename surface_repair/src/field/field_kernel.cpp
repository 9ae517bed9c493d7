// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which field kernel a processor gets.
#include "field_kernel.h"

namespace pcl {
namespace repair {
namespace field_kernel {

Sum
bestSum()
{
#ifdef PCL_REPAIR_HAS_X86_KERNELS
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq"))
    return AVX512_SUM;
  if (__builtin_cpu_supports("avx2"))
    return AVX2_SUM;
#endif
  return BASELINE_SUM;
}

} // namespace field_kernel
} // namespace repair
} // namespace pcl
