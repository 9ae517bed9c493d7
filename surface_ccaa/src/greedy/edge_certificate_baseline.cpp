// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the empty-circle test for any processor.
#include "greedy/edge_certificate_kernel.h"

#define PCL_KERNEL baseline
#define PCL_REGISTER_BYTES 16
#include "greedy/edge_certificate_kernel_impl.h"

namespace pcl::ccaa::certificate {

const Certify BASELINE_CERTIFY = baseline::certify;

} // namespace pcl::ccaa::certificate
