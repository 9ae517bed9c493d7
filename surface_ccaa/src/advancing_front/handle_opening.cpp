// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: grows a surface anew where handles may be tunnels.
#include "advancing_front/handle_opening.h"

#include "advancing_front/narrow_places.h"
#include "advancing_front/tuning.h"
#include "mesh/handle_places.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace pcl::ccaa {
namespace {

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

/** Grows a completed mesh anew where it is narrow, and takes what comes out if it is
 * better. */
class HandleOpening {
public:
  HandleOpening(const Recompletion& again, const Completed& first)
  : again_(again), first_report_(first.report), now_(first)
  {}

  /** Each handle by what is around it. Boundaries that are left grow once more, but not
   * in noise. */
  void
  openOneByOne(const std::vector<std::uint8_t>& is_narrow);

  /** All within so many rings of flagged vertices, with more rings as long as that
   * helps much. Many are tried in part first: in noise, which folds everywhere, most of
   * what grows anew has more flaws. */
  void
  growAnew(std::vector<std::uint8_t> is_narrow, const int* rings);

  /** Flags for what is narrow in parts that a handle passes through, one of them for
   * each: if all were opened the body would come apart. */
  std::vector<std::uint8_t>
  nearHandles(const std::vector<std::uint8_t>& is_narrow) const;

  const Completed&
  now() const
  {
    return now_;
  }

private:
  std::optional<Completed>
  regrow(Reopening reopening, double most_work) const;
  std::optional<Completed>
  regrowAt(const std::vector<std::uint8_t>& is_chosen, bool alone) const;
  bool
  isNoise(const std::vector<std::uint8_t>& is_thin, int rings) const;
  bool
  takeBetter(std::optional<Completed> regrown);

  const Recompletion& again_;
  CompletionReport first_report_;
  Completed now_;
};

/** \return nothing where that takes more than so often the work of the first */
std::optional<Completed>
HandleOpening::regrow(Reopening reopening, double most_work) const
{
  Completed regrown;
  reopening.pieces = now_.mesh.topology.pieces;
  reopening.typical_fold = now_.mesh.typical_fold;
  PartialMesh mesh = again_.mesh;
  mesh.given = now_.mesh.triangles;
  mesh.adjacency = now_.mesh.adjacency;
  const auto budget =
      static_cast<std::uint64_t>(most_work * static_cast<double>(again_.work));
  regrown.mesh = again_.complete(std::move(mesh), reopening, budget, regrown.report);
  if (regrown.report.cancelled || regrown.mesh.fault != PartialMeshFault::NONE)
    return {};
  return regrown;
}

std::optional<Completed>
HandleOpening::regrowAt(const std::vector<std::uint8_t>& is_chosen, bool alone) const
{
  return regrow({true, alone, trianglesAt(is_chosen, now_.mesh.triangles), {}},
                tuning::MOST_WORK_ANEW);
}

std::vector<std::uint8_t>
HandleOpening::nearHandles(const std::vector<std::uint8_t>& is_narrow) const
{
  std::vector<std::uint8_t> is_near = is_narrow;
  addRings(tuning::AROUND_HANDLE, now_.mesh.triangles, is_near);
  std::vector<std::uint8_t> is_chosen(is_narrow.size(), 0);
  for (const HandlePlace& place : handlePlaces(
           now_.mesh.triangles, now_.mesh.adjacency, is_near, again_.context.threads))
    for (const pcl::index_t vertex : place.vertices)
      is_chosen[static_cast<std::size_t>(vertex)] =
          is_narrow[static_cast<std::size_t>(vertex)];
  return is_chosen;
}

void
HandleOpening::openOneByOne(const std::vector<std::uint8_t>& is_narrow)
{
  const std::vector<std::uint8_t> is_chosen = nearHandles(is_narrow);
  Reopening reopening{true, true, {}, {}};
  for (std::size_t v = 0; v < is_chosen.size(); ++v)
    if (is_chosen[v] != 0 && !again_.mesh.isCut(static_cast<pcl::index_t>(v)))
      reopening.handles.push_back(static_cast<pcl::index_t>(v));
  if (!reopening.handles.empty() &&
      takeBetter(regrow(reopening, tuning::MOST_WORK_OF_HANDLES)) &&
      now_.mesh.topology.boundary_loops > 0 && now_.genus() <= tuning::MANY_HANDLES)
    takeBetter(regrow({true, false, {}, {}}, tuning::MOST_WORK_ANEW));
}

/** Whether a part of the thin places leaves hardly fewer flaws. In a plate a part may
 * take more work than all, as tunnels are around it, too: that tells nothing. */
bool
HandleOpening::isNoise(const std::vector<std::uint8_t>& is_thin, int rings) const
{
  auto is_chosen = nearMiddle(is_thin, tuning::PROBED, again_.mesh.points);
  addRings(rings - 1, now_.mesh.triangles, is_chosen);
  const std::optional<Completed> part = regrowAt(is_chosen, true);
  return part && part->flaws() + tuning::PROMISING > now_.flaws();
}

void
HandleOpening::growAnew(std::vector<std::uint8_t> is_thin, const int* rings)
{
  const std::size_t count = countOf(is_thin);
  if (count == 0 || (count > tuning::MANY_THIN && isNoise(is_thin, *rings)))
    return;
  for (int added = 1; rings != tuning::AROUND.end(); ++rings) {
    addRings(*rings - std::exchange(added, *rings), now_.mesh.triangles, is_thin);
    const std::size_t flaws = now_.flaws();
    if (!takeBetter(regrowAt(is_thin, false)) || 3 * now_.flaws() > 2 * flaws)
      return;
  }
}

/** As the completion of what the first was completed from. A handle is worse than
 * openings. \return whether it has fewer flaws */
bool
HandleOpening::takeBetter(std::optional<Completed> regrown)
{
  if (!regrown || regrown->flaws() >= now_.flaws() || regrown->genus() > now_.genus())
    return false;
  std::vector<pcl::index_t> kept;
  for (const pcl::index_t t : regrown->mesh.kept)
    if (static_cast<std::size_t>(t) < now_.mesh.kept.size())
      kept.push_back(now_.mesh.kept[static_cast<std::size_t>(t)]);
  now_ = std::move(*regrown);
  now_.mesh.kept = std::move(kept);
  now_.report.given_triangles = first_report_.given_triangles;
  now_.report.open_points = first_report_.open_points;
  now_.report.kept_triangles = now_.mesh.kept.size();
  now_.report.new_triangles = now_.mesh.triangles.size() - now_.mesh.kept.size();
  return true;
}

double
shareOf(const std::vector<std::uint8_t>& flags)
{
  return static_cast<double>(countOf(flags)) / static_cast<double>(flags.size());
}

} // namespace

Completed
openNarrowPlaces(const Recompletion& again,
                 const Completed& first,
                 const std::vector<std::uint8_t>& is_thin,
                 const std::vector<std::uint8_t>& is_narrow)
{
  HandleOpening opening(again, first);
  if (shareOf(is_thin) >= tuning::THIN_ALL_OVER) {
    opening.growAnew(is_thin, tuning::AROUND.begin() + 1);
    opening.openOneByOne(is_narrow);
    return opening.now();
  }
  opening.openOneByOne(is_narrow);
  const bool is_apart = opening.now().mesh.topology.pieces > first.mesh.topology.pieces;
  if (opening.now().genus() > tuning::MANY_HANDLES ||
      (!is_apart && countOf(opening.nearHandles(is_narrow)) == 0))
    return opening.now();
  HandleOpening together(again, first);
  const auto small_handles = smallHandles(first.mesh, is_narrow.size());
  together.growAnew(together.nearHandles(is_narrow), tuning::AROUND.begin());
  together.growAnew(together.nearHandles(small_handles), tuning::AROUND.begin());
  together.openOneByOne(is_narrow);
  const Completed &all = together.now(), &each = opening.now();
  return std::make_pair(all.genus(), all.flaws()) <=
                 std::make_pair(each.genus(), each.flaws())
             ? all
             : each;
}

} // namespace pcl::ccaa
