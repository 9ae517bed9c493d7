// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: opens a surface where its windings cannot agree.
#include "tiles/tearing.h"

#include "advancing_front/fan_settlement.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace pcl::ccaa {
namespace {

/** \param[in] triangle with its corners in order */
std::array<Tearing::Edge, 3>
edgesOf(const WideTriangle& triangle)
{
  return {{{triangle[0], triangle[1]},
           {triangle[0], triangle[2]},
           {triangle[1], triangle[2]}}};
}

} // namespace

Tearing::Tearing(const std::vector<Edge>& torn) : torn_(torn.begin(), torn.end())
{
  for (const Edge& edge : torn)
    asked_.insert(edge.begin(), edge.end());
}

void
Tearing::see(const WideTriangle& triangle)
{
  for (const WideIndex corner : triangle)
    if (asked_.count(corner) > 0)
      at_[corner].insert(cornersInOrder(triangle));
}

bool
Tearing::isTorn(const WideTriangle& triangle) const
{
  const auto edges = edgesOf(triangle);
  return std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) {
    return torn_.count(edge) > 0;
  });
}

std::set<WideTriangle>
Tearing::smallerFansAt(WideIndex point) const
{
  std::vector<WideTriangle> left;
  const std::set<WideTriangle>& all = at_.at(point);
  std::copy_if(
      all.begin(),
      all.end(),
      std::back_inserter(left),
      [&](const WideTriangle& triangle) { return gone_.count(triangle) == 0; });
  std::vector<pcl::index_t> numbers(left.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const Fans fans = fansOf(numbers, point, [&](pcl::index_t t) -> const WideTriangle& {
    return left[static_cast<std::size_t>(t)];
  });
  const auto stays =
      std::max_element(fans.begin(), fans.end(), [](const auto& a, const auto& b) {
        return a.size() < b.size();
      });
  std::set<WideTriangle> smaller;
  for (auto fan = fans.begin(); fan != fans.end(); ++fan)
    if (fan != stays)
      for (const pcl::index_t t : *fan)
        smaller.insert(left[static_cast<std::size_t>(t)]);
  return smaller;
}

void
Tearing::settle()
{
  std::set<WideTriangle> more;
  if (gone_.empty()) {
    for (const auto& [point, triangles] : at_)
      std::copy_if(triangles.begin(),
                   triangles.end(),
                   std::inserter(more, more.end()),
                   [&](const WideTriangle& triangle) { return isTorn(triangle); });
    gone_ = more;
  }
  else
    for (const WideIndex point : asked_) {
      const std::set<WideTriangle> smaller = smallerFansAt(point);
      gone_.insert(smaller.begin(), smaller.end());
      more.insert(smaller.begin(), smaller.end());
    }
  asked_.clear();
  for (const WideTriangle& triangle : more)
    asked_.insert(triangle.begin(), triangle.end());
}

std::int64_t
Tearing::openEdges() const
{
  std::set<Edge> edges;
  for (const WideTriangle& triangle : gone_)
    for (const Edge& edge : edgesOf(triangle))
      edges.insert(edge);
  std::int64_t change = 0;
  for (const Edge& edge : edges) {
    int all = 0, left = 0;
    for (const WideTriangle& triangle : at_.at(edge[0]))
      if (std::find(triangle.begin(), triangle.end(), edge[1]) != triangle.end()) {
        ++all;
        left += gone_.count(triangle) == 0 ? 1 : 0;
      }
    const int before = all == 1 ? 1 : torn_.count(edge) > 0 ? 2 : 0;
    change += (left == 1 ? 1 : 0) - before;
  }
  return change;
}

} // namespace pcl::ccaa
