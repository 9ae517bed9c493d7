// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the proof that what is written is a manifold.

#include "verification/last_check.h"

#include <pcl/surface_repair/repair_parameters.h>

#include "icadm/icm_class.h"
#include "icadm/model_assembly.h"
#include "icadm/pinched_points.h"
#include "mesh/surface_topology.h"
#include "mesh/winding.h"

#include <algorithm>
#include <set>

namespace pcl::repair {

namespace {

/** What is wrong with a mesh. */
struct Faults {
  std::set<std::size_t> holes; /**< the one that was closed last at each place */
  bool is_in_input = false;    /**< some place has no new triangle */
};

class LastCheck {
public:
  LastCheck(const RepairedModel& repaired, const RepairReport& report)
  : model_(repaired.model)
  , input_triangles_(static_cast<pcl::index_t>(repaired.input_triangles))
  , hole_of_(report.hole_of)
  {}

  Faults
  run()
  {
    const auto& adjacency = model_.adjacency;
    for (std::size_t e = 0; e < adjacency.overfullEdges().size(); ++e)
      blame(adjacency.beginOverfull(e), adjacency.endOverfull(e));
    for (std::size_t v = 0; v < adjacency.vertexCount(); ++v) {
      const auto vertex = static_cast<pcl::index_t>(v);
      if (adjacency.fan(vertex) == ccaa::Fan::SEVERAL)
        blame(adjacency.begin(vertex), adjacency.end(vertex));
    }
    for (std::size_t t = hole_of_.size(); t-- > 0 && isNew(index(t));)
      checkWinding(index(t));
    return std::move(faults_);
  }

private:
  static pcl::index_t
  index(std::size_t triangle)
  {
    return static_cast<pcl::index_t>(triangle);
  }

  bool
  isNew(pcl::index_t triangle) const
  {
    return triangle >= input_triangles_;
  }

  /** Of ascending triangles the last one is of the hole that was closed last. */
  void
  blame(const pcl::index_t* begin, const pcl::index_t* end)
  {
    const pcl::index_t last = *std::max_element(begin, end);
    if (isNew(last))
      faults_.holes.insert(hole_of_[static_cast<std::size_t>(last)]);
    else
      faults_.is_in_input = true;
  }

  void
  checkWinding(pcl::index_t triangle)
  {
    for (int corner = 0; corner < 3; ++corner)
      if (model_.adjacency.across(triangle, corner) < triangle &&
          ccaa::disagreesAcross(model_.triangles, model_.adjacency, triangle, corner))
        faults_.holes.insert(hole_of_[static_cast<std::size_t>(triangle)]);
  }

  const IncompleteModel& model_;
  pcl::index_t input_triangles_;
  const std::vector<std::size_t>& hole_of_;
  Faults faults_;
};

void
takeBack(const std::set<std::size_t>& holes,
         const ccaa::LoopContext& context,
         IncompleteModel& model,
         RepairReport& report)
{
  std::size_t left = 0;
  for (std::size_t t = 0; t < model.triangles.size(); ++t) {
    if (holes.count(report.hole_of[t]) > 0)
      continue;
    model.triangles[left] = model.triangles[t];
    report.hole_of[left] = report.hole_of[t];
    report.origins[left++] = report.origins[t];
  }
  model.triangles.resize(left);
  rebuildAdjacency(context, model);
  report.hole_of.resize(left);
  report.origins.resize(left);
  for (const std::size_t hole : holes) {
    RepairedHole& entry = report.holes[hole];
    entry.open = OpenReason::NOT_MANIFOLD;
    entry.filling.clear();
    entry.triangles = 0;
    entry.shortfall = true;
    ++report.shortfalls;
    ++(entry.edges <= SIMPLE_HOLE_EDGES ? report.counts_after.simple_holes
                                        : report.counts_after.complex_holes);
  }
}

/** Leave out vertices without a triangle, and give each fan one of its own. */
void
settleVertices(const ccaa::LoopContext& context, RepairedModel& repaired)
{
  const std::vector<pcl::index_t> number = separatePinches(context, repaired.model);
  const auto of_input =
      number.begin() + static_cast<std::ptrdiff_t>(repaired.input_vertices);
  repaired.input_vertices -=
      static_cast<std::size_t>(std::count(number.begin(), of_input, pcl::UNAVAILABLE));
}

} // namespace

bool
proveManifold(const ccaa::LoopContext& context,
              RepairedModel& repaired,
              RepairReport& report)
{
  IncompleteModel& model = repaired.model;
  bool is_settled = true;
  bool was_settled = false;
  while (!context.cancelled()) {
    const Faults faults = LastCheck(repaired, report).run();
    if (!faults.holes.empty()) {
      takeBack(faults.holes, context, model, report);
      is_settled = false;
      continue;
    }
    if (is_settled && !faults.is_in_input)
      break;
    if (was_settled)
      return false;
    settleVertices(context, repaired);
    is_settled = was_settled = true;
  }
  if (context.cancelled())
    return false;
  model.island_of = ccaa::labelIslands(model.adjacency, {context.threads});
  report.after = ccaa::topologyOf(
      model.triangles, model.adjacency, model.island_of.count, {context.threads});
  report.counts_after.islands = report.after.pieces;
  report.class_after = classOf(report.counts_after);
  return true;
}

} // namespace pcl::repair
