// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what lies within a few edges of a vertex of a surface.
#pragma once

#include "mesh/corners.h"
#include "mesh/disjoint_sets.h"
#include "mesh/index_set.h"
#include "mesh/triangle_adjacency.h"

#include <vector>

namespace pcl::ccaa {

/** \brief What the angles at a vertex add up to, radians, to some 1e-4 each.
 * \param[in] counts whether a triangle does */
template <typename Counts>
double
anglesAt(pcl::index_t vertex,
         const Triangles& triangles,
         const TriangleAdjacency& adjacency,
         const PointView& points,
         const Counts& counts)
{
  double sum = 0.0;
  for (const auto* t = adjacency.begin(vertex); t != adjacency.end(vertex); ++t)
    if (counts(*t)) {
      const auto [one, other] =
          edgesAt(triangles[static_cast<std::size_t>(*t)], vertex, points);
      sum += roughAngleBetween(one, other);
    }
  return sum;
}

/** \brief The same of all. */
inline double
anglesAt(pcl::index_t vertex,
         const Triangles& triangles,
         const TriangleAdjacency& adjacency,
         const PointView& points)
{
  return anglesAt(
      vertex, triangles, adjacency, points, [](pcl::index_t) { return true; });
}

/** \brief The triangles within some edges of a vertex or an opening. */
class Surroundings {
public:
  Surroundings(const std::vector<pcl::index_t>& center,
               const Triangles& triangles,
               const TriangleAdjacency& adjacency,
               const PointView& points)
  : triangles_(triangles), adjacency_(adjacency), points_(points), vertices_(center)
  {}

  /** \brief Go one edge farther. */
  void
  addRing();

  /** \brief Whether Euler's characteristic is 1, as nearly always. */
  bool
  areDisc() const
  {
    return vertices_.size() * 2 == chosen_.size() + rims_.size() + borders_.size() + 2;
  }

  /** \brief Whether they are an annulus whose two rims turn like those of wide cones,
   * but for openings of which all is among them. */
  bool
  areNeck() const;

  /** \brief Whether they have a genus. Where they touch themselves at a vertex, the
   * corners of each fan count as a vertex of their own. */
  bool
  haveHandle() const;

  /** \brief Whether they are a disc around which the surface goes on like a tube. */
  bool
  areCap() const;

  /** \brief The mean of the vertices. */
  Position
  center() const;

  /** \brief What the normals of the triangles add up to, as long as twice the areas: of
   * a cap, along its axis outward. */
  Position
  areaVector() const;

  /** \brief Ring by ring, as triangles(). */
  const std::vector<pcl::index_t>&
  vertices() const
  {
    return vertices_.items();
  }

  const std::vector<pcl::index_t>&
  triangles() const
  {
    return chosen_.items();
  }

private:
  static std::size_t
  cornerOf(std::size_t place, int corner)
  {
    return 3 * place + static_cast<std::size_t>(corner);
  }

  /** Join the corners at both ends of an edge with those of the triangle across it. */
  void
  joinAcross(std::size_t place, int corner, DisjointSets& fans) const;

  void
  findRims(std::size_t first_added);

  /** Whether a boundary of the surface leads out of them. */
  bool
  reachBorder() const;

  /** By how much each rim turns towards the inside, radians, 2 pi around a disc. */
  std::vector<double>
  turnsOf(const std::vector<TriangleAdjacency::Edge>& edges) const;

  const Triangles& triangles_;
  const TriangleAdjacency& adjacency_;
  const PointView& points_;
  IndexSet vertices_;
  std::size_t rim_ = 0; /**< those from here on the last ring has added */
  IndexSet chosen_;     /**< triangles */
  std::vector<TriangleAdjacency::Edge> rims_;    /**< the surface goes on there */
  std::vector<TriangleAdjacency::Edge> borders_; /**< and ends there */
};

} // namespace pcl::ccaa
