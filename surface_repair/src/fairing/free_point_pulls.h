// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which free points draw a patch, where and how strongly.

#pragma once

#include "fairing/fairing_system.h"
#include "fairing/joined_surface.h"
#include "fairing/relaxation.h"
#include "filling/patch.h"
#include "mesh/box_tree.h"

#include <cstddef>
#include <vector>

namespace pcl::repair {

/** \brief A free point attached to the patch. */
struct AttachedPoint {
  Pull pull;
  double offset = 0.0; /**< from the patch, above 0 outside */
  double edge = 0.0;   /**< mean edge of the triangle */
};

/** \brief The free points around a patch but those that are its vertices, in the frame
 * of the joined surface, and the model's triangles among them. */
class FreePointPulls {
public:
  /** \param[in] noise that is known of the points, units of the cloud */
  FreePointPulls(const IncompleteModel& model,
                 const Positions& free_points,
                 const RelaxationParameters& parameters,
                 const Patch& patch,
                 const JoinedSurface& surface,
                 double noise);

  bool
  empty() const
  {
    return points_.empty();
  }

  /** \brief Attach each point to the nearest place of the patch as it is now.
   *
   * No say has a point beyond the reach, or one that the model is nearer to. Weights
   * are k_t / (1 - k_t) times some bending energies of an edge, so many that exact
   * points are met; they fall with the noise of the points (what is known, or
   * what they differ by if that is more), and with how far one stands
   * out from its neighbours (after Geman and McClure 1987). */
  std::vector<Pull>
  attach(const JoinedSurface& surface) const;

private:
  std::vector<Pull>
  weighted(const std::vector<AttachedPoint>& attached) const;
  void
  gatherModel(const IncompleteModel& model,
              const std::vector<pcl::index_t>& rim,
              const JoinedSurface& surface,
              const ccaa::Box& around);

  Positions points_;
  std::vector<ccaa::Corners> model_triangles_;
  double trust_;
  double reach_; /**< in edge lengths */
  double noise_; /**< that is known of the points, in the frame of the surface */
};

} // namespace pcl::repair
