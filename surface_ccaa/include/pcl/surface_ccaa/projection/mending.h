// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a second try where triangles stood in the way of others.
#pragma once

#include <pcl/surface_ccaa/projection/completion_parameters.h>
#include <pcl/surface_ccaa/projection/nearby_triangles.h>
#include <pcl/surface_ccaa/projection/new_islands.h>
#include <pcl/surface_ccaa/projection/open_surface.h>
#include <pcl/surface_ccaa/projection/partial_surface.h>
#include <pcl/surface_ccaa/run_control.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace pcl {
namespace ccaa {

/** \brief Takes triangles away around obstructed points and lets the surface grow there
 * anew; what comes out replaces what was there only if it has fewer flaws: boundary
 * edges, unused points, points where fans touch. So a try can do no harm.
 *
 * Points that belong together (corners of one triangle) are tried together. A try that
 * fails is repeated with one more ring of triangles, up to three times; each time
 * smooth continuations go first, and if that does not help the smallest triangles. */
class Mending {
public:
  /** \param[in,out] surface the whole
   * \param[in] open the open surface of the growth before, whose neighbor rows tell
   * which unused points are near
   * \param[in] vertices what its vertices are in the whole
   * \param[in] nearby what must not be crossed
   * \param[in] rule when a new piece stays */
  Mending(PartialSurface& surface,
          const OpenSurface& open,
          const std::vector<pcl::index_t>& vertices,
          const NearbyTriangles& nearby,
          const CompletionParameters& parameters,
          const LastingRule& rule)
  : surface_(surface)
  , open_(open)
  , vertices_(vertices)
  , nearby_(nearby)
  , parameters_(parameters)
  , rule_(rule)
  {}

  /** \brief Try everywhere.
   * \param[in] obstructed points, numbered as in the open surface
   * \return false when cancelled */
  bool
  run(const std::vector<pcl::index_t>& obstructed, RunControl* control);

  /** \brief Given triangles that were replaced. */
  std::size_t
  replacedGiven() const
  {
    return replaced_given_;
  }

private:
  /** What growing anew made. */
  struct Attempt {
    std::size_t flaws = std::numeric_limits<std::size_t>::max();
    Triangles made;
  };

  std::vector<std::vector<pcl::index_t>>
  groups(const std::vector<pcl::index_t>& points) const;
  bool
  mend(std::vector<pcl::index_t>& points, RunControl* control);
  Attempt
  growAnew(const OpenSurface& gap,
           const CompletionParameters& parameters,
           RunControl* control) const;
  std::vector<pcl::index_t>
  removableAt(const std::vector<pcl::index_t>& points) const;
  void
  addUnusedNear(const std::vector<pcl::index_t>& points,
                std::vector<pcl::index_t>& open) const;
  void
  replace(const std::vector<pcl::index_t>& removed,
          const Triangles& added,
          const std::vector<pcl::index_t>& vertices);

  PartialSurface& surface_;
  const OpenSurface& open_;
  const std::vector<pcl::index_t>& vertices_;
  const NearbyTriangles& nearby_;
  const CompletionParameters& parameters_;
  LastingRule rule_;
  std::vector<pcl::index_t> number_in_open_; /**< of a vertex of the whole, or -1 */
  std::size_t replaced_given_ = 0;
};

} // namespace ccaa
} // namespace pcl
