// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what may be known about the outer side of a surface, and
// what told it in the end.
#pragma once

#include <pcl/surface_ccaa/mesh/point_view.h>
#include <pcl/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace pcl {
namespace ccaa {

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
  std::optional<Position> told_viewpoint; /**< goes before all that the cloud has */
  std::optional<Position> up; /**< direction of any length, to which the outer side of a
                                   terrain looks; goes before what the cloud has */
  bool up_is_guessed =
      false; /**< by an earlier stage: asked after what the cloud has */
  std::optional<Position>
      viewpoint; /**< of the cloud; asked after its normals, and only where its points
                      have no sensor positions of their own */
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

/** \brief Whether a cloud lies before the origin as before a sensor: within 45 degrees
 * of the mean direction, no nearer than 0.05 and no farther than 30 of its diagonals,
 * and at most a quarter of its points hidden behind others. Closed bodies and what lies
 * around the origin are not. Points that are not finite do not count. Cost: linear,
 * about 50 ns a point.
 * \param[in] chosen indices of points, or null for all */
bool
liesBeforeOrigin(const PointView& points, const Indices* chosen = nullptr);

/** \brief The hints in a frame with its origin at the offset: for what is worked on
 * less a global shift. Nobody has measured from the origin of map coordinates, so it is
 * not taken for a viewpoint there. */
SideHints
relativeTo(const Position& offset, SideHints hints);

/** \brief Take the origin for the viewpoint where that is allowed, nothing else is told
 * and the points lie before it. */
void
takeOrigin(SideHints& hints, const PointView& points, const Indices* chosen = nullptr);

} // namespace ccaa
} // namespace pcl
