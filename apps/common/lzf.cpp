// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: unpacks the LZF compression of PCD files.
#include "lzf.h"

#include <algorithm>

namespace app {

bool
unpackLzf(const char* input, std::size_t input_size, std::vector<char>& output)
{
  const auto* in = reinterpret_cast<const std::uint8_t*>(input);
  std::size_t at = 0;
  std::size_t used = 0;
  while (at < input_size) {
    const std::size_t control = in[at++];
    if (control < 32) {
      const std::size_t length = control + 1;
      if (length > input_size - at || length > output.size() - used)
        return false;
      std::copy_n(input + at, length, output.data() + used);
      at += length;
      used += length;
      continue;
    }
    std::size_t length = control >> 5;
    if (input_size - at < (length == 7 ? 2U : 1U))
      return false;
    if (length == 7)
      length += in[at++];
    length += 2;
    const std::size_t distance = ((control & 31) << 8) + in[at++] + 1;
    if (distance > used || length > output.size() - used)
      return false;
    // Byte by byte on purpose: a copy may overlap what it has just written.
    for (std::size_t i = 0; i < length; ++i, ++used)
      output[used] = output[used - distance];
  }
  return used == output.size();
}

} // namespace app
