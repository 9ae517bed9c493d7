// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: whether two boundaries belong to one surface.

#pragma once

#include <pcl/surface_repair/model_findings.h>
#include <pcl/surface_repair/repair_parameters.h>

#include "boundary/boundary_loop.h"
#include "force_line/boundary_edges.h"
#include "force_line/force_line.h"
#include "junction/sight_lines.h"
#include "run/run_control.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace pcl::repair {

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

/** \brief The surface beside vertices of a model, looked at once for each. */
class SurfaceEnds {
public:
  /** \brief \param[in] model must outlive this */
  explicit SurfaceEnds(const IncompleteModel& model) : model_(model) {}

  const SurfaceEnd&
  at(pcl::index_t vertex);

private:
  const IncompleteModel& model_;
  std::map<pcl::index_t, SurfaceEnd> ends_;
};

/** \brief Log odds from which a junction is joined. */
double
oddsThatJoin(const JunctionEvidence& evidence, const JunctionParameters& parameters);

/** \brief The junctions that arrived lines make, by ascending curves, each judged by
 * itself.
 * \param[in,out] ends of the model
 * \param[in] loops of the model
 * \param[in] loop_of_curve the loop of each curve of the boundaries
 * \param[in] boundaries what the lines' ends refer to
 * \param[in] sight what sensors have seen, or null
 * \param[in] facing of the model, see facingOf()
 * \param[in,out] control told the work, may be null; after cancelling some are missing
 */
std::vector<Junction>
findJunctions(SurfaceEnds& ends,
              const BoundaryLoops& loops,
              const std::vector<std::size_t>& loop_of_curve,
              const BoundaryEdges& boundaries,
              const std::vector<ForceLine>& lines,
              const SightLines* sight,
              double facing,
              const JunctionParameters& parameters,
              ccaa::RunControl* control = nullptr);

} // namespace pcl::repair
