// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: opens a surface where its windings cannot agree.
#pragma once

#include "tiles/tiling.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace pcl::ccaa {

/** \brief Which triangles have to go so that a one-sided surface is a manifold that is
 * wound alike: those at the edges at which it is torn, and of the fans which that
 * leaves at a point all but the largest.
 *
 * The surface is not known as a whole: as long as points are asked for, see() has to be
 * told all triangles at these (others are passed over), and then settle() be called. */
class Tearing {
public:
  using Edge = std::array<WideIndex, 2>;

  /** \param[in] torn edges, their ends in order */
  explicit Tearing(const std::vector<Edge>& torn);

  const std::set<WideIndex>&
  asked() const
  {
    return asked_;
  }

  void
  see(const WideTriangle& triangle);

  void
  settle();

  /** \brief Those that go: corners in order. */
  const std::set<WideTriangle>&
  gone() const
  {
    return gone_;
  }

  /** \brief How many edges more are open without them, where a torn edge counted as
   * two. */
  std::int64_t
  openEdges() const;

private:
  bool
  isTorn(const WideTriangle& triangle) const;
  std::set<WideTriangle>
  smallerFansAt(WideIndex point) const;

  std::set<Edge> torn_;
  std::set<WideIndex> asked_;
  std::map<WideIndex, std::set<WideTriangle>> at_; /**< triangles, by point */
  std::set<WideTriangle> gone_;
};

} // namespace pcl::ccaa
