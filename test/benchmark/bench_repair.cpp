// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: benchmark of the repair of incomplete models.

#include <pcl/console/print.h>

#include "fairing_table.h"
#include "free_point_table.h"
#include "junction_table.h"
#include "repair_cases_table.h"
#include "repair_error_table.h"
#include "repair_time_table.h"
#include "sides_table.h"
#include "topology_table.h"

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
    "usage: bench_repair [part...] [--seeds N] [--repeats N]\n"
    "\n"
    "Parts (default: all but fuzz):\n"
    "  junctions  generated damages and scenes: how many junctions are judged right\n"
    "  cases   damaged shapes whose repair is known: how many come out right\n"
    "  thesis  table T4.8-1: the Bunny and a woman's body, light and full mode\n"
    "  bunny   the Bunny cut by five slabs, without and with free points: error\n"
    "  sphere  a sphere in four pieces with small gaps: error\n"
    "  curved  fairing alone, then one hole of 600 edges, beside CGAL's filling\n"
    "  growth  time against the length of all boundaries\n"
    "  large   ten holes in 5 million triangles beside reading the adjacency\n"
    "  scans   range maps, scenes, rooms, terrain: one thread and two\n"
    "  gaps    the longest time in which these cannot be cancelled\n"
    "  many    100 to 10 000 holes in 4 million triangles, one thread and two\n"
    "  long    one hole of up to 2 000 edges in 2 million triangles\n"
    "  sides   scenes from one side: what of them faces the sensor\n"
    "  topology  closed models that lose parts: how many get their topology back\n"
    "  free    what sparse free points of lost parts do, and what they cost\n"
    "  fuzz    random damage to random shapes: whether anything goes wrong\n"
    "\n"
    "  --seeds N    seeds of cases and sides, places of curved (default 5), seeds of "
    "topology (1), of fuzz (1000)\n"
    "  --repeats N  runs of which the median time counts (default 3)\n"
    "\n"
    "Real models are looked for in the folder named by PSR_SHARED_DATA.\n";

const std::array<std::string, 16> PARTS = {"junctions",
                                           "scans",
                                           "cases",
                                           "thesis",
                                           "bunny",
                                           "sphere",
                                           "curved",
                                           "growth",
                                           "large",
                                           "gaps",
                                           "many",
                                           "long",
                                           "sides",
                                           "topology",
                                           "free",
                                           "fuzz"};

struct Settings {
  std::vector<std::string> parts;
  std::uint64_t seeds = 0; /**< 0: the default of the part */
  std::size_t repeats = 3;
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
    else if (word == "--seeds" && i + 1 < argc)
      settings.seeds = std::stoul(argv[++i]);
    else if (word == "--repeats" && i + 1 < argc)
      settings.repeats = std::stoul(argv[++i]);
    else if (std::find(PARTS.begin(), PARTS.end(), word) != PARTS.end())
      settings.parts.push_back(word);
    else
      throw std::invalid_argument("unknown word " + word + ", see --help");
  }
  if (settings.repeats == 0)
    throw std::invalid_argument("--repeats must be 1 or more");
  if (settings.parts.empty())
    settings.parts.assign(PARTS.begin(), PARTS.end() - 1);
  return settings;
}

void
run(const std::string& part, const Settings& settings)
{
  if (part == "cases")
    bench::printRepairCases(std::cout, settings.seeds == 0 ? 5 : settings.seeds);
  else if (part == "junctions")
    bench::printJunctionTable(std::cout, settings.seeds == 0 ? 40 : settings.seeds);
  else if (part == "thesis")
    bench::printThesisTable(std::cout, settings.repeats);
  else if (part == "bunny")
    bench::printRepairedBunny(std::cout, settings.repeats);
  else if (part == "sphere")
    bench::printRepairedSphere(std::cout);
  else if (part == "curved") {
    bench::printFairingTable(std::cout, settings.seeds == 0 ? 5 : settings.seeds);
    bench::printCurvedHoles(std::cout, settings.repeats);
  }
  else if (part == "growth")
    bench::printRepairGrowth(std::cout, settings.repeats);
  else if (part == "large")
    bench::printLargeRepair(std::cout, settings.repeats);
  else if (part == "scans")
    bench::printScans(std::cout, settings.repeats);
  else if (part == "gaps")
    bench::printGaps(std::cout);
  else if (part == "many")
    bench::printManyHoles(std::cout, settings.repeats);
  else if (part == "long")
    bench::printLongHoles(std::cout, settings.repeats);
  else if (part == "topology")
    bench::printTopologyTable(std::cout, settings.seeds == 0 ? 1 : settings.seeds);
  else if (part == "free")
    bench::printFreePointTable(std::cout);
  else if (part == "sides")
    bench::printSides(std::cout, settings.seeds == 0 ? 5 : settings.seeds);
  else
    bench::printRepairFuzz(std::cout, settings.seeds == 0 ? 1000 : settings.seeds);
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
      for (const std::string& part : settings.parts) {
        run(part, settings);
        std::cout << std::endl;
      }
  }
  catch (const std::exception& problem) {
    std::fprintf(stderr, "bench_repair: %s\n", problem.what());
    return 1;
  }
}
