// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm on index triangles (thesis 3.1, 3.5).
#include "advancing_front/surface_completion.h"

#include "advancing_front/fan_settlement.h"
#include "advancing_front/local_regrowth.h"
#include "advancing_front/new_islands.h"
#include "advancing_front/spacing.h"
#include "advancing_front/tuning.h"
#include "advancing_front/tunnels.h"
#include "mesh/block_loop.h"
#include "mesh/orientation.h"
#include "mesh/polygon_access.h"
#include "mesh/sort_unique.h"

#include <optional>
#include <utility>

namespace pcl::ccaa {
namespace {

/** One run, stage by stage. */
class Completion {
public:
  Completion(PartialMesh& mesh,
             const Reopening& reopening,
             const NeighborSearch& search,
             const CompletionParameters& parameters,
             int threads,
             RunControl& control,
             CompletionReport& report)
  : mesh_(mesh)
  , reopening_(reopening)
  , search_(search)
  , parameters_(parameters)
  , context_{threads, &control, "partial mesh"}
  , control_(control)
  , report_(report)
  {}

  /** \return nothing of use after cancelling */
  CompletedMesh
  run();

private:
  void
  read();
  void
  findOpenPoints();
  bool
  searchOpenPoints();
  void
  openSurface();
  bool
  doubtCrossings();
  void
  advanceFront();
  void
  regrowObstructed();
  std::vector<pcl::index_t>
  settleFansAndCrossings();
  void
  settle();
  void
  keepLargeComponents();
  void
  orient();

  ComponentRule
  componentRule() const
  {
    return {parameters_.minimum_internal_points, given_.doubts.typical_fold};
  }

  PartialMesh& mesh_;
  const Reopening& reopening_;
  const NeighborSearch& search_;
  const CompletionParameters& parameters_;
  LoopContext context_;
  RunControl& control_;
  CompletionReport& report_;
  GivenSurface given_;
  std::vector<pcl::index_t> open_, table_; /**< open points with their neighbors */
  std::optional<PartialSurface> surface_;
  Gap gap_;
  std::vector<pcl::index_t> watched_; /**< points at which given triangles may cross */
  std::optional<NearbyTriangles> nearby_;
  std::vector<pcl::index_t> obstructed_;
  TriangleAdjacency adjacency_; /**< of the result */
  LastingPieces pieces_;
  CompletedMesh result_;
};

CompletedMesh
Completion::run()
{
  for (const auto stage : {&Completion::read,
                           &Completion::findOpenPoints,
                           &Completion::advanceFront,
                           &Completion::regrowObstructed,
                           &Completion::settle,
                           &Completion::keepLargeComponents,
                           &Completion::orient}) {
    (this->*stage)();
    if (result_.fault != PartialMeshFault::NONE || control_.cancelled())
      break;
  }
  return std::move(result_);
}

void
Completion::read()
{
  report_.given_triangles = mesh_.given.size();
  if (mesh_.viewpoints.empty())
    takeOrigin(mesh_.sides, mesh_.points);
  given_ = readGiven(mesh_, reopening_, parameters_.keep_given, context_);
  result_.fault = given_.fault;
}

bool
Completion::searchOpenPoints()
{
  open_ = openVertices(mesh_, given_, reopening_);
  report_.open_points = open_.size();
  return control_.report("partial mesh", 0.9) &&
         search_(open_, parameters_.neighbors, table_) && !control_.cancelled();
}

/** And lets islands agree before they are joined. */
void
Completion::findOpenPoints()
{
  if (searchOpenPoints() && !reopening_.isWound())
    alignGiven(mesh_, given_, open_, table_, context_);
}

void
Completion::openSurface()
{
  surface_.emplace(
      mesh_.given, given_.adjacency, mesh_.points, hintsOf(mesh_, context_.threads));
  for (const pcl::index_t t : given_.doubts.triangles)
    surface_->remove(t);
  surface_->setLargestRoom(largestRoom(*surface_, mesh_.given, mesh_.points));
  const double spacing = usualSpacing(mesh_.given, mesh_.points);
  gap_ = openGap(*surface_,
                 std::move(open_),
                 std::move(table_),
                 spacing,
                 parameters_.neighbors,
                 search_,
                 &control_);
  watched_ = surface_->verticesAround(reopening_.handles, tuning::RINGS + 1);
  watched_.insert(watched_.end(), gap_.open.begin(), gap_.open.end());
  for (const pcl::index_t t : std::exchange(given_.doubts.folded, {}))
    watched_.insert(watched_.end(),
                    mesh_.given[static_cast<std::size_t>(t)].begin(),
                    mesh_.given[static_cast<std::size_t>(t)].end());
  sortUnique(watched_);
  if (!control_.cancelled())
    nearby_.emplace(mesh_.given,
                    surface_->aliveGiven(),
                    mesh_.points,
                    watched_,
                    cellSize(gap_.surface, spacing),
                    context_.threads);
}

/** Umbrellas tell the neighbors of a point alone: given triangles may cross others.
 * Those that do have an open corner, or an edge that folds sharply, which is asked
 * once: \return whether any do */
bool
Completion::doubtCrossings()
{
  if (control_.cancelled() || parameters_.keep_given || reopening_.is_again)
    return false;
  const std::vector<pcl::index_t> crossing =
      nearby_->crossingAt(watched_, mesh_.points.size(), context_);
  std::vector<pcl::index_t>& doubts = given_.doubts.triangles;
  doubts.insert(doubts.end(), crossing.begin(), crossing.end());
  sortUnique(doubts);
  return !crossing.empty();
}

void
Completion::advanceFront()
{
  openSurface();
  while (doubtCrossings() && searchOpenPoints()) // each time there are more in doubt
    openSurface();
  watched_ = {};
  if (control_.cancelled())
    return;
  const LoopContext growth{context_.threads, &control_, "growth"};
  obstructed_ =
      growInto(gap_, *nearby_, parameters_, componentRule(), growth, *surface_);
}

void
Completion::regrowObstructed()
{
  LocalRegrowth regrowth(
      *surface_, gap_.surface, gap_.vertices, *nearby_, parameters_, componentRule());
  if (reopening_.is_again && reopening_.triangles.empty())
    regrowth.run(reopening_.handles, LocalRegrowth::Aim::OPEN_HANDLES, context_);
  else
    regrowth.run(obstructed_, LocalRegrowth::Aim::CLOSE, context_);
}

/** \return where the surface is open beside what growth has changed, without cut
 * points, ascending */
std::vector<pcl::index_t>
Completion::settleFansAndCrossings()
{
  dropCrossings(*surface_, mesh_.points, context_);
  const std::vector<pcl::index_t> touched =
      touchedVertices(*surface_, gap_.open, &control_);
  const std::vector<pcl::index_t> gone =
      settleFans(*surface_, touched, parameters_.keep_given, &control_);
  std::vector<pcl::index_t> corners;
  for (const pcl::index_t vertex : touched)
    if (!mesh_.isCut(vertex) && surface_->isBorder(vertex))
      corners.push_back(vertex);
  for (const pcl::index_t t : gone)
    for (const pcl::index_t corner : (*surface_)[t])
      if (!mesh_.isCut(corner))
        corners.push_back(corner);
  sortUnique(corners);
  return corners;
}

/** One fan for every point, and no crossings; where a fan went, the hole is closed on
 * the side where it was. Then the triangles that there are, and nothing that only
 * growth needs. */
void
Completion::settle()
{
  if (closeBetween(
          settleFansAndCrossings(), gap_, *nearby_, parameters_, *surface_, &control_))
    settleFansAndCrossings();
  nearby_.reset();
  gap_ = {};
  const AliveFlags alive = surface_->aliveGiven();
  result_.triangles = liveTriangles(mesh_.given, alive, context_);
  result_.kept.reserve(result_.triangles.size());
  for (std::size_t t = 0; t < alive.size(); ++t)
    if (alive[t] != 0)
      result_.kept.push_back(static_cast<pcl::index_t>(t));
  for (std::size_t t = alive.size(); t < surface_->triangleCount(); ++t)
    if (surface_->isAlive(static_cast<pcl::index_t>(t)))
      result_.triangles.push_back((*surface_)[static_cast<pcl::index_t>(t)]);
  adjacency_ = std::move(given_.adjacency);
  surface_.reset();
  adjacency_.follow(
      alive, result_.triangles, mesh_.points.size(), context_.threads, &control_);
}

/** Growth and local regrowth may leave pieces behind that are cut off from the rest
 * (C3.4-3). */
void
Completion::keepLargeComponents()
{
  pieces_ = lastingPieces(adjacency_,
                          parameters_.keep_given ? result_.kept.size() : 0,
                          parameters_.minimum_internal_points,
                          {context_.threads});
  std::size_t left = 0, kept = 0;
  for (std::size_t t = 0; t < result_.triangles.size(); ++t) {
    if (pieces_.flags[t] == 0)
      continue;
    if (t < result_.kept.size())
      result_.kept[kept++] = result_.kept[t];
    result_.triangles[left++] = result_.triangles[t];
  }
  result_.triangles.resize(left);
  result_.kept.resize(kept);
  report_.kept_triangles = kept;
  report_.new_triangles = left - kept;
  if (left < pieces_.flags.size())
    adjacency_.follow(pieces_.flags,
                      result_.triangles,
                      mesh_.points.size(),
                      context_.threads,
                      &control_);
}

/** The whole, outward where that can be told. One piece that grew from one is wound as
 * that was. */
void
Completion::orient()
{
  for (const Fan fan : adjacency_.fans())
    report_.free_points += fan == Fan::NONE;
  if (!reopening_.isWound() || pieces_.count > 1)
    report_.sides = orientTriangles(result_.triangles,
                                    adjacency_,
                                    mesh_.points,
                                    hintsOf(mesh_, context_.threads),
                                    control_)
                        .tally;
  result_.typical_fold = given_.doubts.typical_fold;
  if (parameters_.keep_given)
    return;
  result_.topology =
      topologyOf(result_.triangles, adjacency_, pieces_.count, {context_.threads});
  result_.adjacency = std::move(adjacency_);
}

} // namespace

CompletedMesh
completeSurface(PartialMesh mesh,
                const NeighborSearch& search,
                const CompletionParameters& parameters,
                int threads,
                RunControl& control,
                CompletionReport& report)
{
  const auto complete = [&](PartialMesh part,
                            const Reopening& reopening,
                            std::uint64_t most_work,
                            CompletionReport& counts) {
    RunControl budget(&control, most_work);
    CompletedMesh completed =
        Completion(part, reopening, search, parameters, threads, budget, counts).run();
    counts.cancelled = budget.cancelled();
    return completed;
  };
  const std::uint64_t before = control.work();
  CompletedMesh result =
      Completion(mesh, {}, search, parameters, threads, control, report).run();
  const std::uint64_t work = control.work() - before;
  if (!parameters.keep_given && result.fault == PartialMeshFault::NONE)
    openTunnels(std::move(mesh),
                complete,
                work,
                {threads, &control, "partial mesh"},
                result,
                report);
  result.adjacency = {}; // nobody needs its memory any more
  report.cancelled = control.cancelled();
  if (report.cancelled)
    return {};
  return result;
}

} // namespace pcl::ccaa
