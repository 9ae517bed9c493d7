// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: roots and powers of whole registers, alike on every
// machine.
//
// Part of the kernel text, see field_kernel_impl.h. No library function and no
// instruction whose last bits differ between processors: additions, multiplications,
// divisions and IEEE square roots only.
#pragma once

#include "field/field_kernel.h"
#include "run/registers.h"

namespace pcl::repair::field_kernel::PCL_KERNEL {

using namespace ccaa::PCL_KERNEL;

/** Lanes of a register. */
constexpr int WIDTH = PCL_REGISTER_BYTES / 8;
using Lanes = Register<double>;
using Bits = Register<std::int64_t>;

/** IEEE square root. */
inline Lanes
squareRoot(const Lanes& x)
{
#if PCL_REGISTER_BYTES == 64
  return (Lanes)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
#elif PCL_REGISTER_BYTES == 32
  return (Lanes)_mm256_sqrt_pd((__m256d)x);
#else
  Lanes root;
  for (int i = 0; i < WIDTH; ++i)
    root[i] = __builtin_sqrt(x[i]);
  return root;
#endif
}

/** 1 / sqrt(x) in single precision. */
inline Lanes
roughInverseRoot(const Lanes& x)
{
#if PCL_REGISTER_BYTES == 64
  const __m256 root = _mm256_sqrt_ps(_mm512_maskz_cvtpd_ps(0xff, (__m512d)x));
  return (Lanes)_mm512_maskz_cvtps_pd(0xff, _mm256_div_ps(_mm256_set1_ps(1.0f), root));
#elif PCL_REGISTER_BYTES == 32
  const __m128 root = _mm_sqrt_ps(_mm256_cvtpd_ps((__m256d)x));
  return (Lanes)_mm256_cvtps_pd(_mm_div_ps(_mm_set1_ps(1.0f), root));
#else
  Lanes inverse;
  for (int i = 0; i < WIDTH; ++i)
    inverse[i] = 1.0f / __builtin_sqrtf(static_cast<float>(x[i]));
  return inverse;
#endif
}

/** 1 / sqrt(x) within 1e-13 relative for x in [1e-37, 1e37]. Single precision and a
 * step of Newton: a root and a division in double share one slow unit. */
inline Lanes
inverseRoot(const Lanes& x)
{
  const Lanes y = roughInverseRoot(x);
  return y * (1.5 - 0.5 * x * y * y);
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
  // ln(m) = 2 artanh(z), z^2 < 0.03; pairs of terms (Estrin) need not wait for each
  // other.
  const Lanes z = (m - 1.0) / (m + 1.0), w = z * z, w2 = w * w, w4 = w2 * w2;
  const Lanes first = (1.0 + w * (1.0 / 3.0)) + w2 * (1.0 / 5.0 + w * (1.0 / 7.0));
  const Lanes second =
      (1.0 / 9.0 + w * (1.0 / 11.0)) + w2 * (1.0 / 13.0 + w * (1.0 / 15.0));
  const Lanes series = first + w4 * (second + w4 * (1.0 / 17.0));
  return e + 2.8853900817779268 * z * series; // 2 / ln 2
}

/** 2^x for x in [-1000, 1000]. */
inline Lanes
binaryExponential(const Lanes& x)
{
  constexpr double TO_INTEGER = 6755399441055744.0; // 1.5 * 2^52: rounds to nearest
  const Lanes shifted = x + TO_INTEGER;
  const Lanes f = (x - (shifted - TO_INTEGER)) * 0.69314718055994531;
  // exp(f), |f| < 0.35, to f^11 / 11!
  const Lanes f2 = f * f, f4 = f2 * f2;
  const Lanes first = (1.0 + f) + f2 * (0.5 + f * (1.0 / 6.0));
  const Lanes second =
      (1.0 / 24.0 + f * (1.0 / 120.0)) + f2 * (1.0 / 720.0 + f * (1.0 / 5040.0));
  const Lanes third = (1.0 / 40320.0 + f * (1.0 / 362880.0)) +
                      f2 * (1.0 / 3628800.0 + f * (1.0 / 39916800.0));
  const Lanes series = first + f4 * (second + f4 * third);
  return (Lanes)((Bits)series + ((Bits)shifted << 52));
}

} // namespace pcl::repair::field_kernel::PCL_KERNEL
