// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: GreedyStart on the points of a cloud, whatever their type.
#include <pcl/surface_ccaa/impl/cloud_runs.h>
#include <pcl/surface_ccaa/impl/point_blocks.h>

#include "greedy/greedy_triangulation.h"
#include "greedy/scan_lines.h"
#include "greedy/usable_points.h"
#include "mesh/block_loop.h"
#include "mesh/curve_order.h"
#include "mesh/polygon_access.h"
#include "run/stage_clock.h"
#include "search/tree_rows.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace pcl::ccaa {
namespace {

/** Neighbors of a point: votes for them are the bits of a word. */
constexpr unsigned int MOST_NEIGHBORS = 64;

/** The name of the first parameter that is out of range, or null. */
const char*
outOfRange(const GreedyParameters& parameters)
{
  const auto is_angle = [](double angle) { return angle >= 0 && angle <= M_PI / 3; };
  if (parameters.neighbors < 3 || parameters.neighbors > MOST_NEIGHBORS)
    return "number of neighbors (3 to 64)";
  if (!is_angle(parameters.minimum_angle))
    return "minimum angle (0 to pi/3 radians)";
  if (!is_angle(parameters.certified_minimum_angle))
    return "certified minimum angle (0 to pi/3 radians)";
  if (!(parameters.length_factor >= 1 && std::isfinite(parameters.length_factor)))
    return "length factor (1 or more)";
  return nullptr;
}

std::string
faultOf(const CloudInput& input, const GreedyParameters& parameters)
{
  if (const char* wrong = outOfRange(parameters))
    return std::string(wrong) + " is out of range";
  return indexFault(*input.selection, input.points.size);
}

/** The usable points and who is near whom; the rows live in either of two stores. */
struct Neighborhoods {
  RankedPoints points;
  NeighborTable table;
  std::vector<index_t> searched;
  NeighborRows rows;
};

class NeighborhoodSearch {
public:
  NeighborhoodSearch(const CloudInput& input,
                     const TreeSearch& search,
                     unsigned int neighbors,
                     const LoopContext& context,
                     GreedyReport& report)
  : input_(input)
  , search_(search)
  , neighbors_(neighbors)
  , context_(context)
  , report_(report)
  {}

  /** \return false when cancelled */
  bool
  find(Neighborhoods& found)
  {
    if (!context_.control->report(context_.stage, 0))
      return false;
    const bool done =
        search_.blocks != nullptr ? searchBlocks(found) : searchTree(found);
    report_.points = found.points.size();
    return done;
  }

private:
  IndicesPtr
  uniqueOf(const std::vector<index_t>& order)
  {
    auto unique = std::make_shared<Indices>(removeDuplicates(input_.points, order));
    report_.skipped_points = input_.selection->size() - order.size();
    report_.duplicate_points = order.size() - unique->size();
    return unique;
  }

  /** All rows at once from the blocks. */
  bool
  searchBlocks(Neighborhoods& found)
  {
    const PointBlocks& blocks = *search_.blocks;
    search_.hold(input_.selection);
    const IndicesPtr unique = uniqueOf(blocks.order());
    if (report_.duplicate_points > 0)
      search_.hold(unique);
    found.points = rankPoints(input_.points, blocks.order(), context_.threads);
    auto table = blocks.allNearest(
        neighbors_, PointBlocks::Distances::OMIT, context_.threads, context_.control);
    if (!table)
      return false;
    found.table = std::move(*table);
    found.rows = {found.table.rows() > 0 ? found.table.row(0) : nullptr,
                  found.table.k()};
    return true;
  }

  /** Point by point, with any search method. */
  bool
  searchTree(Neighborhoods& found)
  {
    const IndicesPtr unique =
        uniqueOf(curveOrder(input_.points, *input_.selection, context_.threads));
    found.points = rankPoints(input_.points, *unique, context_.threads);
    const bool done = searchRows(
        search_, unique, input_.points.size, neighbors_, context_, found.searched);
    found.rows = {found.searched.data(), neighbors_};
    return done;
  }

  const CloudInput& input_;
  const TreeSearch& search_;
  unsigned int neighbors_;
  LoopContext context_;
  GreedyReport& report_;
};

/** Where points lie in lines and see little but their own, twice as many neighbors,
 * until they see the next line; if they never do, as many as there are to be. The
 * algorithm of the thesis does not ask.
 * \return false when cancelled */
bool
searchAcrossLines(const CloudInput& input,
                  const TreeSearch& search,
                  const GreedyParameters& parameters,
                  const LoopContext& context,
                  GreedyReport& report,
                  Neighborhoods& found,
                  ScanLines& lines)
{
  const auto searchFor = [&](unsigned int neighbors) {
    if (!NeighborhoodSearch(input, search, neighbors, context, report).find(found))
      return false;
    if (parameters.certificates)
      lines = findScanLines(found.points, found.rows);
    return true;
  };
  unsigned int neighbors = parameters.neighbors;
  bool done = searchFor(neighbors);
  while (done && lines.is_blind && neighbors < MOST_NEIGHBORS) {
    neighbors = std::min(2 * neighbors, MOST_NEIGHBORS);
    done = searchFor(neighbors);
  }
  if (done && lines.gap == 0.0 && neighbors > parameters.neighbors)
    done = searchFor(parameters.neighbors);
  report.line_gap = lines.gap;
  return done;
}

} // namespace

std::string
runGreedyStart(const CloudInput& input,
               const TreeSearch& search,
               const GreedyParameters& parameters,
               GreedyReport& report,
               std::vector<pcl::Vertices>& polygons)
{
  polygons.clear();
  report = {};
  std::string fault = faultOf(input, parameters);
  if (!fault.empty())
    return fault;
  RunControl control(input.progress);
  const LoopContext context{resolveThreads(input.threads), &control, "neighbors"};
  const StageClock search_clock;
  Neighborhoods found;
  ScanLines lines;
  const bool searched =
      searchAcrossLines(input, search, parameters, context, report, found, lines);
  report.search_seconds = search_clock.seconds();
  const StageClock clock;
  if (searched && report.points < 3)
    fault = std::to_string(report.points) + " usable points, at least 3 are needed";
  if (searched && fault.empty()) {
    const Triangles triangles = greedyTriangulation(
        found.points, found.rows, lines, parameters, context.threads, control, report);
    writePolygons(triangles,
                  found.points.point_indices,
                  LoopContext{context.threads, &control, "polygons"},
                  polygons);
  }
  report.greedy_seconds = clock.seconds();
  report.cancelled = control.cancelled();
  if (report.cancelled)
    polygons.clear();
  return fault;
}

} // namespace pcl::ccaa
