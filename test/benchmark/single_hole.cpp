// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closed models with one hole cut into them.
#include "single_hole.h"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <utility>

namespace bench {
namespace {

using pcl::repair::Position;
using pcl::repair::Triangle;
using pcl::repair::Triangles;

Position
centroidOf(const ClosedModel& model, pcl::index_t triangle)
{
  Position sum = Position::Zero();
  for (const pcl::index_t corner : model.triangles[static_cast<std::size_t>(triangle)])
    sum += model.positions[static_cast<std::size_t>(corner)] / 3;
  return sum;
}

/** Triangles in the order in which a flood that rises around the centre reaches them.
 */
std::vector<pcl::index_t>
floodOrder(const ClosedModel& model, const HoleWish& wish)
{
  const Position centre = centroidOf(model, wish.centre);
  const auto heightOf = [&](pcl::index_t triangle) {
    Position offset = centroidOf(model, triangle) - centre;
    offset.x() /= wish.stretch;
    return offset.norm();
  };
  using Entry = std::pair<double, pcl::index_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  std::vector<char> seen(model.triangles.size(), 0);
  std::vector<pcl::index_t> order;
  front.emplace(0.0, wish.centre);
  seen[static_cast<std::size_t>(wish.centre)] = 1;
  while (!front.empty()) {
    const auto [height, triangle] = front.top();
    front.pop();
    order.push_back(triangle);
    for (int corner = 0; corner < 3; ++corner) {
      const pcl::index_t next = model.adjacency.across(triangle, corner);
      if (next < 0 || seen[static_cast<std::size_t>(next)] != 0)
        continue;
      seen[static_cast<std::size_t>(next)] = 1;
      front.emplace(std::max(height, heightOf(next)), next);
    }
  }
  return order;
}

using Next = std::map<pcl::index_t, pcl::index_t>;

/** Sides of the lost triangles that the others border on: from vertex to vertex. */
std::size_t
listBorder(const ClosedModel& model, const std::vector<char>& lost, Next& next)
{
  std::size_t edges = 0;
  next.clear();
  for (std::size_t t = 0; t < lost.size(); ++t)
    for (int c = 0; c < 3 && lost[t] != 0; ++c) {
      const auto beyond = model.adjacency.across(static_cast<pcl::index_t>(t), c);
      if (lost[static_cast<std::size_t>(beyond)] != 0)
        continue;
      const Triangle& corners = model.triangles[t];
      next[corners[static_cast<std::size_t>(c)]] =
          corners[static_cast<std::size_t>((c + 1) % 3)];
      ++edges;
    }
  return edges;
}

/** The border as one loop; empty where it is several, or touches itself. */
std::vector<pcl::index_t>
loopOf(const Next& next, std::size_t edges)
{
  std::vector<pcl::index_t> loop;
  if (next.size() != edges || edges == 0)
    return loop;
  const pcl::index_t first = next.begin()->first;
  pcl::index_t vertex = first;
  do {
    loop.push_back(vertex);
    vertex = next.at(vertex);
  }
  while (vertex != first);
  return loop.size() == edges ? loop : std::vector<pcl::index_t>();
}

} // namespace

std::optional<SingleHole>
cutHole(const ClosedModel& model, const HoleWish& wish)
{
  const std::vector<pcl::index_t> order = floodOrder(model, wish);
  std::vector<char> lost(model.triangles.size(), 0);
  Next next;
  std::size_t taken = 0;
  const std::size_t step = std::max<std::size_t>(1, wish.edges / 10);
  while (taken + step < order.size() * 2 / 3) {
    for (const std::size_t end = taken + step; taken < end; ++taken)
      lost[static_cast<std::size_t>(order[taken])] = 1;
    const std::size_t edges = listBorder(model, lost, next);
    if (edges < wish.edges || edges > wish.edges + wish.edges / 20)
      continue;
    SingleHole hole{model.positions, {}, {}, loopOf(next, edges)};
    if (hole.loop.empty())
      continue;
    for (std::size_t t = 0; t < lost.size(); ++t)
      (lost[t] != 0 ? hole.lost : hole.triangles).push_back(model.triangles[t]);
    return hole;
  }
  return std::nullopt;
}

} // namespace bench
