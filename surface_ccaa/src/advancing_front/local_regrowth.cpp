// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a second try where triangles stood in the way of others.
#include "advancing_front/local_regrowth.h"

#include "advancing_front/fan_settlement.h"
#include "advancing_front/new_islands.h"
#include "advancing_front/spacing.h"
#include "advancing_front/surface_growth.h"
#include "advancing_front/tuning.h"
#include "mesh/corners.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_set>
#include <utility>

namespace pcl::ccaa {
namespace {

/** \param[in] positions first those of the open points */
Flaws
findFlaws(const Triangles& triangles,
          std::size_t open_points,
          const Positions& positions)
{
  const auto is_open = [&](pcl::index_t v) {
    return static_cast<std::size_t>(v) < open_points;
  };
  Triangles sectors; // a vertex, and the other corners of a triangle there as it winds
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (is_open(t[i]) || is_open(t[(i + 1) % 3]))
        sectors.push_back({t[i], t[(i + 1) % 3], t[(i + 2) % 3]});
  std::sort(sectors.begin(), sectors.end());
  const auto first = [&](pcl::index_t from, pcl::index_t to) {
    return std::lower_bound(sectors.begin(), sectors.end(), Triangle{from, to, 0});
  };
  Flaws flaws;
  for (const Triangle& triangle : triangles) {
    const Corners corners = cornersOf(triangle, positions);
    flaws.volume += (corners[0] - positions[0]).dot(areaNormal(corners));
  }
  for (const Triangle& sector : sectors) {
    const auto opposite = first(sector[1], sector[0]);
    if (opposite == sectors.end() || (*opposite)[0] != sector[1] ||
        (*opposite)[1] != sector[0])
      flaws.borders.push_back({sector[0], sector[1]});
  }
  flaws.doubled_characteristic = -static_cast<std::ptrdiff_t>(triangles.size()) -
                                 static_cast<std::ptrdiff_t>(flaws.borders.size());
  for (pcl::index_t v = 0; is_open(v); ++v) {
    const auto begin = first(v, 0);
    std::vector<pcl::index_t> around(static_cast<std::size_t>(first(v + 1, 0) - begin));
    std::iota(around.begin(), around.end(), 0);
    const std::size_t fans = fansOf(around, v, [&](pcl::index_t t) -> const Triangle& {
                               return begin[t];
                             }).size();
    flaws.unused += fans == 0;
    flaws.touching += fans > 1;
    flaws.doubled_characteristic += 2 * static_cast<std::ptrdiff_t>(fans);
  }
  return flaws;
}

/** With ten for each handle that was not there before: where two parts become one the
 * characteristic falls by one. */
std::size_t
flawsAfter(const Flaws& before, const Flaws& after)
{
  const std::ptrdiff_t fall =
      before.doubled_characteristic - after.doubled_characteristic;
  return after.count() +
         5 * static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, fall - 2));
}

/** A triangle by the places of its corners among some vertices, ascending. */
Triangle
inOrder(Triangle triangle, const std::vector<pcl::index_t>& vertices)
{
  for (pcl::index_t& corner : triangle)
    corner = static_cast<pcl::index_t>(
        std::lower_bound(vertices.begin(), vertices.end(), corner) - vertices.begin());
  return triangle;
}

/** Boundary loops all of whose edges are known. */
std::ptrdiff_t
loopsAlong(const std::vector<std::array<pcl::index_t, 2>>& borders)
{
  std::vector<std::uint8_t> seen(borders.size(), 0);
  std::ptrdiff_t loops = 0;
  for (std::size_t i = 0; i < borders.size(); ++i)
    for (std::size_t j = i; seen[j] == 0;) {
      seen[j] = 1;
      const auto next = std::lower_bound(
          borders.begin(), borders.end(), std::array{borders[j][1], pcl::index_t{0}});
      if (next == borders.end() || (*next)[0] != borders[j][1])
        break;
      j = static_cast<std::size_t>(next - borders.begin());
      loops += j == i;
    }
  return loops;
}

/** What a try to open handles is measured from, as it may win any number of flaws. */
constexpr std::size_t UNCHANGED = std::size_t{1} << 20;

/** \return UNCHANGED for what is no better: no opening is closed by a handle, and what
 * has one less is fuller. A tunnel is filled; what is cut through may be a wire, or a
 * bridge between bodies, and no sampling tells which. Pieces are not counted, as those
 * here may be connected elsewhere. */
std::size_t
handlesAfter(const Flaws& before, const Flaws& after)
{
  const std::ptrdiff_t rise =
      (after.doubled_characteristic - before.doubled_characteristic) / 2;
  const std::ptrdiff_t fewer_handles =
      rise + loopsAlong(after.borders) - loopsAlong(before.borders);
  const std::ptrdiff_t fewer_flaws = rise + static_cast<std::ptrdiff_t>(before.unused) -
                                     static_cast<std::ptrdiff_t>(after.unused);
  if (after.touching > before.touching || fewer_handles < 0 || fewer_flaws <= 0 ||
      (fewer_handles > 0 && after.volume <= before.volume))
    return UNCHANGED;
  return UNCHANGED - static_cast<std::size_t>(fewer_flaws);
}

} // namespace

bool
LocalRegrowth::run(const std::vector<pcl::index_t>& points, Aim aim, LoopContext loop)
{
  aim_ = aim;
  loop.stage = "local regrowth";
  loop.block_size = 1;
  number_in_open_.assign(surface_.vertexCount(), -1);
  for (std::size_t i = 0; i < open_.open_points; ++i)
    number_in_open_[static_cast<std::size_t>(vertices_[i])] =
        static_cast<pcl::index_t>(i);
  std::vector<Group> waiting = groups(points);
  has_many_groups_ =
      waiting.size() >
      std::min(tuning::MANY_GROUPS, surface_.vertexCount() / tuning::POINTS_OF_MANY);
  while (!waiting.empty()) {
    std::vector<Attempt> attempts(waiting.size());
    const bool finished = forEachBlock(
        waiting.size(), loop, [&](std::size_t i, std::size_t, std::size_t) {
          attempts[i] = regrow(waiting[i].points, loop.control);
        });
    if (!finished)
      return false;
    waiting = applyAll(waiting, attempts);
  }
  return true;
}

/** \return groups that have to try again, because their place has changed */
std::vector<LocalRegrowth::Group>
LocalRegrowth::applyAll(const std::vector<Group>& waiting,
                        const std::vector<Attempt>& attempts)
{
  std::vector<Group> again;
  std::unordered_set<pcl::index_t> changed;
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    const Attempt& attempt = attempts[i];
    if (!attempt.is_better)
      continue;
    const bool overlaps =
        std::any_of(attempt.open.begin(), attempt.open.end(), [&](pcl::index_t point) {
          return changed.count(point) > 0;
        });
    if (overlaps) {
      again.push_back(waiting[i]);
      continue;
    }
    for (const pcl::index_t t : attempt.removed)
      surface_.remove(t);
    for (const Triangle& triangle : attempt.made)
      surface_.add(triangle);
    changed.insert(attempt.open.begin(), attempt.open.end());
    if (attempt.flaws > 0 && !has_many_groups_ &&
        waiting[i].improvements < tuning::IMPROVEMENTS)
      again.push_back({waiting[i].points, waiting[i].improvements + 1});
  }
  return again;
}

/** Points connected by triangles among them. */
std::vector<LocalRegrowth::Group>
LocalRegrowth::groups(const std::vector<pcl::index_t>& points) const
{
  std::vector<pcl::index_t> waiting = points;
  sortUnique(waiting);
  std::vector<std::uint8_t> taken(waiting.size(), 0);
  std::vector<Group> all;
  for (std::size_t seed = 0; seed < waiting.size(); ++seed) {
    if (taken[seed] != 0)
      continue;
    taken[seed] = 1;
    Group group{{waiting[seed]}};
    for (std::size_t i = 0; i < group.points.size(); ++i)
      surface_.forTrianglesAt(group.points[i], [&](pcl::index_t t) {
        for (const pcl::index_t corner : surface_[t]) {
          const auto place = std::lower_bound(waiting.begin(), waiting.end(), corner);
          if (place == waiting.end() || *place != corner)
            continue;
          std::uint8_t& mark = taken[static_cast<std::size_t>(place - waiting.begin())];
          if (mark == 0)
            group.points.push_back(corner);
          mark = 1;
        }
      });
    sortUnique(group.points);
    all.push_back(std::move(group));
  }
  return all;
}

/** The best of all tries around some points. */
LocalRegrowth::Attempt
LocalRegrowth::regrow(std::vector<pcl::index_t> points, RunControl* control) const
{
  Attempt best;
  for (int ring = 0; ring < (has_many_groups_ ? tuning::RINGS_OF_MANY : tuning::RINGS);
       ++ring) {
    Attempt attempt = growAnew(points, control);
    points = attempt.open;
    if (attempt.is_better && (!best.is_better || attempt.flaws < best.flaws))
      best = std::move(attempt);
    else if (best.is_better)
      break;
    if ((best.is_better && best.flaws == 0) || points.size() > tuning::LARGEST_GROUP ||
        (control != nullptr && control->cancelled()))
      break;
  }
  return best;
}

/** One try: all removable triangles at the points are taken away. */
LocalRegrowth::Attempt
LocalRegrowth::growAnew(const std::vector<pcl::index_t>& points,
                        RunControl* control) const
{
  Attempt best;
  best.removed = removableAt(points);
  best.open = points;
  for (const pcl::index_t t : best.removed)
    best.open.insert(best.open.end(), surface_[t].begin(), surface_[t].end());
  addUnusedNear(points, best.open);
  sortUnique(best.open);
  if (best.open.size() > tuning::LARGEST_GROUP)
    return best;
  std::vector<pcl::index_t> vertices;
  OpenSurface gap = surface_.openAt(best.open, best.removed, vertices);
  Triangles there = gap.rim;
  for (const pcl::index_t t : best.removed) // all of its corners are open
    there.push_back(inOrder(surface_[t], best.open));
  const Flaws before = findFlaws(there, gap.open_points, gap.positions);
  best.flaws = aim_ == Aim::CLOSE ? before.count() : UNCHANGED;
  findNeighborsDirectly(gap, parameters_.neighbors);
  completeSpacings(gap);
  for (const double smooth_fold : {parameters_.smooth_fold, M_PI}) {
    Attempt attempt = growInto(gap, vertices, before, smooth_fold, control);
    if (attempt.is_better && attempt.flaws < best.flaws) {
      best.flaws = attempt.flaws;
      best.made = std::move(attempt.made);
      best.is_better = true;
    }
    if (best.flaws == 0 || best.open.size() > tuning::LARGEST_TWICE)
      break;
  }
  return best;
}

LocalRegrowth::Attempt
LocalRegrowth::growInto(const OpenSurface& gap,
                        const std::vector<pcl::index_t>& vertices,
                        const Flaws& before,
                        double smooth_fold,
                        RunControl* control) const
{
  CompletionParameters parameters = parameters_;
  parameters.smooth_fold = smooth_fold;
  SurfaceGrowth growth(gap, parameters, &nearby_);
  Attempt attempt;
  if (!growth.run(control))
    return attempt;
  attempt.is_better = true;
  attempt.made = largeComponents(
      growth.surface().triangles(), gap.rim.size(), gap.positions, rule_);
  Triangles all = gap.rim;
  all.insert(all.end(), attempt.made.begin(), attempt.made.end());
  const Flaws after = findFlaws(all, gap.open_points, gap.positions);
  attempt.flaws =
      aim_ == Aim::CLOSE ? flawsAfter(before, after) : handlesAfter(before, after);
  attempt.made = inTheWhole(std::move(attempt.made), vertices);
  return attempt;
}

std::vector<pcl::index_t>
LocalRegrowth::removableAt(const std::vector<pcl::index_t>& points) const
{
  std::vector<pcl::index_t> found = surface_.trianglesAt(points);
  if (parameters_.keep_given)
    found.erase(std::remove_if(found.begin(),
                               found.end(),
                               [&](pcl::index_t t) { return surface_.isGiven(t); }),
                found.end());
  return found;
}

void
LocalRegrowth::addUnusedNear(const std::vector<pcl::index_t>& points,
                             std::vector<pcl::index_t>& open) const
{
  for (const pcl::index_t point : points) {
    const pcl::index_t number = number_in_open_[static_cast<std::size_t>(point)];
    if (number < 0)
      continue;
    for (unsigned int j = 0; j < open_.neighbors.count(number); ++j) {
      const pcl::index_t near =
          vertices_[static_cast<std::size_t>(open_.neighbors.row(number)[j])];
      bool used = false;
      surface_.forTrianglesAt(near, [&](pcl::index_t) { used = true; });
      if (!used)
        open.push_back(near);
    }
  }
}

} // namespace pcl::ccaa
