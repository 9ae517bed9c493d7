// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tunnels that a start algorithm made through thin places.
#include "advancing_front/tunnels.h"

#include "advancing_front/narrow_places.h"
#include "advancing_front/tuning.h"
#include "mesh/handle_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace pcl::ccaa {
namespace {

std::size_t
countOf(const std::vector<std::uint8_t>& flags)
{
  return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

std::vector<pcl::index_t>
trianglesAt(const std::vector<std::uint8_t>& is_chosen, const Triangles& triangles)
{
  std::vector<pcl::index_t> found;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (std::any_of(triangles[t].begin(), triangles[t].end(), [&](pcl::index_t v) {
          return is_chosen[static_cast<std::size_t>(v)] != 0;
        }))
      found.push_back(static_cast<pcl::index_t>(t));
  return found;
}

/** What a body is unlikely to have: handles, openings, points beside its surface, more
 * pieces than one. */
std::size_t
flawsOf(const CompletedMesh& mesh, const CompletionReport& report)
{
  const SurfaceTopology& topology = mesh.topology;
  return 2 * static_cast<std::size_t>(topology.genus.value_or(0)) +
         2 * (std::max<std::size_t>(topology.pieces, 1) - 1) + topology.boundary_loops +
         report.free_points;
}

/** The numbers of rings that are tried: few do little for a body that is thin all over.
 */
std::vector<int>
ringsFor(const std::vector<std::uint8_t>& is_thin)
{
  const double share =
      static_cast<double>(countOf(is_thin)) / static_cast<double>(is_thin.size());
  return {tuning::AROUND.begin() + (share < tuning::THIN_ALL_OVER ? 0 : 1),
          tuning::AROUND.end()};
}

/** Flags all corners of the triangles at flagged vertices, so many times. */
void
addRings(int count, const Triangles& triangles, std::vector<std::uint8_t>& is_chosen)
{
  for (int ring = 0; ring < count; ++ring)
    for (const pcl::index_t t : trianglesAt(is_chosen, triangles))
      for (const pcl::index_t corner : triangles[static_cast<std::size_t>(t)])
        is_chosen[static_cast<std::size_t>(corner)] = 1;
}

/** Flags for some of those that are flagged: the middle one along the longest side of
 * their box and the nearest to it. */
std::vector<std::uint8_t>
nearMiddle(const std::vector<std::uint8_t>& flags,
           std::size_t count,
           const PointView& points)
{
  using Entry = std::pair<double, pcl::index_t>;
  Box box;
  std::vector<Entry> order;
  for (std::size_t v = 0; v < flags.size(); ++v)
    if (flags[v] != 0) {
      order.emplace_back(0.0, static_cast<pcl::index_t>(v));
      box.extend(points[order.back().second]);
    }
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto at = [&](std::size_t place) {
    return order.begin() + static_cast<std::ptrdiff_t>(place);
  };
  for (Entry& entry : order)
    entry.first = points[entry.second][axis];
  std::nth_element(order.begin(), at(order.size() / 2), order.end());
  const Position middle = points[at(order.size() / 2)->second];
  for (Entry& entry : order)
    entry.first = (points[entry.second] - middle).squaredNorm();
  std::nth_element(order.begin(), at(count), order.end());
  std::vector<std::uint8_t> chosen(flags.size(), 0);
  for (std::size_t i = 0; i < count; ++i)
    chosen[static_cast<std::size_t>(order[i].second)] = 1;
  return chosen;
}

/** What thin places have become. */
struct Regrown {
  CompletedMesh mesh;
  CompletionReport report;
  std::size_t flaws = 0;
};

/** Grows the surroundings of thin places of a completed mesh anew, and takes what comes
 * out if it is better. */
class ThinPlaces {
public:
  ThinPlaces(PartialMesh mesh,
             std::vector<std::uint8_t> is_thin,
             const CompletionWithout& complete,
             std::uint64_t most_work,
             CompletedMesh& result,
             CompletionReport& report)
  : mesh_(std::move(mesh))
  , is_thin_(std::move(is_thin))
  , complete_(complete)
  , most_work_(most_work)
  , result_(result)
  , report_(report)
  , kept_(result.kept)
  , first_report_(report)
  , flaws_(flawsOf(result, report))
  {
    mesh_.given = result.triangles;
  }

  /** Many places are tried in part first: in noise, which folds everywhere, most of
   * what grows anew has more flaws. \return whether anything was taken */
  bool
  run()
  {
    const std::size_t flaws = flaws_;
    const std::vector<int> all_rings = ringsFor(is_thin_);
    if (countOf(is_thin_) <= tuning::MANY_THIN || !isNoise(all_rings.front()))
      growAll(all_rings);
    return flaws_ < flaws;
  }

private:
  std::optional<Regrown>
  regrow(const std::vector<std::uint8_t>& is_chosen, bool alone) const;
  bool
  isNoise(int rings) const;
  void
  growAll(const std::vector<int>& all_rings);
  void
  take(Regrown regrown);

  PartialMesh mesh_; /**< that was given, with the triangles of the first result */
  std::vector<std::uint8_t> is_thin_; /**< of a vertex, with rings around */
  const CompletionWithout& complete_;
  std::uint64_t most_work_;
  CompletedMesh& result_;
  CompletionReport& report_;
  std::vector<pcl::index_t> kept_; /**< in the first result */
  CompletionReport first_report_;
  std::size_t flaws_; /**< of the result */
};

/** \return nothing where that takes too much work */
std::optional<Regrown>
ThinPlaces::regrow(const std::vector<std::uint8_t>& is_chosen, bool alone) const
{
  Regrown regrown;
  regrown.mesh = complete_(
      mesh_, {trianglesAt(is_chosen, mesh_.given), alone}, most_work_, regrown.report);
  if (regrown.report.cancelled || regrown.mesh.fault != PartialMeshFault::NONE)
    return {};
  regrown.flaws = flawsOf(regrown.mesh, regrown.report);
  return regrown;
}

/** Whether a part of the thin places leaves hardly fewer flaws. In a plate a part may
 * take more work than all, as tunnels are around it, too: that tells nothing. */
bool
ThinPlaces::isNoise(int rings) const
{
  auto is_chosen = nearMiddle(is_thin_, tuning::PROBED, mesh_.points);
  addRings(rings - 1, mesh_.given, is_chosen);
  const std::optional<Regrown> part = regrow(is_chosen, true);
  return part && part->flaws + tuning::PROMISING > flaws_;
}

/** With more rings as long as that helps much. A handle is worse than openings. */
void
ThinPlaces::growAll(const std::vector<int>& all_rings)
{
  int added = 1;
  for (const int rings : all_rings) {
    addRings(rings - std::exchange(added, rings), mesh_.given, is_thin_);
    std::optional<Regrown> all = regrow(is_thin_, false);
    if (!all || all->flaws >= flaws_ ||
        all->mesh.topology.genus > result_.topology.genus)
      return;
    const bool helps_much = 3 * all->flaws <= 2 * flaws_ && all->flaws > 0;
    take(std::move(*all));
    if (!helps_much)
      return;
  }
}

/** As the completion of what the first result was completed from. */
void
ThinPlaces::take(Regrown regrown)
{
  flaws_ = regrown.flaws;
  result_ = std::move(regrown.mesh);
  report_ = regrown.report;
  std::vector<pcl::index_t> kept;
  for (const pcl::index_t t : result_.kept)
    if (static_cast<std::size_t>(t) < kept_.size())
      kept.push_back(kept_[static_cast<std::size_t>(t)]);
  result_.kept = std::move(kept);
  report_.given_triangles = first_report_.given_triangles;
  report_.open_points = first_report_.open_points;
  report_.kept_triangles = result_.kept.size();
  report_.new_triangles = result_.triangles.size() - result_.kept.size();
}

/** The adjacency of a completed mesh, and with it where it is narrow. */
TriangleAdjacency
readNecks(const PointView& points,
          int threads,
          CompletedMesh& mesh,
          CompletionReport& report)
{
  TriangleAdjacency adjacency;
  adjacency.build(mesh.triangles, points.size(), threads);
  findNecks(adjacency, points, {threads}, mesh, report);
  return adjacency;
}

/** Flags for a vertex of each small handle. */
std::vector<std::uint8_t>
smallHandles(const CompletedMesh& mesh, std::size_t vertex_count)
{
  std::vector<std::uint8_t> is_there(vertex_count, 0);
  for (const ThinNeck& neck : mesh.thin_necks)
    if (neck.is_handle)
      is_there[static_cast<std::size_t>(neck.vertex)] = 1;
  return is_there;
}

/** Flags for what is narrow or next to itself, where a handle may be none. */
std::vector<std::uint8_t>
doubtfulVertices(const CompletedMesh& mesh, std::vector<std::uint8_t> is_thin)
{
  for (const ThinNeck& neck : mesh.thin_necks)
    for (const pcl::index_t vertex : neck.around)
      if (neck.is_handle)
        is_thin[static_cast<std::size_t>(vertex)] = 1;
  addRings(tuning::AROUND_HANDLE, mesh.triangles, is_thin);
  for (std::size_t v = 0; v < is_thin.size(); ++v)
    is_thin[v] |= mesh.is_cleft[v];
  return is_thin;
}

} // namespace

void
openTunnels(PartialMesh mesh,
            const CompletionWithout& complete,
            std::uint64_t work,
            const LoopContext& context,
            CompletedMesh& result,
            CompletionReport& report)
{
  if (context.cancelled() || result.topology.genus.value_or(0) <= 0)
    return;
  const PointView points = mesh.points;
  auto is_thin = thinPlaces(result.triangles, points, 0.0, context);
  const bool has_thin = countOf(is_thin) > 0;
  if (!has_thin)
    is_thin = thinPlaces(mesh.given, points, tuning::LARGEST_RISE, context);
  mesh.given = {}; // the result takes its place
  const auto most_work =
      static_cast<std::uint64_t>(tuning::MOST_WORK_ANEW * static_cast<double>(work));
  const auto regrow = [&](const std::vector<std::uint8_t>& is_chosen) {
    return result.topology.genus.value_or(0) > 0 && countOf(is_chosen) > 0 &&
           ThinPlaces(mesh, is_chosen, complete, most_work, result, report).run();
  };
  std::optional<TriangleAdjacency> adjacency;
  if (has_thin && regrow(is_thin))
    adjacency = readNecks(points, context.threads, result, report);
  const auto small_handles = smallHandles(result, points.size());
  if (countOf(small_handles) <= tuning::MANY_SMALL && regrow(small_handles))
    adjacency = readNecks(points, context.threads, result, report);
  if (adjacency)
    is_thin = thinPlaces(result.triangles, points, 0.0, context);
  const long handles = result.topology.genus.value_or(0);
  const bool is_doubtful =
      has_thin || result.has_cleft_handle || countOf(is_thin) > 0 ||
      std::any_of(result.thin_necks.begin(),
                  result.thin_necks.end(),
                  [](const ThinNeck& neck) { return neck.is_handle; });
  if (handles <= 0 || !is_doubtful)
    return;
  if (!adjacency)
    adjacency.emplace().build(result.triangles, points.size(), context.threads);
  is_thin = doubtfulVertices(result, std::move(is_thin));
  report.doubts.handles = static_cast<std::uint64_t>(handles);
  report.doubts.thin_handles =
      handlePlaces(result.triangles, *adjacency, is_thin, context.threads);
  if (!has_thin && report.doubts.thin_handles.empty())
    report.doubts.handles = 0; // the given triangles had such places elsewhere
}

} // namespace pcl::ccaa
