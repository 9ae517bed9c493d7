// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one fan for every point in the end.
#include "advancing_front/fan_settlement.h"

#include <algorithm>
#include <cstdint>
#include <tuple>

namespace pcl::ccaa {
namespace {

/** Operations for a point that is looked at. */
constexpr std::uint64_t SETTLING_WORK = 30;

Fans
fansAt(const PartialSurface& surface, pcl::index_t vertex)
{
  std::vector<pcl::index_t> around;
  surface.forTrianglesAt(vertex, [&](pcl::index_t t) { around.push_back(t); });
  return fansOf(
      around, vertex, [&](pcl::index_t t) -> const Triangle& { return surface[t]; });
}

/** Whether a corner of a fan is none of some points. */
bool
leavesThem(const PartialSurface& surface,
           const std::vector<pcl::index_t>& fan,
           const std::vector<std::uint8_t>& points)
{
  return std::any_of(fan.begin(), fan.end(), [&](pcl::index_t t) {
    const Triangle& triangle = surface[t];
    return std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
      return points[static_cast<std::size_t>(corner)] == 0;
    });
  });
}

} // namespace

std::vector<pcl::index_t>
settleFans(PartialSurface& surface,
           const std::vector<pcl::index_t>& points,
           bool keep_given,
           RunControl* control,
           const std::vector<std::uint8_t>* whole)
{
  WorkCount work(control);
  std::vector<pcl::index_t> taken;
  std::vector<pcl::index_t> waiting = points;
  while (!waiting.empty() && work.add(SETTLING_WORK)) {
    const pcl::index_t vertex = waiting.back();
    waiting.pop_back();
    if (whole != nullptr && (*whole)[static_cast<std::size_t>(vertex)] == 0)
      continue;
    const Fans fans = fansAt(surface, vertex);
    if (fans.size() < 2)
      continue;
    const auto rank = [&](const std::vector<pcl::index_t>& fan) {
      return std::make_tuple(surface.isGiven(fan.front()),
                             whole != nullptr && leavesThem(surface, fan, *whole),
                             fan.size(),
                             -fan.front());
    };
    const auto stays =
        std::max_element(fans.begin(), fans.end(), [&](const auto& a, const auto& b) {
          return rank(a) < rank(b);
        });
    for (auto fan = fans.begin(); fan != fans.end(); ++fan)
      for (const pcl::index_t t : *fan) {
        if (fan == stays || (keep_given && surface.isGiven(t)))
          continue;
        surface.remove(t);
        taken.push_back(t);
        waiting.insert(waiting.end(), surface[t].begin(), surface[t].end());
      }
  }
  return taken;
}

} // namespace pcl::ccaa
