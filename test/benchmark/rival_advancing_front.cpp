// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: CGAL's advancing front as a rival, where CGAL is installed.
#include "measuring.h"
#include "rivals.h"

#ifdef PSR_HAVE_CGAL
#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

#include <array>
#include <iterator>

namespace bench {

#ifdef PSR_HAVE_CGAL

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triples = std::vector<std::array<std::size_t, 3>>;

Triples
advance(const Cloud& cloud)
{
  std::vector<Kernel::Point_3> points;
  points.reserve(cloud.size());
  for (const pcl::PointXYZ& p : cloud)
    points.emplace_back(p.x, p.y, p.z);
  Triples triples;
  CGAL::advancing_front_surface_reconstruction(
      points.begin(), points.end(), std::back_inserter(triples));
  return triples;
}

} // namespace

bool
hasAdvancingFront()
{
  return true;
}

Reconstruction
advancingFront(const Cloud& cloud)
{
  Reconstruction result;
  Triples triples;
  result.seconds = secondsOf([&] { triples = advance(cloud); });
  for (const auto& t : triples)
    result.triangles.push_back(
        {pcl::index_t(t[0]), pcl::index_t(t[1]), pcl::index_t(t[2])});
  return result;
}

#else

bool
hasAdvancingFront()
{
  return false;
}

Reconstruction
advancingFront(const Cloud&)
{
  return {};
}

#endif

} // namespace bench
