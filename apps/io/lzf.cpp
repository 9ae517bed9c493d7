// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: unpacks the LZF data of compressed PCD files.
#include "lzf.h"

#include <algorithm>

namespace app {

bool
unpackLzf(const char* input,
          std::size_t input_size,
          char* output,
          std::size_t output_size)
{
  const char* const end = input + input_size;
  const auto byte = [&] { return std::size_t{static_cast<unsigned char>(*input++)}; };
  const auto left = [&] { return static_cast<std::size_t>(end - input); };
  std::size_t used = 0;
  while (input != end) {
    const std::size_t control = byte();
    const bool is_copy = control >= 32;
    const bool is_long = control >> 5 == 7;
    if (is_copy && left() < (is_long ? 2U : 1U))
      return false;
    const std::size_t length =
        is_copy ? (control >> 5) + (is_long ? byte() : 0) + 2 : control + 1;
    const std::size_t distance = is_copy ? ((control & 31) << 8) + byte() + 1 : 0;
    if (length > output_size - used || distance > used || (!is_copy && length > left()))
      return false;
    if (!is_copy && output != nullptr)
      std::copy_n(input, length, output + used);
    // Byte by byte on purpose: a copy may overlap what it has just written.
    for (std::size_t i = used; is_copy && output != nullptr && i < used + length; ++i)
      output[i] = output[i - distance];
    input += is_copy ? 0 : length;
    used += length;
  }
  return used == output_size;
}

} // namespace app
