// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch of few triangles, which are looked through one by
// one.

#pragma once

#include "fairing/patch_bending.h"
#include "mesh/box_tree.h"
#include "mesh/corners.h"
#include "run/run_control.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl::repair {

/** \brief A patch with its sides, how much it is bent, and what its triangles run into.
 * What it is made of must outlive it. */
class CoarsePatch {
public:
  /** \brief \param[in] obstructed whether a triangle runs into other surface
   * \param[in] control once it says stop the patch is worth nothing */
  CoarsePatch(const IncompleteModel& model,
              const std::function<bool(const ccaa::Corners&)>& obstructed,
              Patch& patch,
              ccaa::RunControl* control);

  const Position&
  at(std::size_t vertex) const
  {
    return patch.positions[vertex];
  }
  ccaa::Corners
  cornersAt(std::size_t triangle) const
  {
    return ccaa::cornersOf(patch.triangles[triangle], patch.positions);
  }

  /** \brief A triangle has changed, or come at the end. */
  void
  note(std::size_t triangle);

  /** \brief Flip an inner side. \return the triangle beyond */
  std::size_t
  flip(std::size_t side);

  /** \brief Whether a flip makes no edge that is there, nor a triangle without area. */
  bool
  canFlip(std::size_t side) const;

  /** \brief How many triangles one runs into, those that it replaces left out; all
   * other surface counts as one; none where one has no area. Cost: linear in the patch.
   * \param[in] enough ends the count */
  std::size_t
  meetings(const ccaa::Corners& corners,
           const std::vector<std::size_t>& old,
           std::size_t enough) const;

  Patch& patch;
  ccaa::RunControl* const control;
  PatchEdges edges;
  PatchBending bending;
  std::vector<ccaa::Box> boxes; /**< of the triangles */

private:
  const std::function<bool(const ccaa::Corners&)>& obstructed_;
};

} // namespace pcl::repair
