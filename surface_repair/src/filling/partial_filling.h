// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a hole of which a part has been closed.

#pragma once

#include "filling/filling_method.h"
#include "mesh/box_tree.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace pcl::repair {

/** \brief Triangles inside a hole, and what of it they leave open.
 *
 * Kept are the triangles that hang together with the polygon over edges, as long as
 * every vertex has one gap at most: then what is open are loops, each of which can be
 * closed like a hole. */
class PartialFilling {
public:
  /** \brief \param[in] triangles wound like the surface around, no edge twice in one
   * direction; corners below the polygon's size are its points
   * \param[in] points of the polygon and of all inner vertices */
  PartialFilling(const FillingTask& task, Triangles triangles, const Positions& points);

  const Triangles&
  triangles() const
  {
    return triangles_;
  }

  /** \brief The vertices of each open loop, what is closed already on its left. */
  std::vector<std::vector<pcl::index_t>>
  openLoops() const;

  /** \brief The task to close one of them, where our triangles are in the way as well.
   * This, and what it was made from, must outlive it. */
  FillingTask
  taskFor(const std::vector<pcl::index_t>& loop) const;

private:
  using HalfEdge = std::array<pcl::index_t, 2>;

  void
  readEdges();
  void
  keepConnected();
  bool
  dropPinches();
  bool
  isPolygonEdge(const HalfEdge& edge) const;
  std::vector<HalfEdge>
  openEdges() const;
  Direction
  normalAlong(const HalfEdge& edge) const;
  bool
  areJoined(pcl::index_t a, pcl::index_t b) const;
  bool
  meetsTriangles(const ccaa::Corners& corners) const;

  const FillingTask& task_;
  const Positions& points_;
  Triangles triangles_;
  std::map<HalfEdge, std::size_t> triangle_at_; /**< that runs through the edge so */
  ccaa::BoxTree tree_;                          /**< of the triangles */
};

} // namespace pcl::repair
