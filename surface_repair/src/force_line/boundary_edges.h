// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the boundary edges at which a force line can end.

#pragma once

#include "boundary/boundary_loop.h"
#include "force_line/force_line.h"
#include "mesh/box_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace pcl::repair {

/** \brief A boundary curve and the island it belongs to. */
struct TargetCurve {
  BoundaryCurve curve;
  std::size_t island = NONE;
};

/** \brief Where a straight way comes closest to a boundary. */
struct BoundaryEncounter {
  BoundaryPoint point;
  double distance = 0.0; /**< between way and boundary */
  double along = 0.0;    /**< share of the way at which that is, 0 to 1 */
};

/** \brief The edges of several boundary curves, to be searched by place. Const methods
 * may be called from several threads. */
class BoundaryEdges {
public:
  /** \brief Whether any edge of a curve counts; empty: of each. */
  using CurveFilter = std::function<bool(std::size_t curve)>;
  /** \brief Whether an edge of such a curve counts; empty: each does. */
  using EdgeFilter = std::function<bool(std::size_t curve, std::size_t edge)>;

  explicit BoundaryEdges(std::vector<TargetCurve> curves);

  const std::vector<TargetCurve>&
  curves() const
  {
    return curves_;
  }

  /** \brief The arc length from the first point of its curve to a boundary point. */
  double
  arcAt(const BoundaryPoint& point) const;

  /** \brief The boundary point at an arc length from the first point of a curve, which
   * is taken modulo the length of the curve. */
  BoundaryPoint
  pointAt(std::size_t curve, double arc) const;

  /** \brief Arc length from the first point of a curve to the middle of an edge. */
  double
  arcOfEdge(std::size_t curve, std::size_t edge) const
  {
    return 0.5 * (arcs_[curve][edge] + arcs_[curve][edge + 1]);
  }

  /** \brief Arc length between two places of a curve, the shorter way round. */
  double
  arcBetween(std::size_t curve, double first, double second) const
  {
    const double apart = std::abs(first - second);
    return std::min(apart, lengthOf(curve) - apart);
  }

  /** \brief Arc length of a whole curve. */
  double
  lengthOf(std::size_t curve) const
  {
    return arcs_[curve].back();
  }

  /** \brief The closest encounter of the segment from a to b with an edge that counts,
   * within a distance; the lowest curve and edge of equals.
   * \param[in] guess on an edge that counts and may be near: a good one makes the
   * search shorter and does not change what it finds */
  std::optional<BoundaryEncounter>
  closest(const Position& a,
          const Position& b,
          double within,
          const CurveFilter& curve_counts = {},
          const EdgeFilter& edge_counts = {},
          const BoundaryPoint& guess = {}) const;

  /** \brief The same with the edges of one curve of which the middle is further than
   * some length along it from a place. */
  std::optional<BoundaryEncounter>
  closestFurtherAlong(const Position& a,
                      const Position& b,
                      double within,
                      std::size_t curve,
                      double arc,
                      double length,
                      const BoundaryPoint& guess = {}) const;

private:
  std::vector<TargetCurve> curves_;
  std::vector<std::vector<double>> arcs_; /**< of each curve, at its points and end */
  std::vector<ccaa::BoxTree> trees_;      /**< over the edges of each curve */
  ccaa::BoxTree tree_;                    /**< over the curves */
};

} // namespace pcl::repair
