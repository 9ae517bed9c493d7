// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: benchmark of what is understood of an incomplete model.

#include <pcl/console/print.h>

#include "boundary_times.h"
#include "classification_truth.h"
#include "closed_models.h"
#include "field_speed.h"
#include "line_table.h"
#include "orientation_table.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr const char* HELP =
    "usage: bench_field [part...] [--rounds N] [--repeats N]\n"
    "\n"
    "Parts (default: all):\n"
    "  classification  loops of damaged closed models and of files whose truth is "
    "clear\n"
    "  orientation     islands of damaged closed models, turned at random\n"
    "  boundaries      what the boundary integral of long boundaries costs\n"
    "  field           source-point pairs a second, light mode, one thread\n"
    "  modes           full mode against light mode on the Bunny cut by slabs\n"
    "  lines           force lines between two caps of a sphere: drift and time\n"
    "\n"
    "  --rounds N   rounds of seeded damage of each model (default 10)\n"
    "  --repeats N  runs of which the median time counts (default 5)\n"
    "\n"
    "Real models are looked for in the folder named by PSR_SHARED_DATA.\n";

const std::array<std::string, 6> PARTS = {
    "classification", "boundaries", "orientation", "field", "modes", "lines"};

struct Settings {
  std::vector<std::string> parts;
  std::uint64_t rounds = 10;
  std::size_t repeats = 5;
  bool help = false;
};

Settings
parse(int argc, char** argv)
{
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--help")
      settings.help = true;
    else if (word == "--rounds" && i + 1 < argc)
      settings.rounds = std::stoul(argv[++i]);
    else if (word == "--repeats" && i + 1 < argc)
      settings.repeats = std::stoul(argv[++i]);
    else if (std::find(PARTS.begin(), PARTS.end(), word) != PARTS.end())
      settings.parts.push_back(word);
    else
      throw std::invalid_argument("unknown word " + word + ", see --help");
  }
  if (settings.rounds == 0 || settings.repeats == 0)
    throw std::invalid_argument("--rounds and --repeats must be 1 or more");
  if (settings.parts.empty())
    settings.parts.assign(PARTS.begin(), PARTS.end());
  return settings;
}

/** The Bunny with every fifth of the lost points left as a free point. */
bench::FieldCase
bunnyCase()
{
  return bench::slabbedMesh(bench::sharedFile("bunny/bun_zipper.ply"), 5);
}

void
printField(std::size_t repeats)
{
  for (const bench::FieldCase& field_case : {bench::facingRings(), bunnyCase()})
    bench::printLightField(
        field_case, bench::measureLightField(field_case, static_cast<int>(repeats)));
}

void
run(const Settings& settings)
{
  const int repeats = static_cast<int>(settings.repeats);
  for (const std::string& part : settings.parts) {
    if (part == "classification")
      bench::printClassificationTable(std::cout, settings.rounds);
    else if (part == "boundaries")
      bench::printBoundaryTimes(std::cout);
    else if (part == "orientation")
      bench::printOrientationTable(std::cout, settings.rounds);
    else if (part == "field")
      printField(settings.repeats);
    else if (part == "modes")
      bench::printFullField(bunnyCase(), bench::measureFullField(bunnyCase(), repeats));
    else
      bench::printLineTable(std::cout);
    std::cout << std::endl;
  }
}

} // namespace

int
main(int argc, char** argv)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  try {
    const Settings settings = parse(argc, argv);
    if (settings.help)
      std::printf("%s", HELP);
    else
      run(settings);
  }
  catch (const std::exception& problem) {
    std::fprintf(stderr, "bench_field: %s\n", problem.what());
    return 1;
  }
}
