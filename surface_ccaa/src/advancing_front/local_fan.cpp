// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the angular order of the triangles around an open point.
#include "advancing_front/local_fan.h"

#include "advancing_front/tangent_frame.h"
#include "advancing_front/tuning.h"

namespace pcl::ccaa {

bool
fitsFans(const GrowingSurface& surface,
         pcl::index_t vertex,
         pcl::index_t from,
         pcl::index_t to,
         const Position& normal)
{
  const Front& front = surface.front();
  const Position mean = surface.normalSum(vertex).normalized() + normal;
  if (!(mean.squaredNorm() > 0.01))
    return false;
  bool fits = true;
  front.forEdgesFrom(vertex, [&](FrontIndex out) {
    const pcl::index_t fan_from = front[out].to;
    const pcl::index_t fan_to = front[front[out].previous].from;
    const TangentFrame frame(surface.position(vertex), mean, surface.position(fan_to));
    const double gap =
        fan_from == fan_to ? 2.0 * M_PI : frame.angle(surface.position(fan_from));
    const double start = from == fan_to ? 0.0 : frame.angle(surface.position(from));
    const double end = to == fan_from ? gap : frame.angle(surface.position(to));
    const bool begins_inside = start <= gap + tuning::FAN_TOLERANCE ||
                               start >= 2.0 * M_PI - tuning::FAN_TOLERANCE;
    const bool ends_inside = end <= gap + tuning::FAN_TOLERANCE;
    const bool in_order = start >= 2.0 * M_PI - tuning::FAN_TOLERANCE ||
                          start <= end + tuning::FAN_TOLERANCE;
    fits = fits && begins_inside && ends_inside && in_order;
  });
  return fits;
}

} // namespace pcl::ccaa
