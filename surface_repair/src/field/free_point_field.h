// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how free points shorten what passes near them (4.424).

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/memory.h>

#include "field/falloff.h"
#include "icadm/incomplete_model.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace pcl::repair {

/** \brief The scalar field G of the free points (4.424, 4.45) and lengths measured in
 * it. Built once; const methods may be called from several threads. */
class FreePointField {
public:
  /** \brief \param[in] points finite
   * \param[in] falloff R_1, R_2 and gamma
   * \param[in] trust k_t of every point, in [0, 1)
   * \param[in] search for the points around a place; null: search::KdTree. Its input
   * cloud becomes the points in a frame of their own. */
  FreePointField(Positions points,
                 const Falloff& falloff,
                 double trust,
                 PointSearchPtr search = nullptr);
  ~FreePointField();

  const Positions&
  points() const;
  const Falloff&
  falloff() const;

  /** \brief Sum of G over the free points around a position (exact, by a PCL KdTree
   * radius search). */
  double
  tensionAt(const Position& position) const;

  /** \brief The effective length of the straight segment from a to b divided by its
   * true length (E4.424-2): in (0, 1], exactly 1 where no free point is near.
   *
   * Taken from a grid of the tension with cells of R_2 / 4, at 3 to 64 places of the
   * segment, 0.67 R_2 apart: within 0.01 of the integral on average, 0.08 at worst (on
   * our tests). Some 80 ns. */
  double
  lengthRatio(const Position& a, const Position& b) const;

  /** \brief Indices of the points within a radius, ascending. */
  std::vector<pcl::index_t>
  within(const Position& center, double radius) const;

  /** \brief Indices of the nearest points, as many or all, nearest first. */
  std::vector<pcl::index_t>
  nearest(const Position& center, std::size_t number) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace pcl::repair
