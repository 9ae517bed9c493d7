// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: components of a mesh and the winding that suits each.
#pragma once

#include "mesh/triangle.h"
#include "mesh/triangle_adjacency.h"
#include "run/run_control.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

struct LoopContext;

/** \brief 1 when the triangle runs through the edge from a to b. Without branches,
 * because in a raw mesh the answer is as good as random. */
inline pcl::index_t
runsAlong(const Triangle& triangle, pcl::index_t a, pcl::index_t b)
{
  const auto is = [&](std::size_t from, std::size_t to) {
    return static_cast<int>(triangle[from] == a) & static_cast<int>(triangle[to] == b);
  };
  return is(0, 1) | is(1, 2) | is(2, 0);
}

/** \brief Whether the triangles on both sides of an edge run through it in the same
 * direction, so that one of them shows its other side.
 * \param[in] corner at which the edge begins \return false on a border */
inline bool
disagreesAcross(const Triangles& triangles,
                const TriangleAdjacency& adjacency,
                pcl::index_t triangle,
                int corner)
{
  const pcl::index_t other = adjacency.across(triangle, corner);
  const auto from = static_cast<std::size_t>(corner);
  const Triangle& own = triangles[static_cast<std::size_t>(triangle)];
  return other >= 0 && runsAlong(triangles[static_cast<std::size_t>(other)],
                                 own[from],
                                 own[(from + 1) % 3]) != 0;
}

/** \brief What the walk over one component found. */
struct WoundComponent {
  pcl::index_t first_triangle = 0; /**< lowest index; its winding is the reference */
  std::size_t triangles = 0;
  std::size_t turned = 0; /**< triangles wound against the first one */
  bool closed = true;
  bool one_sided = false;
};

/** \brief Of each triangle a bit for each corner whose edge leads to a lower triangle:
 * components do not go on across it. Empty: across all edges. */
using CutEdges = std::vector<std::uint8_t>;

/** \brief Every triangle's component, and whether it is wound against the component's
 * first triangle. */
class Winding {
public:
  /** \brief Walk all components.
   * \return false when cancelled */
  bool
  find(const Triangles& triangles,
       const TriangleAdjacency& adjacency,
       int threads,
       RunControl& control,
       const CutEdges& cut = {});

  /** \brief By ascending first triangle. */
  const std::vector<WoundComponent>&
  components() const
  {
    return components_;
  }

  /** \brief Twice the component, and one more if turned. */
  pcl::index_t
  state(pcl::index_t triangle) const
  {
    return state_[static_cast<std::size_t>(triangle)];
  }

  std::size_t
  componentOf(std::size_t triangle) const
  {
    return static_cast<std::size_t>(state_[triangle] >> 1);
  }

  bool
  isTurned(std::size_t triangle) const
  {
    return (state_[triangle] & 1) != 0;
  }

  /** \brief -1 for a turned triangle, else 1. */
  double
  sign(std::size_t triangle) const
  {
    return static_cast<double>(1 - 2 * (state_[triangle] & 1));
  }

private:
  std::vector<pcl::index_t> state_; /**< 2 * component + turned */
  std::vector<WoundComponent> components_;
};

/** \brief Flags of the triangles that run through an edge as the neighbor there does.
 */
std::vector<std::uint8_t>
findDisagreements(const Triangles& triangles,
                  const TriangleAdjacency& adjacency,
                  const LoopContext& context);

} // namespace pcl::ccaa
