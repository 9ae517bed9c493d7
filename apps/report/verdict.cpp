// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the line in which a run says how it went.
#include "verdict.h"

#include <pcl/surface_repair/repair_report.h>

#include "io/wording.h"
#include "repair_details.h"

#include <algorithm>

namespace app {

std::string
tellSurface(const SurfaceFacts& facts)
{
  if (!facts.has_triangles)
    return "no triangles";
  std::string text;
  if (facts.left_open > 0)
    addToList(text,
              plural(facts.left_open, "boundary") + " left open" +
                  (facts.reasons.empty() ? "" : " (" + facts.reasons + ")"));
  if (facts.borders > 0)
    addToList(text, plural(facts.borders, "border") + " open");
  if (facts.open > 0)
    addToList(text, plural(facts.open, "boundary") + " open");
  if (facts.faults > 0)
    addToList(text, plural(facts.faults, "fault"));
  if (text.empty())
    addToList(text, "watertight");
  if (facts.pieces)
    addToList(text, plural(*facts.pieces, "piece"));
  if (!facts.doubts.empty())
    addToList(text, "in doubt (" + facts.doubts + ")");
  return text;
}

SurfaceFacts
surfaceFacts(const pcl::RepairReport& report)
{
  SurfaceFacts facts;
  Tally reasons;
  for (const pcl::RepairedHole& hole : report.holes) {
    if (!hole.shortfall)
      continue;
    ++facts.left_open;
    reasons.add(nameOf(hole.open));
  }
  // The rims of what was cut off on reading are no holes, but openings all the same.
  const std::size_t openings = report.after.boundary_loops;
  facts.borders = openings - std::min(openings, facts.left_open);
  facts.reasons = reasons.text();
  Tally doubts;
  for (const pcl::RepairDoubt& doubt : report.doubts)
    doubts.add(nameOf(doubt.reason));
  facts.doubts = doubts.text();
  facts.pieces = report.counts_after.islands;
  return facts;
}

} // namespace app
