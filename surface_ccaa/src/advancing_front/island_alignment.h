// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: winding the given islands alike before they are joined.
#pragma once

#include "mesh/islands.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace pcl::ccaa {

/** \brief A boundary point of a part of an island. */
struct PartPoint {
  pcl::index_t point;
  std::size_t part;
};

/** \brief Boundary points of two parts that lie next to each other. */
struct PartContact {
  PartPoint one, other;
};

/** \brief What neighboring islands say of each other. */
struct IslandVotes {
  std::vector<std::size_t> island_of_part;
  std::vector<std::size_t> sizes; /**< of the islands, in triangles */
  /** \brief Of two islands: positive for alike. */
  std::map<std::pair<std::size_t, std::size_t>, double> between;
};

/** \brief Each pair of islands asks its contacts: two boundary points that lie in each
 * other's tangent planes should have like normals; sheets that face each other, as of a
 * thin plate, do not lie in each other's planes and have no say.
 *
 * What doubtful triangles alone connect need not be wound alike: one that is folded
 * back onto its neighbor turns all that hangs on it. Parts of an island that its other
 * parts speak against count as islands of their own, behind the given ones.
 *
 * \param[in] triangles consistently wound within each part
 * \param[in] adjacency of these
 * \param[in] islands of these
 * \param[in] parts of the islands, connected without doubtful triangles
 * \param[in] points of the vertices
 * \param[in] contacts in a fixed order */
IslandVotes
askNeighbors(const Triangles& triangles,
             const TriangleAdjacency& adjacency,
             const Islands& islands,
             const Islands& parts,
             const PointView& points,
             const std::vector<PartContact>& contacts);

/** \brief Reverse islands so that neighbors agree on their outer side.
 *
 * An island about which there is evidence is wound by it and never turned for the sake
 * of a neighbor: two of them that do not fit each other stay as they are, and no
 * surface can join them. Of the others the clearest pairs decide first, around an
 * island with evidence, or else the largest one of each group.
 *
 * \param[in,out] triangles consistently wound within each part
 * \param[in,out] adjacency of these, which it follows
 * \param[in] parts of the islands
 * \param[in] votes of these
 * \param[in] evidence one for each given island as evidentSides() has it: below 0 to
 * turn it, 0 where there is none; or empty
 * \return whether any triangle was reversed */
bool
alignIslands(Triangles& triangles,
             TriangleAdjacency& adjacency,
             const Islands& parts,
             const IslandVotes& votes,
             std::vector<double> evidence);

} // namespace pcl::ccaa
