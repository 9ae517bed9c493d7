// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: numbers out of the bytes a fuzzer makes up.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fuzz {

/** \brief Takes numbers from the front of the fuzzer's bytes; zeros when there are no
 * more, so that a longer input never means something else at its beginning. */
class Bytes {
public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  bool
  empty() const
  {
    return next_ == end_;
  }

  std::uint8_t
  byte()
  {
    return empty() ? std::uint8_t{0} : *next_++;
  }

  /** \brief A number below \a bound (at least 1). */
  std::size_t
  below(std::size_t bound)
  {
    const std::size_t high = byte();
    return (high << 8 | byte()) % bound;
  }

  bool
  flag()
  {
    return (byte() & 1U) != 0;
  }

  /** \brief From -2 to 2 in steps of 1 / 64: coarse, so that points coincide and lie on
   * common lines and planes. */
  double
  coarse()
  {
    return (byte() - 128.0) / 64.0;
  }

private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

} // namespace fuzz
