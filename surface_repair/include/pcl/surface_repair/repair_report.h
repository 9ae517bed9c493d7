// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a repair found and did.

#pragma once

#include <pcl/surface_ccaa/surface_topology.h>
#include <pcl/surface_repair/model_findings.h>
#include <pcl/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl {

/** \brief An island of the input. */
struct RepairedIsland {
  std::size_t triangles = 0;
  double area = 0.0; /**< squared units of the cloud */
  bool closed = false;
  bool one_sided = false; /**< left alone */
  repair::IslandSide side;
};

/** \brief A boundary loop of the input. */
struct RepairedLoop {
  std::size_t island = 0;
  std::size_t edges = 0;
  double length = 0.0;       /**< units of the cloud */
  pcl::index_t point = -1;   /**< a point of the cloud on it */
  repair::LoopClass decided; /**< class, confidence and evidence */
};

/** \brief A bridge that was built. */
struct RepairBridge {
  pcl::index_t begin = -1; /**< supporting points: points of the cloud */
  pcl::index_t end = -1;
  std::size_t begin_island = 0;
  std::size_t end_island = 0;
  repair::Positions points; /**< as built, before fairing; ends included; in the frame
                                 of the cloud */
  repair::Directions normals;
  double quality = 0.0;     /**< mean tension (4.41) */
  bool within_hole = false; /**< it divides a hole (4.5); else it joins islands */
};

/** \brief Two boundary loops that force lines connect, and what was decided. */
struct RepairJunction {
  std::size_t pass = 0; /**< of the repair that judged it, from 1 */
  /** Of the cloud, the lowest on each loop. */
  std::array<pcl::index_t, 2> points{-1, -1};
  std::array<std::size_t, 2> islands{}; /**< of that pass */
  std::size_t lines = 0;                /**< that lead from one to the other */
  repair::JunctionEvidence evidence;
  repair::JunctionVerdict verdict = repair::JunctionVerdict::JOINED;
  double confidence = 0.0;     /**< 0 to 1 */
  bool between_mouths = false; /**< both loops are mouths of tubes */
};

/** \brief Why a hole was left open. */
enum class OpenReason : std::uint8_t {
  NONE,              /**< it is closed */
  OUTER_BORDER,      /**< no hole: the outer border of an open surface */
  TUBE_MOUTH,        /**< one of the two mouths of a tube, open like the other one */
  DIFFERENT_OBJECTS, /**< rim of an island that lies beside other objects */
  DEPTH_JUMP,        /**< lies between a silhouette and what stands behind it */
  SEEN_EMPTY,   /**< rim of an island beside a gap that sensors have looked through */
  FIN,          /**< of a small island on an edge that is whole without it */
  NOT_JOINED,   /**< rim of an island that no bridge joins to another one */
  UNDECIDED,    /**< hole or border is not clear */
  ONE_SIDED,    /**< its island has no two sides */
  TOO_LARGE,    /**< beyond the greatest number of edges, or length, to be closed */
  NO_FILLING,   /**< no filling method closes it */
  NOT_MANIFOLD, /**< closing it would make an edge of three triangles */
  INTERSECTION, /**< closing it would run through the surface or another patch */
  TOO_COSTLY,   /**< nothing was found within the work that its size is worth */
  PIERCED,      /**< the given surface runs through its boundary: nothing closes it */
  NOT_WANTED    /**< the user's word: leave open, or do not join */
};

/** \brief A sentence part for messages, such as "its patch would run through the
 * surface". */
const char*
describe(OpenReason reason);

/** \brief As it is called above, such as "NOT_JOINED". */
const char*
nameOf(OpenReason reason);

/** \brief Whether something that should be closed was left open for this reason: all
 * but NONE, OUTER_BORDER, TUBE_MOUTH, DIFFERENT_OBJECTS, DEPTH_JUMP, SEEN_EMPTY, FIN,
 * and what the user wanted: TOO_LARGE, NOT_WANTED. */
bool
isShortfall(OpenReason reason);

/** \brief A hole, bounded by sections of boundaries and by bridges, and what became of
 * it. */
struct RepairedHole {
  std::size_t edges = 0;
  double length = 0.0;              /**< units of the cloud */
  pcl::index_t point = -1;          /**< a point of the cloud on it */
  std::vector<std::size_t> bridges; /**< that it passes, indices into the report's */
  std::vector<std::size_t> islands; /**< that it touches, ascending */
  OpenReason open = OpenReason::NONE;
  bool shortfall = false;      /**< it should be closed: see isShortfall(); where a
                                    watertight surface is wanted, any that is open */
  std::string filling;         /**< name of the method, empty where it is open */
  std::size_t triangles = 0;   /**< new ones */
  std::size_t tries = 0;       /**< fillings that were tried before */
  std::size_t free_points = 0; /**< that became vertices of it */
};

/** \brief Where a triangle of the output comes from. */
enum class TriangleOrigin : std::uint8_t {
  INPUT,          /**< a triangle of the input */
  FAN,            /**< thesis 4.7 */
  MINIMUM_WEIGHT, /**< minimum-weight triangulation */
  COMPLETION      /**< base algorithm, with free points as vertices */
};

const char*
describe(TriangleOrigin origin);

/** \brief Why another topology than that of the output may be the true one. */
enum class DoubtReason : std::uint8_t {
  TUNNEL,    /**< two holes on opposite sides of a body were capped, and a tube between
                 them would take about as little area */
  LONG_GAP,  /**< two boundaries were joined over a gap on evidence that hardly
                 decides, or since there is no better partner for either */
  PARTED,    /**< two boundaries belong together by evidence, but came out in two
                 pieces */
  UNJOINED,  /**< two mouths of tubes were closed each by itself, and evidence hardly
                 decides that they do not belong together; or closed pieces touch, one of
                 them partly new; or one whose islands were joined around a bend lies
                 near what is new of a larger one */
  THIN_NECK, /**< what is new narrows to a ring of a few edges, and widens again on both
                 sides, as between bodies that touch */
  UNSUPPORTED /**< much of the surface is new, and little tells what was lost there */
};

/** \brief A sentence part for messages, such as "two holes may be the mouths of a
 * tunnel". */
const char*
describe(DoubtReason reason);

/** \brief As it is called above, such as "TUNNEL". */
const char*
nameOf(DoubtReason reason);

/** \brief What the evidence does not decide: the output has the likelier topology. */
struct RepairDoubt {
  DoubtReason reason = DoubtReason::TUNNEL;
  std::array<pcl::index_t, 2> points{-1, -1}; /**< of the cloud, the lowest on the rim
                                                 of each cap; of a TUNNEL, ascending; of
                                                 a THIN_NECK, one on it and -1 */
  double ratio = 0.0; /**< area of the tube in that of the two caps, of what nothing
                           supports in that of all, or a gap in the extent of the
                           smaller boundary */
};

/** \brief What one run of ForceLineHoleRepair found and did. */
struct RepairReport {
  repair::ReadingReport reading;
  std::size_t free_points = 0;
  std::vector<RepairedIsland> islands;
  std::vector<RepairedLoop> loops;
  std::vector<RepairJunction> junctions; /**< of all passes */
  std::vector<RepairBridge> bridges;
  std::vector<RepairedHole> holes; /**< all boundaries that were there after bridging */
  repair::IcmCounts counts_before;
  repair::IcmCounts counts_after;
  repair::IcmClass class_before = repair::IcmClass::ICM1;
  repair::IcmClass class_after = repair::IcmClass::ICM1;
  ccaa::SurfaceTopology before; /**< of the input as read */
  ccaa::SurfaceTopology after;  /**< of the output, which was proved a manifold */
  std::size_t input_triangles = 0;
  std::size_t new_triangles = 0;
  std::size_t new_vertices = 0;
  std::vector<TriangleOrigin> origins; /**< one a triangle of the output */
  std::vector<std::size_t> hole_of;    /**< one a triangle of the output: index into
                                            holes, repair::NONE for input triangles */
  std::size_t shortfalls = 0;          /**< holes left open that should be closed */
  std::vector<RepairDoubt> doubts;     /**< about what was closed */
  std::vector<std::pair<std::string, double>> seconds; /**< of each step */
  bool cancelled = false;
  bool finished = false; /**< the output holds the result; false before the first run,
                              after an error and after cancelling */

  /** \brief The run came to its end, all that should be closed is closed, and nothing
   * is in doubt. */
  bool
  complete() const
  {
    return finished && shortfalls == 0 && doubts.empty();
  }
};

} // namespace pcl
