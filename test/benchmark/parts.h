// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a benchmark program of several parts.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace bench {

/** What users set for all parts. */
struct PartSettings {
  std::uint64_t seeds = 0; /**< 0: the usual ones of a part */
  std::size_t repeats = 3; /**< runs of which the median time counts */

  std::uint64_t
  seedsOr(std::uint64_t usual) const
  {
    return seeds == 0 ? usual : seeds;
  }
};

struct Part {
  std::string name;
  std::string does;
  std::function<void(const PartSettings&)> run;
  bool is_usual = true; /**< run where no parts are named */
};

struct PartProgram {
  std::string name;
  std::vector<Part> parts;
  std::string seeds_option; /**< such as --seeds */
  std::string seeds_help;
  PartSettings settings; /**< the usual ones */
};

/** Run what the words of a command name. \return exit code */
int
runParts(PartProgram program, int argc, char** argv);

} // namespace bench
