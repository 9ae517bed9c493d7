// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is found out about an incomplete model,
// in the words that all reports share.

#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::repair {

using Position = Eigen::Vector3d;
using Positions = std::vector<Position>;

/** \brief A unit vector; NaN where there is none. */
using Direction = Eigen::Vector3d;
using Directions = std::vector<Direction>;

/** \brief Index of an island, loop or other part that is not there. */
constexpr std::size_t NONE = static_cast<std::size_t>(-1);

/** \brief What reading found, and what had to change before it was an ICADM. */
struct ReadingReport {
  std::size_t input_polygons = 0;
  std::size_t invalid_polygons = 0;   /**< index out of range, repeated or not finite */
  std::size_t repeated_triangles = 0; /**< left out: there already, either way round */
  std::size_t overfull_edges = 0; /**< of three triangles and more, where the mesh was
                                       cut into sheets */
  std::size_t separated_fans = 0; /**< that got a vertex of their own: fans of one point
                                       beside its first one */
  std::size_t twist_triangles = 0; /**< left out: they made islands one-sided */
  std::size_t reversed_triangles = 0;
  std::size_t non_finite_points = 0;
  std::size_t points_on_vertices = 0; /**< that are no free points for that reason */
  Eigen::Vector3d global_shift = Eigen::Vector3d::Zero(); /**< taken off all positions
                                       of the model: see pcl::GlobalShift */
  std::size_t dropped_islands = 0; /**< smaller than the user wants them; see
                                        dropIslands() */
  std::size_t dropped_triangles = 0;
  std::string problem; /**< why there is no model; empty: there is one */
};

enum class IcmClass : std::uint8_t {
  ICM1, /**< one region; simple holes only, or none */
  ICM2, /**< one region, at least one complex hole */
  ICM3  /**< several islands */
};

/** \brief The counts that decide the class. */
struct IcmCounts {
  std::size_t islands = 0;
  std::size_t simple_holes = 0;
  std::size_t complex_holes = 0;
};

/** \brief What told the outer side of an island. */
enum class SideRule : std::uint8_t {
  NORMALS,        /**< the given normals, where they agree with each other */
  VIEWPOINT,      /**< the sensor positions, which see outer sides only */
  VOLUME,         /**< the only island, closed but for small openings: its volume is
                     positive */
  FREE_SIGHT,     /**< the way to the enclosing sphere is free (4.48) */
  FIELD,          /**< the field integral with islands that are decided (E4.48-1) */
  UNDECIDED,      /**< none of these: the winding stays as it was */
  ONE_SIDED,      /**< there are no two sides */
  TOLD_VIEWPOINT, /**< the viewpoint that the user tells, before all others */
  UP,             /**< the direction that the user tells, after that */
  PLANE,          /**< a guess of the reconstruction: up from the dominant plane */
  ORIGIN          /**< as VIEWPOINT, the origin being taken for the sensor's place */
};

const char*
describe(SideRule rule);

/** \brief What was decided about the side of an island. */
struct IslandSide {
  SideRule rule = SideRule::UNDECIDED;
  bool flipped = false;    /**< wound the other way round now */
  double confidence = 0.0; /**< 0 to 1 */
};

/** \brief D = sum of cos(phi) db over a boundary (ED4.1-1). */
struct BoundaryIntegral {
  double value = 0.0;  /**< D, units of length: above 0 a hole, below 0 a rim */
  double length = 0.0; /**< of the boundary */

  /** \brief D / length, -1 (flat rim) to 1 (flat hole); 0 for no boundary. */
  double
  relative() const
  {
    return length > 0.0 ? value / length : 0.0;
  }
};

/** \brief What a boundary loop bounds. */
enum class BoundaryClass : std::uint8_t {
  HOLE,         /**< missing area inside a region */
  ISLAND_RIM,   /**< the outer boundary of a region that others face */
  OUTER_BORDER, /**< the outer boundary of an open surface: nothing is beyond it */
  UNDECIDED     /**< neither is clear, such as the mouth of a tube */
};

/** \brief Name for reports, such as "hole". */
const char*
describe(BoundaryClass boundary_class);

/** \brief What speaks for a hole and what for a rim. */
struct LoopEvidence {
  BoundaryIntegral integral; /**< D (D4.1-1) */
  /** \brief Turns to the right while the loop is walked, measured on the surface: 1 for
   * a flat hole, -1 for a flat rim, 0 for the mouth of a tube. By Gauss and Bonnet it
   * does not depend on how jagged the loop is. */
  double turning = 0.0;
  /** \brief Area of the loop's island, other loops closed, over that of the least
   * surface that would close this loop: 1 for a flat island, 2 for half a sphere, large
   * for a small hole. Only bounds of the least surface are known: what is taken is the
   * value nearest to 2 that is possible. */
  double area_ratio = 2.0;
  /** \brief The island is a tube, and this is one of its two mouths. */
  bool is_tube_mouth = false;
  /** \brief Another loop of the island is a clearer rim and far larger: this is none.
   */
  bool within_rim = false;

  /** \brief All of it as one number: above 0 a hole, below 0 a rim, from -4 (flat
   * rim) up; a hole in a large surface has 10 and more. */
  double
  score() const;
};

/** \brief One loop's class and how sure it is. */
struct LoopClass {
  BoundaryClass boundary_class = BoundaryClass::UNDECIDED;
  double confidence = 0.0; /**< 0 to 1: tanh(|score| / 2) */
  LoopEvidence evidence;
  double faced = 0.0; /**< share of a rim's points that another island faces, 0 to 1;
                           0 for other loops */
};

/** \brief What speaks for and against a surface between two boundaries. All values are
 * medians over the lines that lead from one to the other. */
struct JunctionEvidence {
  double turn = 0.0;      /**< alpha: angle between the way that the surface goes on and
                               the chord to the other end, of the worse end; radians, 0
                               to pi */
  double fold = 0.0;      /**< beta: angle between the normals at both ends, radians */
  double gap = 0.0;       /**< length of the chord, units of the cloud */
  double gap_edges = 0.0; /**< the same in edges of the surface around the ends */
  double gap_share = 0.0; /**< the same over the extent of the smaller boundary */
  double facing = 0.0;    /**< of the whole model: length of its mean normal, 0 for a
                               body seen from all sides to 1 for a flat sheet */
  bool has_sight = false; /**< sensors are known: the next two count */
  double seen_empty = 0.0; /**< share of the way that sensors have looked through */
  double along_ray = 0.0;  /**< cosine between chord and ray: 1 for a jump in depth */

  /** \brief What counts of all this, each at least 0 and the higher the worse: turn,
   * fold, width in edges, width in extents, seen empty, depth. */
  std::array<double, 6>
  terms() const;

  /** \brief ln of the odds that the lost surface leads from one to the other: above 0
   * it rather does. A weighted sum of the terms, see doc/concepts/junction.md. */
  double
  logOdds() const;
};

/** \brief What is decided about a junction. */
enum class JunctionVerdict : std::uint8_t {
  JOINED,            /**< bridges may join the two */
  DIFFERENT_OBJECTS, /**< they do not belong together, for sure */
  SEEN_EMPTY,        /**< sensors have looked through the gap: for sure, too */
  DOUBTFUL           /**< they rather do not belong together: left open, and told */
};

/** \brief A sentence part for messages and reports, such as "different objects". */
const char*
describe(JunctionVerdict verdict);

} // namespace pcl::repair
