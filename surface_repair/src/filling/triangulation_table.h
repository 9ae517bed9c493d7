// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the dynamic programme behind the least-weight filling.

#pragma once

#include "filling/filling_method.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace pcl::repair {

/** \brief Two points of a polygon, the lower first, not neighbours. */
using Diagonal = std::pair<std::size_t, std::size_t>;

/** \brief Whether two points, the lower first, are no neighbours in a polygon of so
 * many. */
inline bool
isDiagonal(const Diagonal& pair, std::size_t points)
{
  const std::size_t steps = pair.second - pair.first;
  return steps > 1 && steps + 1 < points;
}

/** \brief What an edge weighs: its length times a constant and tan^2 of half the angle
 * by which the triangles at it fold. */
struct FillingWeights {
  double length = 0.3;
  double fold = 1.0;
};

/** \brief What a triangulation must avoid, by points of the polygon, ascending; empty:
 * nothing. All triangles at a diagonal that is crossed are obstructed. */
struct FillingLimits {
  ccaa::RunControl* control = nullptr; /**< once it says stop there is no triangulation
                                        */
  std::function<bool(std::size_t, std::size_t)> joined;
  std::function<bool(std::size_t, std::size_t, std::size_t)> obstructed;
  std::function<bool(std::size_t, std::size_t)> crossed;
};

/** \brief The triangulation of least weight of a polygon among those whose diagonals
 * are on a list.
 *
 * Cell (i, j) is the best triangulation of the points from i to j, closed by the edge
 * from j to i. Equal weights go to the lower apex. Cost: some 10 ns for every triangle
 * of three listed diagonals. */
class TriangulationTable {
public:
  /** \brief \param[in] diagonals sorted, without repetition; null: all of them */
  TriangulationTable(const BoundaryCurve& polygon,
                     const std::vector<Diagonal>* diagonals,
                     const FillingWeights& weights,
                     const FillingLimits& limits);

  /** \brief Find the best triangulation again after some triangles, by ascending
   * points, are obstructed, too. Cost: of the cells that span one of them. */
  void
  avoid(const Triangles& obstructed);

  /** \brief n - 2 triangles, wound against the polygon; none when every triangulation
   * is forbidden. */
  const Triangles&
  triangles() const
  {
    return triangles_;
  }

private:
  struct Cell {
    double weight = std::numeric_limits<double>::infinity();
    double length = 0.0; /**< of the closing edge */
    std::size_t apex = NONE;
    Direction normal = Direction::Zero(); /**< of the triangle at the closing edge */
  };
  struct Entry {
    std::size_t point;
    std::size_t cell;
  };
  struct Weighed {
    double weight = 0.0;
    Direction normal = Direction::Zero();
  };
  /** Weighed by the lengths of its edges alone at first: no more than with folds. */
  struct Candidate {
    double weight;
    bool is_weighed;
    std::size_t apex, left, right; /**< the cells behind its edges */
  };

  bool
  isClosing(std::size_t i, std::size_t j) const
  {
    return i == 0 && j + 1 == polygon_.size();
  }

  void
  fillRows();
  void
  makeCells(const std::vector<Diagonal>* diagonals);
  void
  fillRow(std::size_t i);
  void
  fillCell(std::size_t i, std::size_t j, Cell& cell);
  Weighed
  weigh(std::size_t i,
        std::size_t j,
        const Cell& cell,
        const Candidate& candidate) const;
  double
  weighEdge(const Cell& cell, const Direction& normal) const;
  Candidate*
  lightest(std::size_t i, std::size_t j, const Cell& cell);
  void
  acceptLightest(std::size_t i, std::size_t j, Cell& cell);
  std::size_t
  cellAt(std::size_t i, std::size_t j) const;
  void
  collect();

  const BoundaryCurve& polygon_;
  const FillingWeights& weights_;
  const FillingLimits& limits_;
  std::vector<std::size_t> row_begin_;
  std::vector<std::size_t> column_of_; /**< j of each cell */
  std::vector<Cell> cells_;
  std::vector<std::vector<Entry>> columns_; /**< of each j, i descending */
  std::vector<Candidate> candidates_;
  std::uint64_t work_ = 0; /**< that was not told yet */
  Triangles triangles_;
};

} // namespace pcl::repair
