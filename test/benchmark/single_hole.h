// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closed models with one hole cut into them.
#pragma once

#include "closed_models.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace bench {

/** \brief Where a hole is to be and how large. */
struct HoleWish {
  pcl::index_t centre = 0; /**< a triangle */
  std::size_t edges = 600; /**< on its boundary, five in a hundred more at most */
  double stretch = 1;      /**< times as long along x as across */
};

/** \brief A model with a hole, and what was there. */
struct SingleHole {
  pcl::repair::Positions positions;
  pcl::repair::Triangles triangles; /**< that are left */
  pcl::repair::Triangles lost;      /**< with the vertices of the whole model */
  std::vector<pcl::index_t> loop;   /**< as new triangles will run through it */
};

/** \brief Take triangles away by their distance from the centre, outward along the
 * surface, until the boundary has as many edges. \return nothing where no disc has */
std::optional<SingleHole>
cutHole(const ClosedModel& model, const HoleWish& wish);

} // namespace bench
