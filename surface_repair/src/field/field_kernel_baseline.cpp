// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the field kernel for any processor.
#include "field/field_kernel.h"

#define PCL_REPAIR_KERNEL baseline
#define PCL_REPAIR_REGISTER_BYTES 16
#define PCL_REPAIR_CHAINS 1
#include "field/field_kernel_impl.h"

namespace pcl {
namespace repair {
namespace field_kernel {

const Kernel BASELINE_KERNEL = {baseline::sum, baseline::select};

} // namespace field_kernel
} // namespace repair
} // namespace pcl
