// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a second try where triangles stood in the way of others.
#pragma once

#include <pcl/surface_ccaa/reconstruction_parameters.h>

#include "advancing_front/nearby_triangles.h"
#include "advancing_front/new_islands.h"
#include "advancing_front/open_surface.h"
#include "advancing_front/partial_surface.h"
#include "mesh/block_loop.h"

#include <array>
#include <cstddef>
#include <vector>

namespace pcl::ccaa {

/** \brief What is wrong around the open points of a mesh. */
struct Flaws {
  std::vector<std::array<pcl::index_t, 2>> borders; /**< boundary edges, ascending */
  std::size_t unused = 0;                           /**< points without triangles */
  std::size_t touching = 0;                         /**< points where fans touch */
  /** \brief Twice the Euler characteristic, less what does not depend on the triangles
   * among the open points. */
  std::ptrdiff_t doubled_characteristic = 0;
  double volume = 0.0; /**< six times that between the triangles and the first point */

  /** \brief Weighed. */
  std::size_t
  count() const
  {
    return borders.size() + 3 * unused + 10 * touching;
  }
};

/** \brief Takes triangles away around obstructed points and lets the surface grow there
 * anew; what comes out replaces what was there only if it is better (Aim): flaws are
 * boundary edges, unused points, points where fans touch. So a try can do no harm.
 *
 * Points that belong together (corners of one triangle) are tried together. A try that
 * leaves flaws is repeated with one more ring of triangles, up to three more times, as
 * long as nothing is better than what is there or each ring is better than the one
 * before; each time smooth continuations go first, and if that does not help the
 * smallest triangles.
 *
 * All groups try at once, on the same state; then those whose places do not overlap
 * replace what was there, in a fixed order, and the others try again, as do those that
 * have made things better but not good. So the result is the same for any number of
 * threads. */
class LocalRegrowth {
public:
  /** \brief What is better: fewer flaws, or a higher characteristic, less the points
   * left unused, with no more handles; what has a handle less must be fuller. */
  enum class Aim { CLOSE, OPEN_HANDLES };

  /** \param[in,out] surface the whole
   * \param[in] open the open surface of the growth before, whose neighbor rows tell
   * which unused points are near
   * \param[in] vertices what its vertices are in the whole
   * \param[in] nearby what must not be crossed
   * \param[in] rule when a new piece stays */
  LocalRegrowth(PartialSurface& surface,
                const OpenSurface& open,
                const std::vector<pcl::index_t>& vertices,
                const NearbyTriangles& nearby,
                const CompletionParameters& parameters,
                const ComponentRule& rule)
  : surface_(surface)
  , open_(open)
  , vertices_(vertices)
  , nearby_(nearby)
  , parameters_(parameters)
  , rule_(rule)
  {}

  /** \brief Try everywhere.
   * \param[in] points of the whole
   * \param[in] loop how to run; stage "local regrowth"
   * \return false when cancelled */
  bool
  run(const std::vector<pcl::index_t>& points, Aim aim, LoopContext loop);

private:
  /** What growing anew made of a place. */
  struct Attempt {
    std::size_t flaws = 0;
    std::vector<pcl::index_t> open;    /**< points it speaks of, ascending */
    std::vector<pcl::index_t> removed; /**< triangles it takes away, ascending */
    Triangles made;                    /**< triangles it puts in */
    bool is_better = false;            /**< than what is there */
  };
  /** Points that are tried together. */
  struct Group {
    std::vector<pcl::index_t> points; /**< ascending */
    int improvements = 0;             /**< that have been made around them */
  };

  std::vector<Group>
  groups(const std::vector<pcl::index_t>& points) const;
  Attempt
  regrow(std::vector<pcl::index_t> points, RunControl* control) const;
  Attempt
  growAnew(const std::vector<pcl::index_t>& points, RunControl* control) const;
  Attempt
  growInto(const OpenSurface& gap,
           const std::vector<pcl::index_t>& vertices,
           const Flaws& before,
           double smooth_fold,
           RunControl* control) const;
  std::vector<Group>
  applyAll(const std::vector<Group>& waiting, const std::vector<Attempt>& attempts);
  std::vector<pcl::index_t>
  removableAt(const std::vector<pcl::index_t>& points) const;
  void
  addUnusedNear(const std::vector<pcl::index_t>& points,
                std::vector<pcl::index_t>& open) const;
  PartialSurface& surface_;
  const OpenSurface& open_;
  const std::vector<pcl::index_t>& vertices_;
  const NearbyTriangles& nearby_;
  const CompletionParameters& parameters_;
  ComponentRule rule_;
  Aim aim_ = Aim::CLOSE;
  bool has_many_groups_ = false;
  std::vector<pcl::index_t> number_in_open_; /**< of a vertex of the whole, or -1 */
};

} // namespace pcl::ccaa
