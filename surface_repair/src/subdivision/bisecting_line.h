// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a force line made to fit between two vertices of a hole.

#pragma once

#include "force_line/boundary_edges.h"
#include "hole/hole_polygon.h"
#include "subdivision/hole_subdivision.h"

#include <cstddef>
#include <optional>

namespace pcl::repair {

/** \brief A way from one vertex of a hole to another. */
struct BisectingLine {
  std::size_t from = 0; /**< point of the contour at points.front() */
  std::size_t to = 0;   /**< point of the contour at points.back() */
  Positions points;     /**< the ends included */
  Directions normals;   /**< unit, one a point */
  double quality = 0.0; /**< mean tension (4.41) */
  double merit = 0.0;   /**< to be compared between lines of one hole */

  std::size_t
  edges() const
  {
    return points.size() - 1;
  }
};

/** \brief Fits force lines into one hole. What it is made from must outlive it. Const
 * methods may be called from several threads. */
class LineFitter {
public:
  /** \brief \param[in] contour the curve of the hole alone
   * \param[in] perturbation of lines by free points, if there are any */
  LineFitter(const HolePolygon& hole,
             const BoundaryEdges& contour,
             const PerturbationParameters& perturbation,
             const SubdivisionGuides& guides);

  /** \brief Points at about the distance of the contour's points, perturbed by free
   * points (4.6), and shifted so that the ends are vertices exactly; the shift is
   * tapered along the line. None where the line is no bridge, where a part would have
   * less than three edges or hardly less than the hole, or where the line comes near
   * the contour away from its ends, or runs through the surface. */
  std::optional<BisectingLine>
  fit(const ForceLine& line) const;

private:
  ForceLine
  cutToContour(const ForceLine& line, BisectingLine& ends) const;
  std::size_t
  nearestVertex(const BoundaryPoint& point) const;
  std::optional<std::size_t>
  edgesFor(const ForceLine& line, std::size_t from, std::size_t to) const;
  double
  spacingAround(std::size_t vertex) const;
  void
  shiftEnds(ForceLine& line, std::size_t from, std::size_t to) const;
  bool
  keepsClear(const BisectingLine& line) const;
  bool
  comesNear(const BisectingLine& line, const Position& a, const Position& b) const;
  double
  meritOf(const BisectingLine& line) const;

  const HolePolygon& hole_;
  const BoundaryEdges& contour_;
  PerturbationParameters perturbation_;
  const SubdivisionGuides& guides_;
  double mean_spacing_; /**< of the contour's points */
};

} // namespace pcl::repair
