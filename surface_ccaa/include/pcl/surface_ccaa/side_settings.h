// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a user tells about the outer side of a surface.
#pragma once

#include <pcl/surface_ccaa/mesh/side_hints.h>

#include <optional>

namespace pcl {
namespace ccaa {

/** \brief Base of every class of this library that winds triangles: what it is told
 * about their outer side beside the cloud, and what it went by.
 *
 * What is told here goes before the cloud's normals, and these before the sensor
 * positions the cloud has: fields vp_x, vp_y, vp_z, or sensor_origin_ of a typed cloud.
 */
class SideSettings {
public:
  SideSettings() = default;
  SideSettings(const SideSettings&) = default;
  SideSettings&
  operator=(const SideSettings&) = default;
  virtual ~SideSettings() = default;

  /** \brief Where the sensor of all points stood, units of the cloud. Default: none. */
  void
  setViewpoint(const std::optional<Eigen::Vector3d>& position)
  {
    side_hints_.told_viewpoint = position;
  }
  const std::optional<Eigen::Vector3d>&
  getViewpoint() const
  {
    return side_hints_.told_viewpoint;
  }

  /** \brief Where the outer side looks, as that of a terrain does to the sky; of any
   * length. Asked after a viewpoint. Default: none. */
  void
  setUp(const std::optional<Eigen::Vector3d>& direction)
  {
    side_hints_.up = direction;
  }
  const std::optional<Eigen::Vector3d>&
  getUp() const
  {
    return side_hints_.up;
  }

  /** \brief Whether the origin counts as the sensor's place where nothing says where it
   * stood and the points lie before it (see ccaa::liesBeforeOrigin()). Default true for
   * typed clouds, whose sensor_origin_ is the origin unless it is set; else false. */
  void
  setOriginAsViewpoint(bool allowed)
  {
    side_hints_.try_origin = allowed;
  }
  bool
  getOriginAsViewpoint() const
  {
    return side_hints_.try_origin;
  }

  /** \brief All of these at once, and what a chain knows besides. */
  void
  setSideHints(const SideHints& hints)
  {
    side_hints_ = hints;
  }
  const SideHints&
  getSideHints() const
  {
    return side_hints_;
  }

  /** \brief What told the outer side in the last run. */
  const SideTally&
  getSideTally() const
  {
    return side_tally_;
  }

protected:
  SideHints side_hints_;
  SideTally side_tally_;
};

} // namespace ccaa
} // namespace pcl
