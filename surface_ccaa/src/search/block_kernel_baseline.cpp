// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the search kernel for any processor.
#include "search/block_kernel.h"

#define PCL_KERNEL baseline
#define PCL_REGISTER_BYTES 16
#include "search/kernel/block_kernel_impl.h"

namespace pcl::ccaa::block_kernel {

const Kernel BASELINE_KERNEL = {
    baseline::nearestOfBlock, baseline::nearestOfPlace, baseline::within};

} // namespace pcl::ccaa::block_kernel
