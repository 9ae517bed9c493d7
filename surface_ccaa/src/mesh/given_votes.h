// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what hints say about the side of a triangle.
#pragma once

#include "mesh/corners.h"
#include "mesh/orientation.h"
#include "mesh/side_votes.h"

#include <array>
#include <cstddef>

namespace pcl::ccaa {

/** \brief A triangle as far as the rules for the outer side need it. */
struct Facet {
  Position centroid;
  Eigen::Vector3d area; /**< normal as long as twice the area */
};

inline Facet
facetOf(const Corners& c)
{
  return {(c[0] + c[1] + c[2]) / 3.0, areaNormal(c)};
}

/** \brief Votes by OutwardRule, as far as the hints have them. */
using GivenSides =
    std::array<SideVotes, static_cast<std::size_t>(OutwardRule::ORIGIN) + 1>;

/** \brief The votes of all hints that there are: normals and a direction by the area
 * across them, viewpoints by solid angle. The hints must outlive it. */
class GivenVotes {
public:
  explicit GivenVotes(const OrientationHints& hints)
  : hints_(hints)
  , has_viewpoint_(!hints.viewpoints.empty() || hints.viewpoint)
  , is_origin_(hints.viewpoints.empty() && hints.viewpoint_is_origin)
  {}

  bool
  any() const
  {
    return has_viewpoint_ || hints_.told_viewpoint || hints_.up ||
           !hints_.normals.empty();
  }

  /** \brief The viewpoint is the origin, taken for it. */
  bool
  isOrigin() const
  {
    return is_origin_;
  }

  void
  add(const Triangle& triangle, const Facet& facet, GivenSides& sides) const;

private:
  Position
  viewpointOf(const Triangle& triangle) const;

  const OrientationHints& hints_;
  bool has_viewpoint_;
  bool is_origin_;
};

} // namespace pcl::ccaa
