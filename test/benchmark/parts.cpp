// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a benchmark program of several parts.

#include "parts.h"

#include <pcl/console/print.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <stdexcept>

namespace bench {

namespace {

std::string
helpOf(const PartProgram& program)
{
  const std::vector<Part>& parts = program.parts;
  std::size_t width = 0;
  for (const Part& part : parts)
    width = std::max(width, part.name.size());
  std::string unusual;
  for (const Part& part : parts)
    if (!part.is_usual)
      unusual += (unusual.empty() ? " but " : ", ") + part.name;
  std::string text = "usage: " + program.name + " [part...] [" + program.seeds_option +
                     " N] [--repeats N]\n\nParts (default: all" + unusual + "):\n";
  for (const Part& part : parts)
    text += "  " + part.name + std::string(width + 2 - part.name.size(), ' ') +
            part.does + "\n";
  const std::string seeds = program.seeds_option + " N";
  return text + "\n  " + seeds + std::string(13 - seeds.size(), ' ') +
         program.seeds_help +
         "\n  --repeats N  runs of which the median time counts (default " +
         std::to_string(program.settings.repeats) +
         ")\n\nReal models are looked for in the folder named by PSR_SHARED_DATA.\n";
}

/** The count that follows an option. \param[in,out] i place of the option, then of the
 * count */
std::size_t
countAfter(const std::vector<std::string>& words, std::size_t& i)
{
  const std::string& option = words[i];
  const std::size_t count = std::stoul(words[++i]);
  if (count == 0)
    throw std::invalid_argument(option + " must be 1 or more");
  return count;
}

/** The parts to be run; none where help is wanted. */
std::vector<Part>
parse(const std::vector<std::string>& words, PartProgram& program)
{
  const std::vector<Part>& parts = program.parts;
  PartSettings& settings = program.settings;
  std::vector<Part> wanted;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool has_value = i + 1 < words.size();
    const auto named = std::find_if(parts.begin(), parts.end(), [&](const Part& part) {
      return part.name == words[i];
    });
    if (words[i] == "--help")
      return {};
    if (words[i] == program.seeds_option && has_value)
      settings.seeds = countAfter(words, i);
    else if (words[i] == "--repeats" && has_value)
      settings.repeats = countAfter(words, i);
    else if (named != parts.end())
      wanted.push_back(*named);
    else
      throw std::invalid_argument("unknown word " + words[i] + ", see --help");
  }
  if (wanted.empty())
    std::copy_if(parts.begin(),
                 parts.end(),
                 std::back_inserter(wanted),
                 [](const Part& part) { return part.is_usual; });
  return wanted;
}

} // namespace

int
runParts(PartProgram program, int argc, char** argv)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  try {
    const std::vector<Part> wanted = parse({argv + 1, argv + argc}, program);
    if (wanted.empty())
      std::cout << helpOf(program);
    for (const Part& part : wanted) {
      part.run(program.settings);
      std::cout << std::endl;
    }
    return 0;
  }
  catch (const std::exception& problem) {
    std::fprintf(stderr, "%s: %s\n", program.name.c_str(), problem.what());
    return 1;
  }
}

} // namespace bench
