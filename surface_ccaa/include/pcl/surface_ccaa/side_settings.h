// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what may be known about the outer side of a surface, what a
// user tells about it, and what told it in the end.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace pcl::ccaa {

/** \brief What told the outer side of a component, in the order in which they are
 * asked. */
enum class OutwardRule : std::uint8_t {
  TOLD_VIEWPOINT, /**< the viewpoint that the user tells */
  UP,             /**< the direction that the user tells */
  NORMALS,        /**< the given normals, voting by projected area */
  VIEWPOINT,      /**< the sensor, which sees outer sides only, voting by solid angle */
  ORIGIN,         /**< the same, the origin being taken for the sensor's place */
  VOLUME,         /**< the component is closed: the volume it encloses is positive */
  PLANE,          /**< a guess: up from the plane that most of the surface follows */
  ENCLOSING_SPHERE, /**< free sight from the sphere around the mesh (thesis 4.48) */
  BULGE,     /**< what curves away from the component's own centroid is outside */
  UNDECIDED, /**< none of these: most of the given windings stay */
  ONE_SIDED  /**< no consistent winding exists: all given windings stay */
};
constexpr std::size_t OUTWARD_RULES = 11;

/** \brief Words for people, such as "given normals". */
const char*
describe(OutwardRule rule);

/** \brief What is known about the outer side for a cloud as a whole; all optional. */
struct SideHints {
  /** \brief Goes before all that the cloud has. */
  std::optional<Eigen::Vector3d> told_viewpoint;
  /** \brief Direction of any length, to which the outer side of a terrain looks; goes
   * before what the cloud has. */
  std::optional<Eigen::Vector3d> up;
  /** \brief By an earlier stage: up is asked after what the cloud has. */
  bool up_is_guessed = false;
  /** \brief Of the cloud; asked after its normals, and only where its points have no
   * sensor positions of their own. */
  std::optional<Eigen::Vector3d> viewpoint;
  bool viewpoint_is_origin = false; /**< nobody says so: see takeOrigin() */
  bool try_origin = false;          /**< takeOrigin() may set the viewpoint */
  /** \brief Where nothing tells: see OutwardRule::PLANE. For windings that mean nothing
   * yet. */
  bool guess_plane = false;
};

/** \brief How many triangles each rule has told the outer side of. */
struct SideTally {
  std::array<std::size_t, OUTWARD_RULES> triangles{}; /**< by OutwardRule */
  int guessed_axis = -1; /**< that PLANE has turned to: 0 x, 1 y, 2 z; -1 if none */

  std::size_t
  operator[](OutwardRule rule) const
  {
    return triangles[static_cast<std::size_t>(rule)];
  }
};

/** \brief For people, such as "given normals" or "sensor position (93 %), free sight (7
 * %)", the rule of most triangles first; a guess says what was guessed. Empty without
 * triangles. */
std::string
describe(const SideTally& tally);

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

  /** \brief Where the sensor of all points stood, units of the cloud. Default: none.
   * Set it for open surfaces without normals. */
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
   * length. Asked after a viewpoint. Default: none. Set it for terrain and
   * floors. */
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
   * typed clouds, whose sensor_origin_ is the origin unless it is set; else false. Set
   * it for single scans in the frame of their sensor. */
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

} // namespace pcl::ccaa
