// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a hole closed by the triangulation of least weight.

#pragma once

#include "filling/filling_method.h"

namespace pcl::repair {

/** \brief The triangulation of the polygon itself that weighs least, found by dynamic
 * programming (Barequet and Sharir 1995, Liepa 2003); no inner points.
 *
 * An edge weighs its length times 0.3 + tan^2 of half the angle by which the surface
 * folds there; the edges of the polygon count, with the surface around on their other
 * side. Triangles that meet each other are forbidden in turn, up to eight times, and
 * the triangulation that meets itself least is taken. No edge joins two points that are
 * joined already, and no triangle is obstructed: if there is no such triangulation, the
 * filling has a problem.
 *
 * Up to 160 points every diagonal is looked at. Longer polygons are triangulated at
 * every second point first, and so on down to 160; then only diagonals near those of
 * the coarser triangulation are looked at. Cost: see doc/concepts/filling.md. */
class MinimumWeightFilling : public FillingMethod {
public:
  const char*
  name() const override
  {
    return "minimum weight";
  }

  std::size_t
  simpleEdges() const override
  {
    return 100;
  }

  Filling
  close(const FillingTask& task) const override;
};

} // namespace pcl::repair
