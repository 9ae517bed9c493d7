// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: CGAL's scale space reconstruction as a rival, where CGAL is
// installed.
#include "measuring.h"
#include "rivals.h"

#ifdef PSR_HAVE_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>
#endif

#include <vector>

namespace bench {

bool
hasScaleSpace()
{
  return hasAdvancingFront();
}

Reconstruction
scaleSpace([[maybe_unused]] const Cloud& cloud)
{
  Reconstruction result;
#ifdef PSR_HAVE_CGAL
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  result.seconds = secondsOf([&] {
    std::vector<Kernel::Point_3> points;
    for (const pcl::PointXYZ& point : cloud)
      points.emplace_back(point.x, point.y, point.z);
    CGAL::Scale_space_surface_reconstruction_3<Kernel> reconstruction(points.begin(),
                                                                      points.end());
    reconstruction.increase_scale(4);
    reconstruction.reconstruct_surface();
    for (auto f = reconstruction.facets_begin(); f != reconstruction.facets_end(); ++f)
      result.triangles.push_back(
          {pcl::index_t((*f)[0]), pcl::index_t((*f)[1]), pcl::index_t((*f)[2])});
  });
#endif
  return result;
}

} // namespace bench
