// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether two boundaries belong to one surface.

#pragma once

#include <pcl/surface_repair/boundary/boundary_loop.h>
#include <pcl/surface_repair/force_line/boundary_edges.h>
#include <pcl/surface_repair/force_line/force_line.h>
#include <pcl/surface_repair/junction/sight_lines.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace repair {

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
   * fold, width in edges, width in extents, seen empty. */
  std::array<double, 5>
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

/** \brief Two boundaries that lines connect. */
struct Junction {
  std::array<std::size_t, 2> curves{NONE, NONE}; /**< ascending */
  std::vector<std::size_t> lines;                /**< that arrived, ascending */
  std::vector<std::size_t> believed;             /**< of these: bridges may follow them;
                                                      none unless it is joined */
  JunctionEvidence evidence;
  JunctionVerdict verdict = JunctionVerdict::JOINED;
  double confidence = 0.0; /**< of the verdict, 0 to 1 */
};

/** \brief When a junction is believed. */
struct JunctionParameters {
  /** \brief false: every pair that a line connects is joined. */
  bool judge = true;
  /** \brief Least log odds of what is joined. Default 0.5: in doubt it is left open. */
  double joined_from = 0.5;
  /** \brief Log odds below which two boundaries are different objects for sure; of a
   * junction that is joined a line by itself with less is not believed. */
  double different_below = -2.0;
};

/** \brief The surface beside a boundary vertex: what a junction's evidence is made of.
 */
struct SurfaceEnd {
  Direction normal = Direction::Zero();   /**< area-weighted mean, unit; or zero */
  Direction conormal = Direction::Zero(); /**< the way the surface goes on, unit */
  double edge = 0.0;                      /**< median length of edges around */
};

/** \brief Normal and conormal of the connected surface within four edges of a vertex:
 * with its centroid g and its normal n, the conormal is what is left of q - g across n.
 * Robust where the rim is jagged. Cost: some hundred triangles. */
SurfaceEnd
surfaceEndAt(const IncompleteModel& model, pcl::index_t vertex);

/** \brief The junctions that arrived lines make, by ascending curves, each judged by
 * itself.
 * \param[in] loops of the model
 * \param[in] loop_of_curve the loop of each curve of the boundaries
 * \param[in] boundaries what the lines' ends refer to
 * \param[in] sight what sensors have seen, or null */
std::vector<Junction>
findJunctions(const IncompleteModel& model,
              const BoundaryLoops& loops,
              const std::vector<std::size_t>& loop_of_curve,
              const BoundaryEdges& boundaries,
              const std::vector<ForceLine>& lines,
              const SightLines* sight,
              const JunctionParameters& parameters);

} // namespace repair
} // namespace pcl
