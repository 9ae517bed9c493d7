// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: unpacks the LZF compression of PCD files.
#include "lzf.h"

#include <algorithm>

namespace app {

namespace {

/** \brief A run of bytes: taken from the input, or a copy of what is there already. */
struct LzfRun {
  std::size_t length = 0;
  std::size_t distance = 0; /**< back from the end of the output; 0: from the input */
};

/** Read the next run; \a at then stands behind it, or at its bytes in the input.
 * \return false when it is cut off. */
bool
readRun(const std::uint8_t* in, std::size_t input_size, std::size_t& at, LzfRun& run)
{
  const std::size_t control = in[at++];
  if (control < 32) {
    run = {control + 1, 0};
    return run.length <= input_size - at;
  }
  run.length = control >> 5;
  if (input_size - at < (run.length == 7 ? 2U : 1U))
    return false;
  if (run.length == 7)
    run.length += in[at++];
  run.length += 2;
  run.distance = ((control & 31) << 8) + in[at++] + 1;
  return true;
}

} // namespace

bool
unpackLzf(const char* input, std::size_t input_size, std::vector<char>& output)
{
  const auto* in = reinterpret_cast<const std::uint8_t*>(input);
  std::size_t at = 0;
  std::size_t used = 0;
  LzfRun run;
  while (at < input_size) {
    if (!readRun(in, input_size, at, run) || run.distance > used ||
        run.length > output.size() - used)
      return false;
    if (run.distance == 0) {
      std::copy_n(input + at, run.length, output.data() + used);
      at += run.length;
      used += run.length;
      continue;
    }
    // Byte by byte on purpose: a copy may overlap what it has just written.
    for (std::size_t i = 0; i < run.length; ++i, ++used)
      output[used] = output[used - run.distance];
  }
  return used == output.size();
}

bool
measureLzf(const char* input, std::size_t input_size, std::size_t& output_size)
{
  const auto* in = reinterpret_cast<const std::uint8_t*>(input);
  output_size = 0;
  LzfRun run;
  for (std::size_t at = 0; at < input_size;) {
    if (!readRun(in, input_size, at, run) || run.distance > output_size)
      return false;
    at += run.distance == 0 ? run.length : 0;
    output_size += run.length;
  }
  return true;
}

} // namespace app
