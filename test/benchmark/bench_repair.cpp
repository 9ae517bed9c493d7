// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: benchmark of the repair of incomplete models.

#include "fairing_table.h"
#include "free_point_table.h"
#include "junction_table.h"
#include "parts.h"
#include "repair_cases_table.h"
#include "repair_error_table.h"
#include "repair_time_table.h"
#include "sides_table.h"
#include "topology_table.h"

#include <iostream>

using namespace bench;

namespace {

const std::vector<Part> PARTS = {
    {"junctions",
     "generated damages and scenes: how many junctions are judged right",
     [](const PartSettings& by) { printJunctionTable(std::cout, by.seedsOr(40)); }},
    {"scans",
     "range maps, scenes, rooms, terrain: one thread and two",
     [](const PartSettings& by) { printScans(std::cout, by.repeats); }},
    {"cases",
     "damaged shapes whose repair is known: how many come out right",
     [](const PartSettings& by) { printRepairCases(std::cout, by.seedsOr(5)); }},
    {"thesis",
     "table T4.8-1: the Bunny and a woman's body, light and full mode",
     [](const PartSettings& by) { printThesisTable(std::cout, by.repeats); }},
    {"bunny",
     "the Bunny cut by five slabs, without and with free points: error",
     [](const PartSettings& by) { printRepairedBunny(std::cout, by.repeats); }},
    {"sphere",
     "a sphere in four pieces with small gaps: error",
     [](const PartSettings&) { printRepairedSphere(std::cout); }},
    {"curved",
     "fairing alone, then one hole of 600 edges, beside CGAL's filling",
     [](const PartSettings& by) {
       printFairingTable(std::cout, by.seedsOr(5));
       printCurvedHoles(std::cout, by.repeats);
     }},
    {"growth",
     "time against the length of all boundaries",
     [](const PartSettings& by) { printRepairGrowth(std::cout, by.repeats); }},
    {"large",
     "ten holes in 5 million triangles beside reading the adjacency",
     [](const PartSettings& by) { printLargeRepair(std::cout, by.repeats); }},
    {"gaps",
     "the longest time in which these cannot be cancelled",
     [](const PartSettings&) { printGaps(std::cout); }},
    {"many",
     "100 to 10 000 holes in 4 million triangles, one thread and two",
     [](const PartSettings& by) { printManyHoles(std::cout, by.repeats); }},
    {"long",
     "one hole of up to 2 000 edges in 2 million triangles",
     [](const PartSettings& by) { printLongHoles(std::cout, by.repeats); }},
    {"sides",
     "scenes from one side: what of them faces the sensor",
     [](const PartSettings& by) { printSides(std::cout, by.seedsOr(5)); }},
    {"topology",
     "closed models that lose parts: how many get their topology back",
     [](const PartSettings& by) { printTopologyTable(std::cout, by.seedsOr(1)); }},
    {"free",
     "what sparse free points of lost parts do, and what they cost",
     [](const PartSettings&) { printFreePointTable(std::cout); }},
    {"fuzz",
     "random damage to random shapes: whether anything goes wrong",
     [](const PartSettings& by) { printRepairFuzz(std::cout, by.seedsOr(1000)); },
     false}};

} // namespace

int
main(int argc, char** argv)
{
  return runParts({"bench_repair",
                   PARTS,
                   "--seeds",
                   "seeds of junctions (40), cases and sides (5), topology (1), fuzz "
                   "(1000), places of curved (5)",
                   {}},
                  argc,
                  argv);
}
