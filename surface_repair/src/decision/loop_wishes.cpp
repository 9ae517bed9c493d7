// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: decisions about loops, found again in each pass.

#include "decision/loop_wishes.h"

#include <algorithm>

namespace pcl::repair {

namespace {

std::pair<std::size_t, std::size_t>
ordered(std::size_t a, std::size_t b)
{
  return std::minmax(a, b);
}

} // namespace

LoopKey
keyOf(const IncompleteModel& model, const BoundaryLoop& loop)
{
  LoopKey key;
  key.edges = loop.vertices.size();
  key.point = lowestPoint(model, loop.vertices);
  for (const pcl::index_t vertex : loop.vertices)
    key.center += model.positions[static_cast<std::size_t>(vertex)];
  key.center /= static_cast<double>(std::max<std::size_t>(key.edges, 1));
  return key;
}

LoopWishes::LoopWishes(const IncompleteModel& model, const BoundaryLoops& loops)
{
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const LoopKey key = keyOf(model, loops[k]);
    loops_.push_back({key, loops[k].island, LoopWish::AUTO, Cap::AUTO});
    place_of_.emplace(Pair(static_cast<std::size_t>(key.point), key.edges), k);
    for (const pcl::index_t vertex : loops[k].vertices)
      loops_at_.emplace(model.point_of_vertex[static_cast<std::size_t>(vertex)], k);
  }
}

std::size_t
LoopWishes::find(const LoopKey& key) const
{
  const auto [from, to] =
      place_of_.equal_range(Pair(static_cast<std::size_t>(key.point), key.edges));
  std::size_t nearest = NONE;
  for (auto at = from; at != to; ++at)
    if (nearest == NONE || (loops_[at->second].key.center - key.center).squaredNorm() <
                               (loops_[nearest].key.center - key.center).squaredNorm())
      nearest = at->second;
  return nearest;
}

std::string
LoopWishes::take(const Decisions& decisions)
{
  std::vector<std::size_t> places; // of the decisions' loops
  for (const LoopDecision& decision : decisions.loops) {
    places.push_back(find(decision.key));
    if (places.back() == NONE)
      return "there is no boundary loop of " + std::to_string(decision.key.edges) +
             " edges whose lowest point is " + std::to_string(decision.key.point);
    Entry& loop = loops_[places.back()];
    loop.wish = decision.wish;
    loop.cap = decision.cap;
    leaves_open_ = leaves_open_ || decision.wish == LoopWish::LEAVE_OPEN;
  }
  return takeJunctions(decisions, places);
}

std::string
LoopWishes::takeJunctions(const Decisions& decisions,
                          const std::vector<std::size_t>& places)
{
  std::set<Pair> islands_joined;
  for (const JunctionDecision& junction : decisions.junctions) {
    if (junction.first_loop >= places.size() || junction.second_loop >= places.size())
      return "a junction refers to a boundary loop that is not listed";
    const std::size_t first = places[junction.first_loop];
    const std::size_t second = places[junction.second_loop];
    const Pair islands = ordered(loops_[first].island, loops_[second].island);
    if (junction.join) {
      islands_joined.insert(islands);
      joined_.insert(ordered(first, second));
    }
    else
      apart_.insert(ordered(first, second));
    if (!junction.join && islands.first != islands.second)
      islands_apart_.insert(islands);
  }
  for (const Pair& islands : islands_joined)
    islands_apart_.erase(islands);
  return {};
}

std::size_t
LoopWishes::inputLoop(const IncompleteModel& model, const BoundaryLoop& loop) const
{
  const auto is_new = [&](pcl::index_t vertex) {
    return model.point_of_vertex[static_cast<std::size_t>(vertex)] == pcl::UNAVAILABLE;
  };
  const bool has_new = std::any_of(loop.vertices.begin(), loop.vertices.end(), is_new);
  return has_new ? NONE : find(keyOf(model, loop));
}

LoopWish
LoopWishes::wishFor(std::size_t input_loop) const
{
  return input_loop == NONE ? LoopWish::AUTO : loops_[input_loop].wish;
}

Cap
LoopWishes::capFor(std::size_t input_loop) const
{
  return input_loop == NONE ? Cap::AUTO : loops_[input_loop].cap;
}

std::set<std::size_t>
LoopWishes::inputLoopsIn(const IncompleteModel& model, const BoundaryLoop& loop) const
{
  const std::size_t same = inputLoop(model, loop);
  if (same != NONE)
    return {same};
  std::set<std::size_t> found;
  for (const pcl::index_t vertex : loop.vertices) {
    const auto [from, to] =
        loops_at_.equal_range(model.point_of_vertex[static_cast<std::size_t>(vertex)]);
    for (auto at = from; at != to; ++at)
      found.insert(at->second);
  }
  return found;
}

bool
LoopWishes::areApart(std::size_t first, std::size_t second) const
{
  return loops_[first].wish == LoopWish::LEAVE_OPEN ||
         loops_[second].wish == LoopWish::LEAVE_OPEN ||
         apart_.count(ordered(first, second)) > 0 ||
         islands_apart_.count(ordered(loops_[first].island, loops_[second].island)) > 0;
}

bool
LoopWishes::mustJoin(const IncompleteModel& model,
                     const BoundaryLoop& first,
                     const BoundaryLoop& second) const
{
  return !joined_.empty() &&
         joined_.count(ordered(inputLoop(model, first), inputLoop(model, second))) > 0;
}

bool
LoopWishes::mayJoin(const IncompleteModel& model,
                    const BoundaryLoop& first,
                    const BoundaryLoop& second) const
{
  const std::set<std::size_t> others = inputLoopsIn(model, second);
  for (const std::size_t one : inputLoopsIn(model, first))
    for (const std::size_t other : others)
      if (areApart(one, other))
        return false;
  return true;
}

} // namespace pcl::repair
