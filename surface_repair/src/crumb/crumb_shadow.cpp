// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what of the patches covers a crumb.

#include "crumb/crumb_shadow.h"

#include "fairing/triangle_search.h"

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
  std::vector<std::size_t> places; /**< among those near a crumb */
  TriangleSearch search;
};

PatchTriangles
patchTriangles(const std::vector<std::size_t>& near, const GrowingSurface& surface)
{
  std::vector<std::size_t> places;
  std::vector<ccaa::Corners> corners;
  for (std::size_t i = 0; i < near.size(); ++i)
    if (surface.hole[near[i]] != NONE) {
      places.push_back(i);
      corners.push_back(ccaa::cornersOf(surface.triangles[near[i]], surface.positions));
    }
  return {std::move(places), TriangleSearch(std::move(corners))};
}

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
      shadow.triangles[patches.places[place.triangle]] = true;
      if (!(place.distance < shadow.distance))
        continue;
      shadow.distance = place.distance;
      closest = place;
      farther = sample;
    }
  }
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
          const std::vector<std::size_t>& near,
          double reach,
          const GrowingSurface& surface)
{
  std::vector<ccaa::Corners> corners;
  for (const std::size_t t : crumb)
    corners.push_back(ccaa::cornersOf(surface.triangles[t], surface.positions));
  const PatchTriangles patches = patchTriangles(near, surface);
  std::vector<CrumbShadow> shadows;
  for (const bool turned : {false, true}) {
    CrumbShadow shadow{turned, std::vector<bool>(near.size(), false)};
    if (castShadow(corners, patches, reach, shadow))
      shadows.push_back(std::move(shadow));
  }
  if (shadows.size() == 2 && shadows[1].distance < NEARER * shadows[0].distance)
    std::swap(shadows[0], shadows[1]);
  return shadows;
}

} // namespace pcl::repair
