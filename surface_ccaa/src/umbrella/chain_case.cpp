// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the rows of the umbrella filter's table (T3.4-1).
#include "umbrella/chain_case.h"

#include <Eigen/Geometry>

#include "mesh/corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::ccaa {
namespace {

/** Share by which angles of one size differ through rounding. */
constexpr double EQUAL_ANGLES = 1e-9;

bool
lexicographicallyLess(const Position& a, const Position& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/** \brief What decides between open chains with equally many triangles. */
struct ChainRank {
  std::size_t place = 0;
  double angle = 0.0;     /**< sum of angles at the point, radians */
  Position lowest_corner; /**< lexicographically, the point itself left out */
  pcl::index_t lowest_triangle = -1; /**< the last resort */
};

ChainRank
rankChain(const PointChains& chains,
          std::size_t place,
          const Triangles& triangles,
          const Positions& positions,
          pcl::index_t vertex)
{
  const FanChain& chain = chains.chains()[place];
  const auto first =
      chains.triangles().begin() + static_cast<std::ptrdiff_t>(chain.first);
  const auto last = first + static_cast<std::ptrdiff_t>(chain.size);
  ChainRank rank;
  rank.place = place;
  rank.lowest_triangle = *std::min_element(first, last);
  rank.lowest_corner = Position::Constant(std::numeric_limits<double>::infinity());
  for (auto item = first; item != last; ++item) {
    const Triangle& triangle = triangles[static_cast<std::size_t>(*item)];
    const auto corner = static_cast<std::size_t>(cornerOf(triangle, vertex));
    const auto& a = positions[static_cast<std::size_t>(triangle[(corner + 1) % 3])];
    const auto& b = positions[static_cast<std::size_t>(triangle[(corner + 2) % 3])];
    rank.angle += angleAt(triangle, vertex, positions);
    rank.lowest_corner = std::min({rank.lowest_corner, a, b}, lexicographicallyLess);
  }
  return rank;
}

/** \brief Of chains with equally many triangles the one that stays. */
std::size_t
breakTie(std::vector<ChainRank> ranks)
{
  const auto narrower = [](const ChainRank& a, const ChainRank& b) {
    return a.angle < b.angle;
  };
  const double widest = std::max_element(ranks.begin(), ranks.end(), narrower)->angle;
  const auto too_narrow = [&](const ChainRank& rank) {
    return rank.angle < widest * (1.0 - EQUAL_ANGLES);
  };
  ranks.erase(std::remove_if(ranks.begin(), ranks.end(), too_narrow), ranks.end());
  const auto before = [](const ChainRank& a, const ChainRank& b) {
    if (lexicographicallyLess(a.lowest_corner, b.lowest_corner))
      return true;
    return !lexicographicallyLess(b.lowest_corner, a.lowest_corner) &&
           a.lowest_triangle < b.lowest_triangle;
  };
  return std::min_element(ranks.begin(), ranks.end(), before)->place;
}

} // namespace

ChainCase
classifyChains(const PointChains& chains)
{
  const auto& all = chains.chains();
  const auto closed = std::count_if(
      all.begin(), all.end(), [](const FanChain& chain) { return chain.closed; });
  const auto open = static_cast<std::ptrdiff_t>(all.size()) - closed;
  if (closed > 1)
    return ChainCase::SEVERAL_CLOSED;
  if (closed == 1)
    return open == 0 ? ChainCase::ONE_CLOSED : ChainCase::CLOSED_AND_OPEN;
  if (open > 1)
    return ChainCase::SEVERAL_OPEN;
  return open == 1 ? ChainCase::ONE_OPEN : ChainCase::NO_CHAIN;
}

std::optional<std::size_t>
survivingChain(const PointChains& chains,
               const Triangles& triangles,
               const Positions& positions,
               pcl::index_t vertex)
{
  const auto& all = chains.chains();
  const ChainCase row = classifyChains(chains);
  if (row == ChainCase::NO_CHAIN || row == ChainCase::SEVERAL_CLOSED)
    return std::nullopt;
  if (row != ChainCase::SEVERAL_OPEN)
    return all.size() - 1; // the closed one is the last
  const auto longest = std::max_element(all.begin(),
                                        all.end(),
                                        [](const FanChain& a, const FanChain& b) {
                                          return a.size < b.size;
                                        })
                           ->size;
  std::vector<ChainRank> ranks;
  for (std::size_t place = 0; place < all.size(); ++place)
    if (all[place].size == longest)
      ranks.push_back(rankChain(chains, place, triangles, positions, vertex));
  return breakTie(std::move(ranks));
}

} // namespace pcl::ccaa
