// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how much a patch is bent, and would be.

#pragma once

#include "fairing/patch_edges.h"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace pcl::repair {

/** \brief Total absolute mean curvature of parts of a patch: at each edge its length
 * times the angle between the triangles beside it, those of the model at the rim. What
 * it is made of must outlive it. */
class PatchBending {
public:
  PatchBending(const IncompleteModel& model,
               const Patch& patch,
               const PatchEdges& edges);

  /** \brief Bring a triangle up to date after it has changed, or come at the end. */
  void
  note(std::size_t triangle);

  /** \brief At all edges of some triangles; those between two of them once. */
  double
  of(const std::vector<std::size_t>& triangles) const;

  /** \brief The same of the triangles that would be between a point and the border of a
   * disc. */
  double
  ofStar(const std::vector<std::size_t>& disc, const Position& point) const;

  /** \brief The same of the two triangles beside an inner side, after it was flipped.
   */
  double
  ofFlipped(std::size_t side) const;

private:
  void
  noteRim(const IncompleteModel& model, std::size_t from, std::size_t to);
  Direction
  normalBeyond(std::size_t side) const;

  const Position&
  at(std::size_t vertex) const
  {
    return patch_.positions[vertex];
  }

  const Patch& patch_;
  const PatchEdges& edges_;
  Directions normals_; /**< of the triangles */
  std::map<std::pair<std::size_t, std::size_t>, Direction>
      beyond_rim_; /**< normals of the model's triangles at the sides of the rim */
};

} // namespace pcl::repair
