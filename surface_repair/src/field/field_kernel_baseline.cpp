// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the field kernel for any processor.
#include "field/field_kernel.h"

#define PCL_KERNEL baseline
#define PCL_REGISTER_BYTES 16
#define PCL_FIELD_CHAINS 1
#include "field/field_kernel_impl.h"

namespace pcl::repair::field_kernel {

const Kernel BASELINE_KERNEL = {baseline::sum, baseline::select};

} // namespace pcl::repair::field_kernel
