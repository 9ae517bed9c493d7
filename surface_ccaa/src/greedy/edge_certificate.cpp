// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which candidate edges no other point speaks against.
#include "greedy/edge_certificate.h"

#include "greedy/edge_certificate_kernel.h"

#include <type_traits>

namespace pcl::ccaa {
namespace {

static_assert(sizeof(Coordinates) == 3 * sizeof(float) &&
                  std::is_same<index_t, std::int32_t>::value,
              "the kernels read coordinates and rows as plain arrays");

certificate::Certify
bestKernel()
{
#ifdef PCL_CCAA_HAS_AVX2_CERTIFICATE
  if (__builtin_cpu_supports("avx2"))
    return certificate::AVX2_CERTIFY;
#endif
  return certificate::BASELINE_CERTIFY;
}

} // namespace

void
certifyEdges(const RankedPoints& points,
             const NeighborRows& neighbors,
             float length_factor,
             std::size_t first,
             std::size_t last,
             EdgeVotes* votes)
{
  static const certificate::Certify certify = bestKernel();
  if (first < last)
    certify({points.coordinates.front().data(),
             neighbors.ranks,
             neighbors.k,
             length_factor},
            first,
            last,
            votes);
}

} // namespace pcl::ccaa
