// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what new triangles must not run through.

#pragma once

#include <pcl/surface_repair/repair_report.h>

#include "filling/filling_method.h"
#include "filling/patch.h"
#include "mesh/box_tree.h"
#include "run/run_control.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace pcl::repair {

/** \brief The few triangles that stood in the way last: likely in that of the next,
 * too. */
class LastMet {
public:
  /** \brief Whether one of them meets a triangle (see SurfaceObstacle::meets()).
   * \param[in] box around that */
  bool
  meets(const ccaa::Corners& corners, const ccaa::Box& box);

  void
  add(const ccaa::Corners& met);

private:
  std::vector<ccaa::Corners> met_; /**< the latest first */
};

/** \brief The surface near the places where something is built, and what was built
 * there before. Const methods may be called from several threads, but not those of one
 * that is watched. A copy is cheap, and does not see what is added afterwards. */
class SurfaceObstacle {
public:
  /** \brief Take the triangles of a model that come near to places. Cost: 20 ns a
   * triangle of the model, and a tree over those that are taken. \param[in,out] control
   * told the work, may be null; after cancelling some are missing */
  SurfaceObstacle(const IncompleteModel& model,
                  const std::vector<ccaa::Box>& places,
                  int threads = 1,
                  ccaa::RunControl* control = nullptr);

  /** \brief The same, and where it is asked for anything. \param[in,out] seen is
   * extended by the boxes of all questions; must outlive the copy */
  SurfaceObstacle
  watched(ccaa::Box& seen) const;

  /** \brief A box is looked at, too, in another way. */
  void
  noteSeen(const ccaa::Box& box) const
  {
    if (seen_ != nullptr)
      seen_->extend(box);
  }

  /** \brief Triangles that are there from now on, too. Cost: log n trees over each of
   * the n that are added in all. */
  void
  add(const Positions& positions,
      const Triangles& triangles,
      ccaa::RunControl* control = nullptr);

  /** \brief Whether a triangle meets one that is there where it should not (see
   * ccaa::trianglesMeet()). Exact. One without an area meets nothing; all others do
   * once the control says stop. \param[in,out] last is asked first, may be null */
  bool
  meets(const ccaa::Corners& corners,
        ccaa::RunControl* control = nullptr,
        LastMet* last = nullptr) const;

  /** \brief Whether the way between two points meets one that is there, but for corners
   * that they have in common: then any triangle with an area that has this way as an
   * edge meets it. Exact; all are once the control says stop. */
  bool
  isCrossedBy(const Position& p,
              const Position& q,
              ccaa::RunControl* control = nullptr) const;

private:
  /** Whether a test holds for any triangle whose box meets one. */
  template <typename Search, typename Test>
  bool
  holdsForAny(const ccaa::Box& box,
              const Search& search,
              const Test& test,
              ccaa::RunControl* control) const;

  /** Triangles that came together. */
  struct Layer {
    ccaa::Box box;
    std::vector<ccaa::Corners> triangles;
    ccaa::BoxTree tree;
  };

  void
  addLayer(std::vector<ccaa::Corners> triangles, ccaa::RunControl* control);

  std::vector<std::shared_ptr<const Layer>> layers_;
  ccaa::Box* seen_ = nullptr;
};

/** \brief Let a filling avoid a surface after the one that does not look at it has run
 * into something. \param[in] obstacle must outlive the task; its questions count for
 * the task's control */
void
avoid(const SurfaceObstacle& obstacle, FillingTask& task);

/** \brief PIERCED where the surface crosses an edge of a polygon that is its own: what
 * is filled there meets it. INTERSECTION where it crosses another edge, else NONE.
 * \param[in] is_given whether an edge between two places of the polygon is its own */
OpenReason
crossedEdges(const BoundaryCurve& polygon,
             const std::function<bool(std::size_t, std::size_t)>& is_given,
             const SurfaceObstacle& obstacle,
             ccaa::RunControl* control = nullptr);

/** \brief Triangles of a patch that run through the surface or through each other, or
 * of which a new vertex lies exactly at another corner; ascending. Others without an
 * area are passed over: corners of a rim may lie in line. */
std::vector<std::size_t>
obstructedTriangles(const Patch& patch,
                    const SurfaceObstacle& obstacle,
                    ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
