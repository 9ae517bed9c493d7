// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: edges that a fill must not have once more.

#pragma once

#include "patch/patch_assembly.h"
#include "patch/surface_obstacle.h"

#include <set>
#include <utility>

namespace pcl::repair {

/** \brief Edges of a model, of polygons to be closed, and of what closes them. */
class TakenEdges {
public:
  /** \brief \param[in] model must outlive the object */
  explicit TakenEdges(const IncompleteModel& model) : model_(model) {}

  void
  addPolygon(const HolePolygon& polygon);

  /** \brief The inner edges of a filling between points of its polygon. */
  void
  addFilling(const HolePolygon& polygon, const Filling& filling);

  bool
  contain(pcl::index_t a, pcl::index_t b) const;

private:
  const IncompleteModel& model_;
  std::set<std::pair<pcl::index_t, pcl::index_t>> edges_; /**< lower vertex first */
};

/** \brief The task to fill a polygon. \param[in] taken must outlive it
 * \param[in] obstacle to be avoided, must outlive it; or null */
FillingTask
fillingTask(const HolePolygon& polygon,
            const TakenEdges& taken,
            const SurfaceObstacle* obstacle,
            ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
