// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the empty-circle test, one text for all instruction sets.
//
// Included once per instruction set, see run/registers.h. Nothing of a library may be
// compiled in here: the linker could pick that copy for everybody. Every machine gets
// the same bits: no contraction, sums in fixed lanes.
#pragma once

#include "greedy/edge_certificate_kernel.h"
#include "greedy/edge_certificate_neighborhood.h"
#include "run/registers.h"

namespace pcl::ccaa::certificate::PCL_KERNEL {

using namespace ccaa::PCL_KERNEL;

/** The signed square of a cotangent on a side without witnesses: an angle of zero. */
constexpr float UNSEEN = 1e12f;

/** As many edges side by side as fill a register. */
constexpr int EDGE_LANES = PCL_REGISTER_BYTES / 4;
using Lanes = Register<float>;
using LaneNumbers = Register<std::int32_t>;

inline Lanes
magnitudes(const Lanes& values)
{
  return (Lanes)((LaneNumbers)values & 0x7fffffff);
}

/** The smaller value where the mask is set, else the first. A value behind an unset
 * mask becomes NaN, which loses the comparison. */
inline Lanes
smallerWhere(const LaneNumbers& mask, const Lanes& least, const Lanes& value)
{
  const Lanes counted = (Lanes)((LaneNumbers)value | ~mask);
  return counted < least ? counted : least;
}

/** The empty-circle test of as many edges at once, the first of them \a offset. A
 * witness c sees an edge under an angle of cotangent p / sqrt(q); its signed square is
 * kept, and the smallest of each side stands for the widest angle. The two sum to zero
 * or more exactly if the two angles sum to at most pi. */
template <int LANES>
inline void
emptyCircleTest(const Neighborhood<LANES>& hood, int offset, float* margin)
{
  const Lanes edge_x = load(hood.x + offset), edge_y = load(hood.y + offset),
              edge_z = load(hood.z + offset);
  const Lanes own = edge_x * edge_x + edge_y * edge_y + edge_z * edge_z;
  const Lanes least = 1e-12f * own * own;
  Lanes left = Lanes{} + UNSEEN, right = left;
  for (int i = 0; i < hood.count; ++i) {
    const float x = hood.x[i], y = hood.y[i], z = hood.z[i];
    const float witness = x * x + y * y + z * z;
    const Lanes product = x * edge_x + y * edge_y + z * edge_z;
    const Lanes p = witness - product;
    const Lanes square = witness * own - product * product;
    const Lanes q = square > least ? square : least;
    const Lanes cotangent = p * magnitudes(p) / q;
    // The end of the edge itself has p = 0 and side = 0 and so stands on neither side;
    // a witness exactly between the ends is moved off the line by the last term.
    const Lanes side = edge_x * y - edge_y * x + 1e-6f * p;
    left = smallerWhere(side > 0, left, cotangent);
    right = smallerWhere(side < 0, right, cotangent);
  }
  const Lanes sum = left + right;
  __builtin_memcpy(margin + offset, &sum, sizeof(sum));
}

template <int LANES>
inline EdgeVotes
votesOf(const CertificateInput& input, std::int32_t rank)
{
  Neighborhood<LANES> hood;
  gather(input, rank, hood);
  if (hood.count == 0)
    return {};
  const double spacing = normalise(hood);
  const Symmetric c = covariance(hood);
  const Direction n = planeNormal(c);
  turnToPlane(hood, n);
  const bool is_noise = isThick(c, n) && isUnlayered(hood);
  const std::uint64_t along = is_noise ? ~std::uint64_t(0) : edgesAlongSurface(hood);
  flatten(hood, is_noise);
  alignas(64) float margin[LANES];
  for (int offset = 0; offset < hood.count; offset += EDGE_LANES)
    emptyCircleTest(hood, offset, margin);
  EdgeVotes votes;
  votes.reach = static_cast<float>(spacing * input.reach);
  for (int j = 0; j < hood.count; ++j) {
    const bool in_reach = hood.squared[j] <= input.reach * input.reach;
    const bool certified = in_reach && margin[j] >= 0;
    votes.in_reach |= std::uint64_t(in_reach) << j;
    votes.certified |= std::uint64_t(certified) << j;
  }
  votes.certified &= along;
  return votes;
}

template <int LANES>
void
votesOfRange(const CertificateInput& input,
             std::size_t first,
             std::size_t last,
             EdgeVotes* votes)
{
  for (std::size_t rank = first; rank < last; ++rank)
    votes[rank - first] = votesOf<LANES>(input, static_cast<std::int32_t>(rank));
}

inline void
certify(const CertificateInput& input,
        std::size_t first,
        std::size_t last,
        EdgeVotes* votes)
{
  if (input.k <= 16)
    votesOfRange<16>(input, first, last, votes);
  else if (input.k <= 32)
    votesOfRange<32>(input, first, last, votes);
  else
    votesOfRange<64>(input, first, last, votes);
}

} // namespace pcl::ccaa::certificate::PCL_KERNEL
