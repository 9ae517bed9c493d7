// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: seeded random numbers, the same on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace app {

/** \brief The standard fixes the engine but not its distributions, so these are written
 * out here: the same seed damages a cloud in the same way everywhere. */
class RandomNumbers {
public:
  explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}

  /** \brief Real number from 0 to below 1. */
  double
  uniform()
  {
    return static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

  /** \brief Whole number from 0 to below \a count, which is at least 1. The bias of at
   * most count / 2^53 is of no account here. */
  std::size_t
  below(std::size_t count)
  {
    return static_cast<std::size_t>(uniform() * static_cast<double>(count));
  }

  /** \brief Normally distributed, mean 0, deviation 1 (polar method of Marsaglia; its
   * second number is not used, so that every call stands for itself). */
  double
  normal()
  {
    for (;;) {
      const double u = 2 * uniform() - 1;
      const double v = 2 * uniform() - 1;
      const double s = u * u + v * v;
      if (s > 0 && s < 1)
        return u * std::sqrt(-2 * std::log(s) / s);
    }
  }

private:
  std::mt19937_64 engine_;
};

} // namespace app
