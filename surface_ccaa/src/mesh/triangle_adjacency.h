// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which triangles meet at a vertex and over an edge.
#pragma once

#include "mesh/triangle.h"
#include "mesh/uninitialized.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::ccaa {

class RunControl;
class VertexLink;
struct LoopContext;

/** \brief What the triangles around one vertex look like, winding left aside. */
enum class Fan : std::uint8_t {
  NONE,    /**< no triangle */
  CLOSED,  /**< one closed chain */
  OPEN,    /**< one open chain */
  SEVERAL, /**< two chains or more, or twice the same triangle */
  OVERFULL /**< an edge at the vertex has three triangles or more */
};

/** \brief Unoriented adjacency of a triangle mesh in flat arrays.
 *
 * PCL's half-edge mesh drops flipped neighbours, the third triangle on an edge and
 * bow-tie vertices; this structure holds them all, because they are what the umbrella
 * filter (thesis 3.4) has to judge.
 *
 * Every triangle must have three different corners, each in [0, vertex_count). Cost:
 * linear; memory 5 bytes a vertex and 24 bytes a triangle. across() goes by the order
 * of corners: where that changes, turn() has to follow. Const methods may be called
 * from several threads.
 */
class TriangleAdjacency {
public:
  /** \brief across(): the edge is a border. */
  static constexpr pcl::index_t NONE = -1;
  /** \brief across(): three triangles or more on the edge; see overfullEdges(). */
  static constexpr pcl::index_t OVERFULL = -2;

  using Edge = std::array<pcl::index_t, 2>;

  /** \brief Build from scratch; the result is the same for any number of threads.
   * \param[in] threads number of threads, at least 1
   * \param[in] control told the progress, if given; once cancelled the object is empty
   */
  void
  build(const Triangles& triangles,
        std::size_t vertex_count,
        int threads = 1,
        RunControl* control = nullptr);

  /** \brief Follow deleted and appended triangles, several times cheaper than build()
   * where the appended ones are few; else, and where there were overfull edges, builds
   * anew. Triangles are numbered anew, in the same order; vertices keep their numbers.
   *
   * \param[in] alive one flag for each triangle: 0 or 1, not deleted; empty: all are
   * \param[in] triangles those that are alive, then the appended ones
   * \param[in] vertex_count at least that before
   * \param[in] threads \param[in] control of build() */
  void
  follow(const std::vector<std::uint8_t>& alive,
         const Triangles& triangles,
         std::size_t vertex_count,
         int threads = 1,
         RunControl* control = nullptr);

  /** \brief Let vertices have other numbers.
   * \param[in] before the number that each had, or -1: it has no triangle; all that
   * have triangles must be among them */
  void
  renumber(const std::vector<pcl::index_t>& before, int threads = 1);

  /** \brief Exchange the second and third corner of a triangle, and follow that. */
  void
  turn(pcl::index_t triangle, Triangles& triangles)
  {
    const auto t = static_cast<std::size_t>(triangle);
    std::swap(triangles[t][1], triangles[t][2]);
    std::swap(across_[3 * t], across_[3 * t + 2]);
  }

  void
  clear();

  std::size_t
  vertexCount() const
  {
    return fans_.size();
  }
  std::size_t
  triangleCount() const
  {
    return across_.size() / 3;
  }

  /** \brief First of the triangles at a vertex, in ascending order. */
  const pcl::index_t*
  begin(pcl::index_t vertex) const
  {
    return incident_.data() + offsets_[static_cast<std::size_t>(vertex)];
  }
  const pcl::index_t*
  end(pcl::index_t vertex) const
  {
    return incident_.data() + offsets_[static_cast<std::size_t>(vertex) + 1];
  }

  /** \brief Triangle over the edge from a corner (0 to 2) to the next corner.
   * \return its index, NONE or OVERFULL (see overfullEdges()) */
  pcl::index_t
  across(pcl::index_t triangle, int corner) const
  {
    return across_[3 * static_cast<std::size_t>(triangle) +
                   static_cast<std::size_t>(corner)];
  }

  /** \brief What the chains around a vertex look like. */
  Fan
  fan(pcl::index_t vertex) const
  {
    return fans_[static_cast<std::size_t>(vertex)];
  }

  /** \brief The same for all vertices. */
  const std::vector<Fan>&
  fans() const
  {
    return fans_;
  }

  /** \brief Edges with three triangles or more, each with its lower vertex first, in
   * ascending order. */
  const std::vector<Edge>&
  overfullEdges() const
  {
    return overfull_edges_;
  }

  /** \brief First of the triangles on an overfull edge, in ascending order.
   * \param[in] place of the edge in overfullEdges() */
  const pcl::index_t*
  beginOverfull(std::size_t place) const
  {
    return overfull_triangles_.data() + overfull_offsets_[place];
  }
  const pcl::index_t*
  endOverfull(std::size_t place) const
  {
    return overfull_triangles_.data() + overfull_offsets_[place + 1];
  }

private:
  using Numbers = UninitializedVector<pcl::index_t>;
  /** \brief A triangle on an overfull edge. */
  using EdgeTriangle = std::pair<Edge, pcl::index_t>;
  /** \brief A vertex and a triangle that has it. */
  using Corner = std::pair<pcl::index_t, pcl::index_t>;

  bool
  listTriangles(const Triangles& triangles,
                std::size_t vertex_count,
                const LoopContext& context);
  bool
  matchEdges(const Triangles& triangles, const LoopContext& context);
  void
  matchVertex(const Triangles& triangles,
              std::size_t vertex,
              VertexLink& link,
              std::vector<EdgeTriangle>& overfull);
  bool
  followAcross(const Numbers& kept_as,
               std::size_t triangle_count,
               const LoopContext& context);
  bool
  followLists(const Numbers& kept_as,
              const std::vector<Corner>& corners,
              const Triangles& triangles,
              std::size_t vertex_count,
              const LoopContext& context);
  void
  listOverfull(const std::vector<EdgeTriangle>& edge_triangles);

  std::vector<std::uint32_t> offsets_{0};
  Numbers incident_;
  Numbers across_;
  std::vector<Fan> fans_;
  std::vector<Edge> overfull_edges_;
  std::vector<std::size_t> overfull_offsets_{0};
  std::vector<pcl::index_t> overfull_triangles_;
};

} // namespace pcl::ccaa
