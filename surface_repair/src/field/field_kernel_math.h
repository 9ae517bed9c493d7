// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: roots and powers of whole registers, alike on every
// machine.
//
// Part of the kernel text, see field_kernel_impl.h. No library function and no
// instruction whose last bits differ between processors: additions, multiplications,
// divisions and IEEE square roots only.
#pragma once

#include "field_kernel.h"

namespace pcl {
namespace repair {
namespace field_kernel {
namespace PCL_REPAIR_KERNEL {

/** Lanes of a register. */
constexpr int WIDTH = PCL_REPAIR_REGISTER_BYTES / 8;
using Lanes = double __attribute__((vector_size(PCL_REPAIR_REGISTER_BYTES)));
using Bits = std::int64_t __attribute__((vector_size(PCL_REPAIR_REGISTER_BYTES)));

inline Lanes
load(const double* values)
{
  Lanes lanes;
  __builtin_memcpy(&lanes, values, sizeof(lanes));
  return lanes;
}

inline Lanes
all(double value)
{
  return Lanes{} + value;
}

/** IEEE square root. */
inline Lanes
squareRoot(const Lanes& x)
{
#if PCL_REPAIR_REGISTER_BYTES == 64
  return (Lanes)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
#elif PCL_REPAIR_REGISTER_BYTES == 32
  return (Lanes)_mm256_sqrt_pd((__m256d)x);
#else
  Lanes root;
  for (int i = 0; i < WIDTH; ++i)
    root[i] = __builtin_sqrt(x[i]);
  return root;
#endif
}

/** 1 / sqrt(x) within 4e-16 relative for normal x; a large finite number for 0. Cheaper
 * than a root and a division, which share one slow unit. */
inline Lanes
inverseRoot(const Lanes& x)
{
  // Halving the exponent gives 5 bits, a third-order step and two of Newton the rest.
  Lanes y = (Lanes)(0x5fe6eb50c7b537a9 - ((Bits)x >> 1));
  const Lanes h = x * y * y;
  y = y * (1.875 + h * (0.375 * h - 1.25));
  const Lanes half = 0.5 * x;
  y = y * (1.5 - half * y * y);
  return y * (1.5 - half * y * y);
}

/** log2(x) for normal x above 0. */
inline Lanes
binaryLogarithm(const Lanes& x)
{
  // x = 2^e m with m in [sqrt(1/2), sqrt(2)); the bits of e as a number by way of 2^52.
  constexpr std::int64_t ROOT_HALF = 0x3fe6a09e667f3bcd;
  const Bits shifted = (Bits)x - ROOT_HALF;
  const Bits exponent = shifted >> 52;
  const Lanes m = (Lanes)((Bits)x - (exponent << 52));
  const Lanes e = (Lanes)((exponent + 1024) | 0x4330000000000000) - 4503599627371520.0;
  // ln(m) = 2 artanh(z)
  const Lanes z = (m - 1.0) / (m + 1.0), w = z * z;
  Lanes series = all(1.0 / 19.0);
  for (int k = 17; k > 0; k -= 2)
    series = series * w + 1.0 / k;
  return e + 2.8853900817779268 * z * series; // 2 / ln 2
}

/** 2^x for x in [-1000, 1000]. */
inline Lanes
binaryExponential(const Lanes& x)
{
  constexpr double TO_INTEGER = 6755399441055744.0; // 1.5 * 2^52: rounds to nearest
  const Lanes shifted = x + TO_INTEGER;
  const Lanes f = (x - (shifted - TO_INTEGER)) * 0.69314718055994531;
  constexpr double INVERSE_FACTORIALS[] = {1.0 / 479001600.0,
                                           1.0 / 39916800.0,
                                           1.0 / 3628800.0,
                                           1.0 / 362880.0,
                                           1.0 / 40320.0,
                                           1.0 / 5040.0,
                                           1.0 / 720.0,
                                           1.0 / 120.0,
                                           1.0 / 24.0,
                                           1.0 / 6.0,
                                           0.5,
                                           1.0,
                                           1.0};
  Lanes series = all(1.0 / 6227020800.0);
  for (const double coefficient : INVERSE_FACTORIALS)
    series = series * f + coefficient;
  return (Lanes)((Bits)series + ((Bits)shifted << 52));
}

} // namespace PCL_REPAIR_KERNEL
} // namespace field_kernel
} // namespace repair
} // namespace pcl
