// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges worth testing, from the votes of both their ends.
#pragma once

#include "greedy/edge_certificate.h"
#include "greedy/length_buckets.h"
#include "greedy/ranked_points.h"
#include "greedy/slot_match.h"

#include <cmath>
#include <vector>

namespace pcl::ccaa {

/** \brief How much speaks for a candidate edge; lower goes first. */
enum class EdgeStanding : unsigned char {
  CERTIFIED, /**< by both ends, or by the only end that has the other in its row */
  DISPUTED,  /**< by one end, against the witnesses of the other */
  PLAIN      /**< in reach, nothing more */
};

/** \brief The candidate edges of a run, found point by point. Each edge comes from one
 * of its ends only, and never where the other end finds it out of reach. */
class CandidateEdges {
public:
  CandidateEdges(const RankedPoints& points,
                 const NeighborRows& neighbors,
                 const std::vector<EdgeVotes>& votes)
  : points_(points), neighbors_(neighbors), votes_(votes)
  {}

  /** \brief Calls use(edge, standing) for the edges that \a a certifies. */
  template <typename Use>
  void
  forCertified(index_t a, Use use) const
  {
    const EdgeVotes& mine = votes_[static_cast<std::size_t>(a)];
    for (std::uint64_t bits = mine.certified; bits != 0; bits &= bits - 1) {
      const index_t b = neighbors_.row(a)[__builtin_ctzll(bits)];
      const EdgeVotes& theirs = votes_[static_cast<std::size_t>(b)];
      const std::uint64_t back = slotBit(b, a);
      const bool disputed = back != 0 && (theirs.certified & back) == 0;
      if (back != 0 && !disputed && b < a)
        continue; // the other end is in charge of it
      const CandidateEdge candidate = edge(a, b);
      if (isInReach(candidate, theirs, back))
        use(candidate, disputed ? EdgeStanding::DISPUTED : EdgeStanding::CERTIFIED);
    }
  }

  /** \brief Calls use(edge, PLAIN) for all edges in reach of \a a to points for which
   * \a wanted(b) holds. */
  template <typename Wanted, typename Use>
  void
  forPlain(index_t a, Wanted wanted, Use use) const
  {
    const EdgeVotes& mine = votes_[static_cast<std::size_t>(a)];
    for (std::uint64_t bits = mine.in_reach; bits != 0; bits &= bits - 1) {
      const index_t b = neighbors_.row(a)[__builtin_ctzll(bits)];
      if (!wanted(b))
        continue;
      const std::uint64_t back = slotBit(b, a);
      if (back != 0 && b < a)
        continue; // the other end is in charge of it
      const CandidateEdge candidate = edge(a, b);
      if (isInReach(candidate, votes_[static_cast<std::size_t>(b)], back))
        use(candidate, EdgeStanding::PLAIN);
    }
  }

private:
  /** Whether the far end finds an edge in reach: by its vote where the near end is in
   * its row (bit \a back), else by its length limit. */
  static bool
  isInReach(const CandidateEdge& candidate, const EdgeVotes& far, std::uint64_t back)
  {
    return back != 0 ? (far.in_reach & back) != 0 : candidate.length <= far.reach;
  }

  /** Bit of the slot in which a row holds a neighbor, 0 if it does not. */
  std::uint64_t
  slotBit(index_t rank, index_t neighbor) const
  {
    const index_t* row = neighbors_.row(rank);
    std::uint64_t match = 0;
    unsigned int slot = 0;
    for (; slot + 16 <= neighbors_.k; slot += 16)
      match |= std::uint64_t(matchSixteen(row + slot, neighbor)) << slot;
    for (; slot < neighbors_.k; ++slot)
      match |= std::uint64_t(row[slot] == neighbor) << slot;
    return match;
  }

  CandidateEdge
  edge(index_t a, index_t b) const
  {
    const Coordinates& p = points_.coordinates[static_cast<std::size_t>(a)];
    const Coordinates& q = points_.coordinates[static_cast<std::size_t>(b)];
    const double x = double(q[0]) - double(p[0]), y = double(q[1]) - double(p[1]),
                 z = double(q[2]) - double(p[2]);
    return {a, b, static_cast<float>(std::sqrt(x * x + y * y + z * z))};
  }

  const RankedPoints& points_;
  const NeighborRows& neighbors_;
  const std::vector<EdgeVotes>& votes_;
};

} // namespace pcl::ccaa
