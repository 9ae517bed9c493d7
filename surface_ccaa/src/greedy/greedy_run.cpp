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

/** The name of the first parameter that is out of range, or null. */
const char*
outOfRange(const GreedyParameters& parameters)
{
  const auto is_angle = [](double angle) { return angle >= 0 && angle <= M_PI / 3; };
  if (parameters.neighbors < 3 || parameters.neighbors > NeighborRows::MOST)
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
  ScanLines lines;
};

class NeighborhoodSearch {
public:
  NeighborhoodSearch(const CloudInput& input,
                     const TreeSearch& search,
                     const LoopContext& context,
                     GreedyReport& report)
  : input_(input), search_(search), context_(context), report_(report)
  {}

  /** Where points lie in lines and see little but their own, twice as many neighbors,
   * until they see the next line; if they never do, as many as there are to be. The
   * algorithm of the thesis does not ask.
   * \return false when cancelled */
  bool
  find(const GreedyParameters& parameters, Neighborhoods& found)
  {
    if (!context_.control->report(context_.stage, 0))
      return false;
    rank(found.points);
    report_.points = found.points.size();
    const auto findAmong = [&](unsigned int neighbors) {
      if (!findRows(neighbors, found))
        return false;
      if (parameters.certificates)
        found.lines = findScanLines(found.points, found.rows);
      return true;
    };
    unsigned int neighbors = parameters.neighbors;
    bool done = findAmong(neighbors);
    while (done && found.lines.is_blind && neighbors < NeighborRows::MOST) {
      neighbors = std::min(2 * neighbors, NeighborRows::MOST);
      done = findAmong(neighbors);
    }
    if (done && found.lines.gap == 0.0 && neighbors > parameters.neighbors)
      done = findAmong(parameters.neighbors);
    report_.line_gap = found.lines.gap;
    return done;
  }

private:
  void
  rank(RankedPoints& points)
  {
    if (search_.blocks == nullptr) {
      keepUnique(curveOrder(input_.points, *input_.selection, context_.threads));
      points = rankPoints(input_.points, *unique_, context_.threads);
      return;
    }
    search_.hold(input_.selection);
    keepUnique(search_.blocks->order());
    if (report_.duplicate_points > 0)
      search_.hold(unique_);
    points = rankPoints(input_.points, search_.blocks->order(), context_.threads);
  }

  void
  keepUnique(const std::vector<index_t>& order)
  {
    unique_ = std::make_shared<Indices>(removeDuplicates(input_.points, order));
    report_.skipped_points = input_.selection->size() - order.size();
    report_.duplicate_points = order.size() - unique_->size();
  }

  /** All at once from the blocks, or point by point with any search method. */
  bool
  findRows(unsigned int neighbors, Neighborhoods& found)
  {
    if (search_.blocks == nullptr) {
      const bool done = searchRows(
          search_, unique_, input_.points.size, neighbors, context_, found.searched);
      found.rows = {found.searched.data(), neighbors};
      return done;
    }
    auto table = search_.blocks->allNearest(
        neighbors, PointBlocks::Distances::OMIT, context_.threads, context_.control);
    if (!table)
      return false;
    found.table = std::move(*table);
    found.rows = {found.table.rows() > 0 ? found.table.row(0) : nullptr,
                  found.table.k()};
    return true;
  }

  const CloudInput& input_;
  const TreeSearch& search_;
  LoopContext context_;
  GreedyReport& report_;
  IndicesPtr unique_; /**< usable points, one per place */
};

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
  const bool searched =
      NeighborhoodSearch(input, search, context, report).find(parameters, found);
  report.search_seconds = search_clock.seconds();
  const StageClock clock;
  if (searched && report.points < 3)
    fault = std::to_string(report.points) + " usable points, at least 3 are needed";
  if (searched && fault.empty()) {
    Triangles triangles = greedyTriangulation(found.points,
                                              found.rows,
                                              found.lines,
                                              parameters,
                                              context.threads,
                                              control,
                                              report);
    handOut(std::move(triangles),
            found.points.point_indices,
            LoopContext{context.threads, &control, "polygons"},
            input.handoff,
            polygons);
  }
  report.greedy_seconds = clock.seconds();
  report.cancelled = control.cancelled();
  if (report.cancelled)
    polygons.clear();
  return fault;
}

} // namespace pcl::ccaa
