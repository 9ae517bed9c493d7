// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the growing greedy mesh and its three-part test
// (thesis 3.3).
#pragma once

#include "greedy/ranked_points.h"
#include "mesh/block_loop.h"
#include "mesh/triangle.h"
#include "mesh/uninitialized.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief What the test said of an edge. */
enum class EdgeVerdict : std::uint8_t {
  JOINED,      /**< compatible, and now part of the mesh */
  PRESENT,     /**< was part of the mesh before */
  OVERFULL,    /**< rule 1: an edge would get a third triangle */
  TETRAHEDRON, /**< rule 2: two common neighbors are joined across the edge */
  SMALL_ANGLE  /**< rule 3: an angle under A_T would appear */
};

/** \brief Squared cosine of a threshold angle: the test compares cosines only. */
struct AngleLimit {
  double squared_cosine = 1.0;

  static AngleLimit
  fromRadians(double angle);
};

/** \brief Who is joined to whom while the greedy start runs, and how many triangles
 * each edge carries. A row of SLOTS neighbors per point, one cache line, plus two bits
 * per slot for the triangles: 68 bytes a point.
 *
 * Points whose row is full take no further edge (counted as OVERFULL); on sampled
 * surfaces the sixteenth edge at a point does not occur in practice.
 *
 * Writers may work on different parts of the mesh at the same time: join(a, b) touches
 * the rows of a, b and the points joined to both, nothing else. */
class JoinedEdges {
public:
  /** Neighbors of a point: a row is one cache line. */
  static constexpr unsigned int SLOTS = 16;

  explicit JoinedEdges(const RankedPoints& points, const LoopContext& context = {});

  /** \brief Test the edge by the three rules and add it if it is compatible; each
   * common neighbor of its ends then gives a triangle. \param[in] a rank \param[in] b
   * rank, different from a \param[in] limit A_T \param[in,out] triangles the new
   * triangles are appended, in ranks */
  EdgeVerdict
  join(index_t a, index_t b, const AngleLimit& limit, Triangles& triangles);

  bool
  areJoined(index_t a, index_t b) const
  {
    return slotOf(a, b) < SLOTS;
  }

  /** \brief Calls use(c) for every point joined to both. */
  template <typename Use>
  void
  forCommonNeighbors(index_t a, index_t b, Use use) const
  {
    for (const Apex& c : commonNeighbors(a, b))
      use(c.rank);
  }

  /** \brief Whether the point has at least three edges, all with two triangles. */
  bool
  isClosed(index_t rank) const;

private:
  struct alignas(64) Row {
    std::array<index_t, SLOTS> neighbors;
  };

  /** A point joined to both ends a and b of an edge, with its slots there. */
  struct Apex {
    index_t rank;
    unsigned int slot_at_a;
    unsigned int slot_at_b;
  };

  /** The apexes that are to form a triangle with an edge. */
  struct Apexes {
    std::array<Apex, SLOTS> apex;
    unsigned int count = 0;

    const Apex*
    begin() const
    {
      return apex.data();
    }
    const Apex*
    end() const
    {
      return apex.data() + count;
    }
  };

  unsigned int
  slotOf(index_t rank, index_t neighbor) const;

  unsigned int
  trianglesAt(index_t rank, unsigned int slot) const
  {
    return triangle_counts_[static_cast<std::size_t>(rank)] >> (2 * slot) & 3u;
  }

  unsigned int
  degree(index_t rank) const;

  bool
  isFull(index_t rank) const
  {
    return rows_[static_cast<std::size_t>(rank)].neighbors.back() != NeighborRows::NONE;
  }

  Apexes
  commonNeighbors(index_t a, index_t b) const;

  bool
  crossesOrShadows(index_t a, index_t b, Apexes& apexes) const;

  bool
  overfills(index_t a, index_t b, const Apexes& apexes) const;

  bool
  hasSmallAngle(index_t a,
                index_t b,
                const Apexes& apexes,
                const AngleLimit& limit) const;

  bool
  hasSmallAngleAt(index_t at, index_t end, const AngleLimit& limit) const;

  void
  addSlot(index_t rank, index_t neighbor, unsigned int triangles);

  void
  countTriangle(index_t rank, unsigned int slot)
  {
    triangle_counts_[static_cast<std::size_t>(rank)] += 1u << (2 * slot);
  }

  const std::vector<Coordinates>& coordinates_;
  UninitializedVector<Row> rows_;
  UninitializedVector<std::uint32_t> triangle_counts_;
};

} // namespace pcl::ccaa
