// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: seeded random numbers that are the same on every platform.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace pcl::ccaa::test {

/** \brief Random numbers for tests. Only the engine of the standard library is fixed by
 * the standard, its distributions are not, so the distributions are written out here.
 */
class RandomSource {
public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  /** \brief Uniform in [0, 1). */
  double
  uniform()
  {
    return static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

  double
  uniform(double low, double high)
  {
    return low + (high - low) * uniform();
  }

  /** \brief Normally distributed with mean 0 and deviation 1 (Box-Muller). */
  double
  normal()
  {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * M_PI * uniform());
  }

  /** \brief Uniform in 0 .. count - 1; count > 0. */
  std::size_t
  below(std::size_t count)
  {
    return static_cast<std::size_t>(uniform() * static_cast<double>(count));
  }

  template <typename T>
  void
  shuffle(std::vector<T>& values)
  {
    using std::swap;
    for (std::size_t left = values.size(); left > 1; --left)
      swap(values[left - 1], values[below(left)]);
  }

private:
  std::mt19937_64 engine_;
};

} // namespace pcl::ccaa::test
