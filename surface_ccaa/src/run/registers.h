// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: as many numbers at a time as a register holds.
#pragma once

// Part of the text of kernels, which is compiled once for each instruction set, with
// PCL_KERNEL naming the namespace and PCL_REGISTER_BYTES the width of a register; of
// sets with more than 16, immintrin.h comes first. Static, so that the linker can pick
// no set's functions for another one.

namespace pcl::ccaa::PCL_KERNEL {

template <typename T>
struct RegisterOf {
  using Type __attribute__((vector_size(PCL_REGISTER_BYTES))) = T;
};

/** Numbers side by side; operators work lane by lane. */
template <typename T>
using Register = typename RegisterOf<T>::Type;

template <typename T>
static inline Register<T>
load(const T* values)
{
  Register<T> lanes;
  __builtin_memcpy(&lanes, values, sizeof lanes);
  return lanes;
}

/** The same number in all lanes. */
template <typename T>
static inline Register<T>
all(T value)
{
  return value - Register<T>{}; // a sum would turn -0 into 0
}

// The larger and the smaller of two; where either is NaN, the second: as ternary
// operators, but one instruction.

static inline Register<float>
larger(const Register<float>& a, const Register<float>& b)
{
#if PCL_REGISTER_BYTES == 32
  return (Register<float>)_mm256_max_ps((__m256)a, (__m256)b);
#else
  return a > b ? a : b;
#endif
}

static inline Register<double>
larger(const Register<double>& a, const Register<double>& b)
{
#if PCL_REGISTER_BYTES == 64
  return (Register<double>)_mm512_maskz_max_pd(0xff, (__m512d)a, (__m512d)b);
#elif PCL_REGISTER_BYTES == 32
  return (Register<double>)_mm256_max_pd((__m256d)a, (__m256d)b);
#else
  return a > b ? a : b;
#endif
}

static inline Register<double>
smaller(const Register<double>& a, const Register<double>& b)
{
#if PCL_REGISTER_BYTES == 64
  return (Register<double>)_mm512_maskz_min_pd(0xff, (__m512d)a, (__m512d)b);
#elif PCL_REGISTER_BYTES == 32
  return (Register<double>)_mm256_min_pd((__m256d)a, (__m256d)b);
#else
  return a < b ? a : b;
#endif
}

} // namespace pcl::ccaa::PCL_KERNEL
