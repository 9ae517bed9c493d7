// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the line in which a run says how it went.
#include "verdict.h"

#include <pcl/surface_repair/repair_report.h>

#include "repair_details.h"
#include "wording.h"

namespace app {

std::string
tellSurface(const SurfaceFacts& facts)
{
  if (!facts.has_triangles)
    return "no triangles";
  std::string text;
  const auto tell = [&](const std::string& what) {
    text += (text.empty() ? "" : ", ") + what;
  };
  if (facts.left_open > 0)
    tell(plural(facts.left_open, "boundary") + " left open" +
         (facts.reasons.empty() ? "" : " (" + facts.reasons + ")"));
  if (facts.open > 0)
    tell(plural(facts.open, "border") + " open");
  if (facts.faults > 0)
    tell(plural(facts.faults, "fault"));
  if (text.empty())
    tell("watertight");
  if (facts.pieces)
    tell(plural(*facts.pieces, "piece"));
  return text;
}

SurfaceFacts
surfaceFacts(const pcl::RepairReport& report)
{
  SurfaceFacts facts;
  Tally reasons;
  for (const pcl::RepairedHole& hole : report.holes) {
    const bool is_open = hole.open != pcl::OpenReason::NONE;
    const bool is_left = hole.shortfall;
    facts.left_open += is_left ? 1 : 0;
    facts.open += is_open && !is_left ? 1 : 0;
    if (is_left)
      reasons.add(nameOf(hole.open));
  }
  facts.reasons = reasons.text();
  facts.pieces = report.counts_after.islands;
  return facts;
}

} // namespace app
