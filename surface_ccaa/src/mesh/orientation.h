// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: winding all triangles alike and outward (thesis 4.48).
#pragma once

#include "mesh/point_view.h"
#include "mesh/side_hints.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"
#include "run/run_control.h"

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief Share by which votes for one side must outweigh those for the other before
 * they decide, relative to all votes: 0.2 means 60 to 40. Below it the next rule is
 * asked, because noise and wrong normals vote both ways alike. */
constexpr double VOTE_MARGIN = 0.2;

/** \brief Least mean cosine between a surface's normals and the ways to the place that
 * it was measured from: below it is seen edge-on all over. */
constexpr double LEAST_MEAN_COSINE = 0.25;

/** \brief What may be known about the outer side, and how to run. All optional; views
 * that are not empty have one entry per vertex. */
struct OrientationHints : SideHints {
  PointView normals;    /**< of any length; non-finite and zero do not vote */
  PointView viewpoints; /**< sensor position for each vertex; where one is not finite
                             its triangles do not vote */
  /** \brief Turn nothing and report no sides where a component is one-sided: for who
   * means to repair it first. */
  bool stop_if_one_sided = false;
  int threads = 1; /**< at least 1; the result is the same for any */
};

/** \brief One edge-connected component; edges with three triangles or more do not
 * connect. */
struct OrientedComponent {
  pcl::index_t first_triangle = 0; /**< lowest triangle index */
  std::size_t triangles = 0;
  bool closed = false; /**< every edge has exactly two triangles */
  OutwardRule rule = OutwardRule::UNDECIDED;
  double margin = 0.0; /**< how clear the votes were, 0 to 1; 1 for VOLUME */
};

/** \brief What orientTriangles() found and did. */
struct OrientationReport {
  std::size_t reversed = 0;                  /**< triangles wound the other way now */
  std::vector<OrientedComponent> components; /**< by ascending first_triangle */
  std::array<std::size_t, OUTWARD_RULES> decided{}; /**< components by OutwardRule */
  SideTally tally;                                  /**< the same by triangles */
  bool cancelled = false; /**< stopped: the triangles are as they were */

  std::size_t
  oneSided() const
  {
    return decided[static_cast<std::size_t>(OutwardRule::ONE_SIDED)];
  }
};

/** \brief Wind the triangles of each component consistently and the component outward.
 *
 * Rules are asked in the order of OutwardRule: what the user tells, what the cloud has,
 * the shape. Normals vote by the area of the triangle projected along the normal, the
 * same for a direction told to be up. A viewpoint votes by the solid angle of the
 * triangle seen from it, which is why it stays undecided about a closed component that
 * it is outside of, half of which it cannot have seen; the origin votes only where the
 * surface is not seen edge-on all over (mean cosine of 0.25 or more). Volume knows
 * nothing of other components: nested shells are each wound outward. Where it is
 * allowed to guess and most of the surface follows one plane across an axis (within 10
 * degrees), an open component that lies over that plane like a terrain looks along its
 * normal, turned to the axis nearest to it, positive. For the rest the rule of
 * thesis 4.48 (first half) is asked for many directions at once: the triangle that a
 * half-line from the centre of the mesh meets last has free sight to the enclosing
 * sphere, so the side away from the centre is its outer side. Where that is not clear,
 * or there is no free sight at all, an open component that bulges clearly is wound so
 * that it bulges outward (not in the thesis, whose answer, the force field, needs
 * oriented neighbours first).
 *
 * One-sided components (Moebius bands) are reported and left alone. A triangle is
 * reversed by exchanging its second and third corner.
 *
 * The result depends on the order of triangles only where a tie is to be broken, and
 * not at all on the number of threads. Cost: linear, about 60 ns a triangle on one
 * thread, 8 bytes a triangle.
 *
 * \param[in,out] triangles with three different corners below positions.size()
 * \param[in,out] adjacency of these triangles, which it follows
 * \param[in] positions of the vertices; triangles with a non-finite corner do not vote
 * \param[in] hints see there
 * \param[in,out] control stages "orientation" and "outer side" */
OrientationReport
orientTriangles(Triangles& triangles,
                TriangleAdjacency& adjacency,
                const PointView& positions,
                const OrientationHints& hints,
                RunControl& control);

/** \brief What the hints and the volume say about components wound alike, as
 * orientTriangles() would ask them: the margin of the votes, positive to keep the
 * windings of a component, negative to turn it, 0 where nothing is clear. By ascending
 * first triangle, as labelIslands() has them; empty when cancelled. Changes nothing. */
std::vector<double>
evidentSides(const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const PointView& positions,
             const OrientationHints& hints,
             RunControl& control);

/** \brief Where the hints say that the surface at a vertex looks, of any length; zero
 * where they do not. */
Eigen::Vector3d
outwardAt(pcl::index_t vertex,
          const PointView& positions,
          const OrientationHints& hints);

} // namespace pcl::ccaa
