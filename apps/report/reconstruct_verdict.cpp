// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how a reconstruction went.
#include "reconstruct_verdict.h"

#include "cli/doubt_words.h"
#include "hole_report.h"
#include "io/point_columns.h"
#include "io/wording.h"
#include "verdict.h"

#include <algorithm>

namespace app {
namespace {

/** Handles, or holes, a point from which noise makes them: thin walls of whole scans
 * have a twentieth of that handles, a sphere with noise of its spacing ten times as
 * many; scans of trees have a quarter of that holes, lines of a scanner with noise of
 * their spacing more than once and a half. */
constexpr double NOISY = 0.004;

/** See mostlyUnused(); earlier stages leave to the base stage what they doubt. */
std::size_t
unusedPoints(const ReconstructSettings& settings, const ReconstructResult& result)
{
  return settings.until == "base"
             ? mostlyUnused(result.start.points, result.usedPlaces())
             : 0;
}

/** The first kind of doubt about the topology, and where one such place is. */
std::string
tellTopologyDoubts(const ReconstructResult& result)
{
  const pcl::TopologyDoubts& doubts = result.chain.doubts;
  DoubtCounts counts = countsOf(doubts);
  if (!doubts.thin_handles.empty())
    counts.handle_at = placeOf(doubts.thin_handles.front(), result.model.mesh);
  if (!doubts.touching_pieces.empty())
    counts.touching_at = placeOf(doubts.touching_pieces.front()[0], result.model.mesh);
  if (!doubts.thin_necks.empty())
    counts.neck_at = placeOf(doubts.thin_necks.front(), result.model.mesh);
  return tellDoubts(counts);
}

/** The first thing that is missing. */
std::string
reasonFor(const ReconstructSettings& settings, const ReconstructResult& result)
{
  if (result.model.mesh.polygons.empty())
    return "no triangle could be made that is sure to be right (too few points, or "
           "all on a line?); the output holds the points alone";
  if (result.filter.one_sided_components > 0)
    return pluralIs(result.filter.one_sided_components, "region") +
           " one-sided (like a Moebius band) and could not be oriented";
  if (const std::size_t unused = unusedPoints(settings, result); unused > 0)
    return tellUnused(unused);
  if (result.repair && !result.repair->complete())
    return tellShortfalls(*result.repair, result.model.mesh);
  return tellTopologyDoubts(result);
}

} // namespace

std::string
adviceFor(const ReconstructSettings& settings, const ReconstructResult& result)
{
  if (settings.clean || settings.until != "base" || !result.topology)
    return "";
  const double many = NOISY * static_cast<double>(result.chain.points);
  const std::size_t loops = result.topology->boundary_loops;
  const std::size_t holes = loops - std::min(loops, result.topology->pieces);
  const char* what = nullptr;
  if (static_cast<double>(result.chain.doubts.handles) > many)
    what = "handles";
  else if (static_cast<double>(holes) > many)
    what = "holes";
  else
    return "";
  return std::string("the ") + what +
         " are so many that the points seem to scatter by more than their distances: "
         "try --clean";
}

std::string
tellIncomplete(const ReconstructSettings& settings, const ReconstructResult& result)
{
  const std::string reason = reasonFor(settings, result);
  const std::string advice = adviceFor(settings, result);
  return reason.empty() || advice.empty() ? reason : reason + "; " + advice;
}

std::string
tellVerdict(const ReconstructSettings& settings, const ReconstructResult& result)
{
  if (settings.dry_run)
    return plural(pointCount(result.model.mesh.cloud), "point") + " to reconstruct";
  if (!settings.hasFilter())
    return "raw triangles";
  SurfaceFacts facts;
  if (result.repair)
    facts = surfaceFacts(*result.repair);
  else
    facts.open = result.topology ? result.topology->boundary_loops : 0;
  facts.has_triangles = !result.model.mesh.polygons.empty();
  facts.faults += result.filter.one_sided_components;
  if (const std::size_t unused = unusedPoints(settings, result); unused > 0)
    addToList(facts.doubts, std::to_string(unused) + " UNUSED_POINTS");
  listDoubts(countsOf(result.chain.doubts), facts.doubts);
  return tellSurface(facts);
}

} // namespace app
