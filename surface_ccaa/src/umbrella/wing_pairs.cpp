// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which two of the triangles on an edge belong together.
#include "umbrella/wing_pairs.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl::ccaa {
namespace {

/** Cosine between the triangles of a pair, seen along their edge, from which on it lies
 * folded together: less than 53 degrees open. */
constexpr double FOLDED_COSINE = 0.6;
/** By how much cosines of one size differ through rounding. */
constexpr double EQUAL_COSINES = 1e-9;
/** Height of a triangle, relative to its side, that is nothing. */
constexpr double DEGENERATE = 1e-12;

/** \brief What ranks a pair; compared from top to bottom. */
struct PairRank {
  bool folded = true;
  int support = 0;
  double cosine = 1.0; /**< of the angle between the wings; -1 is flat */

  PairRank(const Wing& a, const Wing& b)
  : support(a.support + b.support), cosine(a.direction.dot(b.direction))
  {
    if (a.direction.isZero(0.0) || b.direction.isZero(0.0))
      cosine = 1.0;
    folded = cosine > FOLDED_COSINE;
  }

  bool
  betterThan(const PairRank& other) const
  {
    return std::make_tuple(folded, -support, cosine) <
           std::make_tuple(other.folded, -other.support, other.cosine);
  }

  bool
  ties(const PairRank& other) const
  {
    return folded == other.folded && support == other.support &&
           std::abs(cosine - other.cosine) <= EQUAL_COSINES;
  }
};

} // namespace

Wing
describeWing(const TriangleAdjacency::Edge& edge,
             const Triangle& triangle,
             int support,
             const Positions& positions)
{
  const auto at = [&](pcl::index_t vertex) -> const Position& {
    return positions[static_cast<std::size_t>(vertex)];
  };
  const auto third = std::find_if(triangle.begin(), triangle.end(), [&](auto corner) {
    return corner != edge[0] && corner != edge[1];
  });
  Position from = at(edge[0]), to = at(edge[1]);
  if (std::lexicographical_compare(
          to.data(), to.data() + 3, from.data(), from.data() + 3))
    from.swap(to);
  const Position along = (to - from).stableNormalized();
  const Position out = at(*third) - from;
  const Position across = out - along * along.dot(out);
  Wing wing;
  wing.direction = Position::Zero();
  if (across.norm() > DEGENERATE * out.norm())
    wing.direction = across.stableNormalized();
  wing.support = support;
  return wing;
}

std::optional<std::pair<std::size_t, std::size_t>>
bestWingPair(const std::vector<Wing>& wings)
{
  std::pair<std::size_t, std::size_t> best{0, 1};
  PairRank best_rank(wings[0], wings[1]);
  std::vector<PairRank> ranks;
  for (std::size_t i = 0; i < wings.size(); ++i)
    for (std::size_t j = i + 1; j < wings.size(); ++j) {
      ranks.emplace_back(wings[i], wings[j]);
      if (ranks.back().betterThan(best_rank)) {
        best = {i, j};
        best_rank = ranks.back();
      }
    }
  const auto ties = std::count_if(ranks.begin(), ranks.end(), [&](const auto& rank) {
    return rank.ties(best_rank);
  });
  if (ties > 1)
    return std::nullopt;
  return best;
}

} // namespace pcl::ccaa
