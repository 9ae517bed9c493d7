// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the rules for the outer side say about each component.
#pragma once

#include "mesh/block_loop.h"
#include "mesh/component_sums.h"
#include "mesh/given_votes.h"
#include "mesh/winding.h"

#include <cmath>
#include <vector>

namespace pcl::ccaa {

/** \brief What hints and volume say about one component. */
struct OutwardEvidence {
  GivenSides given;
  SideVotes
      volume; /**< six times the tetrahedra from the first corner; closed ones only */
  double area = 0.0;  /**< twice the area */
  double shown = 0.0; /**< twice the area that the origin sees, both sides counting */

  void
  add(const OutwardEvidence& other)
  {
    for (std::size_t i = 0; i < given.size(); ++i)
      given[i].add(other.given[i]);
    volume.add(other.volume);
    area += other.area;
    shown += other.shown;
  }
};

/** \brief A mesh whose components are known. */
struct WoundMesh {
  const Triangles& triangles;
  const PointView& positions;
  const Winding& winding;
};

/** \brief Whether a volume, times six, is more than rounding: a folded sheet encloses
 * nothing. \param[in] area twice that of the surface */
inline bool
enclosesVolume(double volume, double area)
{
  /** Six times the volume over (twice the area)^1.5; 0.2 for a ball. */
  constexpr double LEAST_COMPACTNESS = 1e-9;
  return std::abs(volume) > LEAST_COMPACTNESS * std::pow(area, 1.5);
}

/** \brief Least margin of the votes for one side of the plane; 0 for a closed body. */
constexpr double LEAST_TERRAIN_MARGIN = 0.8;

/** \brief The axis that the plane most of a surface follows lies across, or -1.
 * \param[in] tensor sum of area-weighted n n^T \param[out] normal of the plane */
int
axisOfPlane(const Eigen::Matrix3d& tensor, Eigen::Vector3d& normal);

/** \brief Evidence of hints and volume. Without hints and closed components nothing is
 * computed. */
std::vector<OutwardEvidence>
collectEvidence(const WoundMesh& mesh,
                const OrientationHints& hints,
                const LoopContext& context);

/** \brief Votes for the upper side of the plane that most of the surface follows;
 * without votes where there is no such plane, it does not lie across an axis, or the
 * component does not lie over it like a terrain.
 * \param[out] axis that up is nearest to, of no use without votes */
std::vector<SideVotes>
collectPlane(const WoundMesh& mesh, const LoopContext& context, int& axis);

/** \brief Votes of the enclosing-sphere rule (thesis 4.48, first half): rays from the
 * centre in up to 24 576 directions, the triangle met last has free sight. Triangles
 * smaller than the step between rays are met by their centroid only. */
std::vector<SideVotes>
collectEnclosingSphere(const WoundMesh& mesh, const LoopContext& context);

/** \brief For the wanted components: whether they bulge outward, seen from their own
 * centroid, by volume. */
std::vector<SideVotes>
collectBulge(const WoundMesh& mesh,
             const ComponentFlags& wanted,
             const LoopContext& context);

} // namespace pcl::ccaa
