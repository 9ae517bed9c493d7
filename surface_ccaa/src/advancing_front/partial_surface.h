// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: given and new triangles while a surface is completed.
#pragma once

#include "advancing_front/open_surface.h"
#include "mesh/orientation.h"
#include "mesh/point_chains.h"
#include "mesh/point_view.h"
#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"
#include "run/run_control.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief A mesh in which triangles come and go: the given ones first, then the new
 * ones in the order in which they came. Triangles keep their numbers. Const methods may
 * be called from several threads. */
class PartialSurface {
public:
  /** \brief All must outlive the object; the given triangles may be re-wound meanwhile.
   * \param[in] adjacency of the given triangles
   * \param[in] points of the vertices
   * \param[in] hints normals and sensor positions, one per vertex, or empty */
  PartialSurface(const Triangles& given,
                 const TriangleAdjacency& adjacency,
                 const PointView& points,
                 const OrientationHints& hints);

  std::size_t
  vertexCount() const
  {
    return adjacency_.vertexCount();
  }

  std::size_t
  triangleCount() const
  {
    return alive_given_.size() + added_.size();
  }

  bool
  isGiven(pcl::index_t triangle) const
  {
    return static_cast<std::size_t>(triangle) < alive_given_.size();
  }

  bool
  isAlive(pcl::index_t triangle) const;

  const Triangle&
  operator[](pcl::index_t triangle) const;

  const AliveFlags&
  aliveGiven() const
  {
    return alive_given_;
  }

  /** \brief Calls use(triangle) for the live triangles at a vertex, the given ones
   * ascending, then the new ones descending. */
  template <typename Use>
  void
  forTrianglesAt(pcl::index_t vertex, Use use) const
  {
    for (const auto* t = adjacency_.begin(vertex); t != adjacency_.end(vertex); ++t)
      if (isAlive(*t))
        use(*t);
    if (first_added_.empty())
      return;
    pcl::index_t corner = first_added_[static_cast<std::size_t>(vertex)];
    for (; corner != NO_CORNER; corner = next_added_[static_cast<std::size_t>(corner)])
      if (const auto t = triangleOfCorner(corner); isAlive(t))
        use(t);
  }

  /** \brief Live triangles that touch any of some vertices, ascending. */
  std::vector<pcl::index_t>
  trianglesAt(const std::vector<pcl::index_t>& vertices) const;

  /** \brief Some vertices and all that are so many edges from them, ascending. */
  std::vector<pcl::index_t>
  verticesAround(std::vector<pcl::index_t> vertices, int edges) const;

  /** \brief Whether an edge at a vertex has one live triangle alone. */
  bool
  isBorder(pcl::index_t vertex) const;

  void
  remove(pcl::index_t triangle);

  void
  add(const Triangle& triangle);

  /** \brief The surface around some vertices, with these as its open points, in their
   * order, and the triangles that touch them as its rim. Neighbors are not filled in.
   * Spacings come from the given triangles, also those that have been removed, or from
   * noteSpacing().
   * \param[in] removed triangles to leave out, ascending
   * \param[out] vertices what the vertices of the open surface are here
   * \param[in,out] control told the work, may be null \return nothing of use after
   * cancelling */
  OpenSurface
  openAt(const std::vector<pcl::index_t>& open,
         const std::vector<pcl::index_t>& removed,
         std::vector<pcl::index_t>& vertices,
         RunControl* control = nullptr) const;

  /** \brief Say what the spacing is around a vertex without given triangles. */
  void
  noteSpacing(pcl::index_t vertex, double spacing);

  /** \brief Say how far from samples a gap may get that is closed, in spacings. */
  void
  setLargestRoom(double room)
  {
    largest_room_ = room;
  }

  /** \brief Mean length of the shorter half of a point's given edges, or what
   * noteSpacing() said; 0 without either. */
  double
  spacingAt(pcl::index_t vertex) const;

private:
  static constexpr pcl::index_t NO_CORNER = -1;

  pcl::index_t
  triangleOfCorner(pcl::index_t corner) const
  {
    return static_cast<pcl::index_t>(alive_given_.size()) + corner / 3;
  }

  const Triangles& given_;
  const TriangleAdjacency& adjacency_;
  PointView points_;
  OrientationHints hints_;
  AliveFlags alive_given_, alive_added_;
  Triangles added_;
  std::vector<pcl::index_t> first_added_; /**< of a vertex: its latest new corner */
  std::vector<pcl::index_t> next_added_;  /**< of a new corner: the one before */
  std::vector<float> noted_spacings_;     /**< of a vertex; empty before any note */
  double largest_room_ = tuning::LARGEST_ROOM;
};

} // namespace pcl::ccaa
