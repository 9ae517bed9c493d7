// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what every way to close a simple hole has in common (4.7).

#pragma once

#include "boundary/boundary_loop.h"
#include "mesh/corners.h"
#include "run/run_control.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl::repair {

/** \brief A hole to be closed, and what is known about the place. */
struct FillingTask {
  BoundaryCurve polygon; /**< the surface on the left; at least three points, no two of
                              them at one place */
  /** \brief Whether two points of the polygon, not neighbours in it, are ends of an
   * edge of the surface already: such an edge cannot be had once more. Null: none are.
   */
  std::function<bool(std::size_t, std::size_t)> joined;
  /** \brief Whether a triangle would run through what is there already. Null: nothing
   * is in the way, or it is not to be looked at. Expensive: some microseconds. */
  std::function<bool(const ccaa::Corners&)> obstructed;
  /** \brief Whether the way between two points runs through what is there, so that all
   * triangles with that edge are obstructed. Null: triangles are asked for alone. */
  std::function<bool(const Position&, const Position&)> crossed;
  /** \brief The triangulation that would be taken without these is known to run into
   * something: it is not looked at again. */
  bool has_failed = false;
  /** \brief Of a ring that was cut open the place at which its second loop begins, and
   * then two points may be at one place; else 0. See stitchRing(). */
  std::size_t second_loop = 0;
  ccaa::RunControl* control = nullptr; /**< of the work; once that says stop what comes
                                            out is worth nothing */
  /** \brief Where the polygon passes points twice: the number of each of its points. No
   * edge between two of these numbers comes twice then. Else empty. */
  std::vector<pcl::index_t> vertices;
  Positions free_points; /**< trusted samples of the missing area, near the hole */
};

/** \brief Triangles that close a hole. */
struct Filling {
  /** \brief Points within the hole; after those of the polygon they are the vertices of
   * the triangles. */
  Positions inner;
  /** \brief For each of them the free point that it is, NONE where it is a new one. */
  std::vector<std::size_t> free_point;
  /** \brief Corners below the polygon's size are its points. Every edge of the polygon
   * has one triangle, which runs through it against its direction, every other edge
   * two: a disc, wound like the surface around. */
  Triangles triangles;
  std::string problem; /**< why there is no filling, without a full stop; else empty */

  bool
  closed() const
  {
    return problem.empty();
  }
};

/** \brief A way to close simple holes (D4.1-3). Objects have no state that a call could
 * change: one may be used from several threads at once. */
class FillingMethod {
public:
  virtual ~FillingMethod() = default;

  /** \brief For reports, such as "fan". */
  virtual const char*
  name() const = 0;

  /** \brief Number of edges up to which a hole is simple for this method (D4.1-3). */
  virtual std::size_t
  simpleEdges() const = 0;

  /** \brief Close a hole, whatever its number of edges, as well as the method can. */
  virtual Filling
  close(const FillingTask& task) const = 0;
};

} // namespace pcl::repair
