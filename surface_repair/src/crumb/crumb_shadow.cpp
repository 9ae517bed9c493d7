// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what of the patches covers a crumb.

#include "crumb/crumb_shadow.h"

#include "fairing/triangle_search.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <utility>

namespace pcl::repair {

namespace {

/** Steps that are told apart, in edges of the nearest triangle: single triangles lie
 * far above wide patches. */
constexpr double MOST_SLOPES = 16.0;
/** Distance of the patch on the other side of a crumb, in that of the patch on its
 * side, up to which the crumb is turned first. */
constexpr double NEARER = 0.5;

/** Triangles of patches. */
struct PatchTriangles {
  std::vector<std::size_t> places; /**< in the surface */
  TriangleSearch search;
};

/** \param[in,out] shadow of one side: its triangles come empty
 * \return whether all of the crumb has one */
bool
castShadow(const std::vector<ccaa::Corners>& crumb,
           const PatchTriangles& patches,
           double reach,
           CrumbShadow& shadow)
{
  TrianglePlace closest;
  Position farther = Position::Zero(); // of the crumb
  for (const ccaa::Corners& own : crumb) {
    const Eigen::Vector3d normal = (shadow.turned ? -1.0 : 1.0) * ccaa::areaNormal(own);
    Positions samples(own.begin(), own.end());
    samples.push_back((own[0] + own[1] + own[2]) / 3.0);
    const auto shows = [&](const ccaa::Corners& corners) {
      return ccaa::areaNormal(corners).dot(normal) > 0.0;
    };
    for (const Position& sample : samples) {
      const TrianglePlace place = patches.search.nearest(sample, reach, shows);
      if (!place.found())
        return false;
      shadow.triangles.push_back(patches.places[place.triangle]);
      if (!(place.distance < shadow.distance))
        continue;
      shadow.distance = place.distance;
      closest = place;
      farther = sample;
    }
  }
  ccaa::sortUnique(shadow.triangles);
  shadow.nearest = patches.places[closest.triangle];
  const ccaa::Corners& corner = patches.search[closest.triangle];
  const Position foot = closest.barycentric[0] * corner[0] +
                        closest.barycentric[1] * corner[1] +
                        closest.barycentric[2] * corner[2];
  shadow.ahead = std::abs(
      ccaa::areaNormal(corner).normalized().dot((farther - foot).normalized()));
  const double edge = std::max((corner[1] - corner[0]).norm(), 1e-9 * reach);
  shadow.slopes =
      static_cast<int>(std::clamp(shadow.distance / edge, 1.0, MOST_SLOPES));
  return true;
}

} // namespace

std::vector<CrumbShadow>
shadowsOf(const std::vector<std::size_t>& crumb,
          double reach,
          const GrowingSurface& surface,
          ccaa::RunControl* control)
{
  const auto corners_of = [&](const std::vector<std::size_t>& some) {
    std::vector<ccaa::Corners> corners;
    for (const std::size_t t : some)
      corners.push_back(ccaa::cornersOf(surface.triangles[t], surface.positions));
    return corners;
  };
  const std::vector<ccaa::Corners> corners = corners_of(crumb);
  ccaa::Box within;
  for (const ccaa::Corners& own : corners)
    within.extend(ccaa::widened(ccaa::boxOf(own), reach));
  std::vector<std::size_t> places = surface.patchesNear(within, control);
  std::vector<ccaa::Corners> places_corners = corners_of(places);
  const PatchTriangles patches{std::move(places),
                               TriangleSearch(std::move(places_corners))};
  std::vector<CrumbShadow> shadows;
  for (const bool turned : {false, true}) {
    CrumbShadow shadow{turned, {}};
    if (castShadow(corners, patches, reach, shadow))
      shadows.push_back(std::move(shadow));
  }
  if (shadows.size() == 2 && shadows[1].distance < NEARER * shadows[0].distance)
    std::swap(shadows[0], shadows[1]);
  return shadows;
}

} // namespace pcl::repair
