// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: benchmark of what is understood of an incomplete model.

#include "boundary_times.h"
#include "classification_truth.h"
#include "closed_models.h"
#include "field_speed.h"
#include "line_table.h"
#include "orientation_table.h"
#include "parts.h"

#include <iostream>

using namespace bench;

namespace {

/** The Bunny with every fifth of the lost points left as a free point. */
FieldCase
bunnyCase()
{
  return slabbedMesh(sharedFile("bunny/bun_zipper.ply"), 5);
}

void
printField(std::size_t repeats)
{
  for (const FieldCase& field_case : {facingRings(), bunnyCase()})
    printLightField(field_case,
                    measureLightField(field_case, static_cast<int>(repeats)));
}

const std::vector<Part> PARTS = {
    {"classification",
     "loops of damaged closed models and of files whose truth is clear",
     [](const PartSettings& by) {
       printClassificationTable(std::cout, by.seedsOr(10));
     }},
    {"boundaries",
     "what the boundary integral of long boundaries costs",
     [](const PartSettings&) { printBoundaryTimes(std::cout); }},
    {"orientation",
     "islands of damaged closed models, turned at random",
     [](const PartSettings& by) { printOrientationTable(std::cout, by.seedsOr(10)); }},
    {"field",
     "source-point pairs a second, light mode, one thread",
     [](const PartSettings& by) { printField(by.repeats); }},
    {"modes",
     "full mode against light mode on the Bunny cut by slabs",
     [](const PartSettings& by) {
       printFullField(bunnyCase(),
                      measureFullField(bunnyCase(), static_cast<int>(by.repeats)));
     }},
    {"lines",
     "force lines between two caps of a sphere: drift and time",
     [](const PartSettings&) { printLineTable(std::cout); }}};

} // namespace

int
main(int argc, char** argv)
{
  return runParts({"bench_field",
                   PARTS,
                   "--rounds",
                   "rounds of seeded damage of each model (default 10)",
                   {0, 5}},
                  argc,
                  argv);
}
