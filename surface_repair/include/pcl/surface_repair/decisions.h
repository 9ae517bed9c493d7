// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a user decides about boundary loops and junctions.

#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>
#include <pcl/PolygonMesh.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::repair {

/** \brief What is to become of a boundary loop. */
enum class LoopWish : std::uint8_t {
  AUTO,      /**< as the method finds */
  CLOSE,     /**< close it, whatever its class */
  LEAVE_OPEN /**< neither close it nor join it to another one */
};

/** \brief By what a loop is known again: in a file, and from pass to pass. */
struct LoopKey {
  pcl::index_t point = -1; /**< its lowest point of the cloud */
  std::size_t edges = 0;
  Position center = Position::Zero(); /**< mean of its points */
};

/** \brief A loop of the input with what was found about it, and what is to become of
 * it. Only key, wish and cap count when it is given back. */
struct LoopDecision {
  LoopKey key;
  LoopWish wish = LoopWish::AUTO;
  Cap cap = Cap::AUTO;
  std::size_t island = 0;
  double length = 0.0; /**< units of the cloud */
  BoundaryClass found = BoundaryClass::UNDECIDED;
  double confidence = 0.0; /**< of the class, 0 to 1 */
  bool joined = false;     /**< junctions connect it to others */
  OpenReason reason =
      OpenReason::NONE; /**< why it would stay open; NONE: it would not */
};

/** \brief A pair of loops of the input that force lines connect. Only loops and join
 * count when it is given back. */
struct JunctionDecision {
  std::size_t first_loop = 0; /**< indices into Decisions::loops, the lower one first */
  std::size_t second_loop = 0;
  bool join = true;
  std::size_t bridges = 0;
  double shortest = 0.0; /**< length of its shortest bridge, units of the cloud */
  double quality = 0.0;  /**< highest of its bridges' */
  JunctionVerdict verdict = JunctionVerdict::JOINED; /**< by evidence */
  double confidence = 0.0;                           /**< of the verdict, 0 to 1 */
};

/** \brief Tells whether a mesh is that for which decisions were made. */
struct MeshFingerprint {
  std::size_t points = 0;
  std::size_t polygons = 0;
  std::uint64_t checksum = 0; /**< of all coordinates and corners, in order */

  bool
  operator==(const MeshFingerprint& other) const
  {
    return points == other.points && polygons == other.polygons &&
           checksum == other.checksum;
  }
};

/** \brief Cost: linear. \param[in] mesh whose cloud has passed ccaa::checkCloud() */
MeshFingerprint
fingerprintOf(const pcl::PolygonMesh& mesh);

/** \brief What a user decides. A loop or junction that is not listed is as the method
 * finds. Two islands all of whose listed junctions are not to be joined are kept apart:
 * no other junction takes the place of these. */
struct Decisions {
  MeshFingerprint mesh;
  std::vector<LoopDecision> loops;
  std::vector<JunctionDecision> junctions;
  /** Whether no doubt is told any more about thin necks, and about pieces that may
   * belong together. false: the decisions are no answer to these. */
  bool settles_doubts = true;
};

} // namespace pcl::repair
