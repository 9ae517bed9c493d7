// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the colours in which an incomplete model is shown.
#include "inspection_colors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace app {
namespace {

using pcl::repair::BoundaryClass;
using pcl::repair::LineEnd;
using pcl::repair::SideRule;

Rgb
mix(const Rgb& from, const Rgb& to, double share)
{
  Rgb mixed{};
  for (std::size_t i = 0; i < mixed.size(); ++i)
    mixed[i] =
        static_cast<std::uint8_t>(std::lround(from[i] + share * (to[i] - from[i])));
  return mixed;
}

Rgb
colorOfRule(SideRule rule)
{
  switch (rule) {
  case SideRule::NORMALS:
    return {150, 200, 235};
  case SideRule::VIEWPOINT:
  case SideRule::TOLD_VIEWPOINT:
  case SideRule::ORIGIN:
  case SideRule::UP:
  case SideRule::PLANE:
    return {165, 215, 165};
  case SideRule::VOLUME:
  case SideRule::FREE_SIGHT:
    return {240, 220, 130};
  case SideRule::FIELD:
    return {240, 170, 185};
  case SideRule::UNDECIDED:
    return {200, 200, 200};
  case SideRule::ONE_SIDED:
    return {215, 120, 230};
  }
  return {};
}

} // namespace

Rgb
colorOf(BoundaryClass boundary_class)
{
  switch (boundary_class) {
  case BoundaryClass::HOLE:
    return {215, 25, 30};
  case BoundaryClass::ISLAND_RIM:
    return {20, 90, 220};
  case BoundaryClass::OUTER_BORDER:
    return {10, 150, 70};
  case BoundaryClass::UNDECIDED:
    return {245, 145, 0};
  }
  return {};
}

Rgb
colorOf(const pcl::repair::IslandSide& side)
{
  const Rgb color = colorOfRule(side.rule);
  return side.flipped ? mix(color, {0, 0, 0}, 0.4) : color;
}

Rgb
colorOf(LineEnd end)
{
  switch (end) {
  case LineEnd::BRIDGE:
    return colorOfBridge(0.0);
  case LineEnd::REPELLED:
    return {90, 90, 90};
  case LineEnd::NO_FIELD:
    return {170, 170, 170};
  case LineEnd::OUT_OF_REACH:
    return {240, 150, 20};
  case LineEnd::TOO_LONG:
    return {130, 80, 30};
  case LineEnd::CROSSES_SURFACE:
    return {225, 0, 200};
  case LineEnd::WRONG_SIDE:
    return {200, 0, 30};
  }
  return {};
}

Rgb
colorOf(pcl::TriangleOrigin origin)
{
  switch (origin) {
  case pcl::TriangleOrigin::INPUT:
    break;
  case pcl::TriangleOrigin::FAN:
    return {235, 170, 50};
  case pcl::TriangleOrigin::MINIMUM_WEIGHT:
    return {60, 140, 225};
  case pcl::TriangleOrigin::COMPLETION:
    return {185, 105, 215};
  }
  return {225, 225, 220};
}

Rgb
colorOf(pcl::OpenReason reason)
{
  switch (reason) {
  case pcl::OpenReason::NONE:
    break;
  case pcl::OpenReason::OUTER_BORDER:
    return colorOf(pcl::repair::BoundaryClass::OUTER_BORDER);
  case pcl::OpenReason::TUBE_MOUTH:
    return {0, 115, 115};
  case pcl::OpenReason::DIFFERENT_OBJECTS:
    return {90, 110, 140};
  case pcl::OpenReason::DEPTH_JUMP:
    return {75, 190, 150};
  case pcl::OpenReason::SEEN_EMPTY:
  case pcl::OpenReason::FIN:
    return {60, 150, 190};
  case pcl::OpenReason::NOT_JOINED:
    return {160, 85, 20};
  case pcl::OpenReason::UNDECIDED:
    return colorOf(pcl::repair::BoundaryClass::UNDECIDED);
  case pcl::OpenReason::ONE_SIDED:
    return {215, 120, 230};
  case pcl::OpenReason::TOO_LARGE:
    return {130, 0, 20};
  case pcl::OpenReason::NO_FILLING:
    return {215, 25, 30};
  case pcl::OpenReason::NOT_MANIFOLD:
    return {255, 100, 90};
  case pcl::OpenReason::INTERSECTION:
    return {235, 0, 130};
  case pcl::OpenReason::TOO_COSTLY:
    return {250, 150, 0};
  case pcl::OpenReason::PIERCED:
    return {150, 0, 95};
  case pcl::OpenReason::NOT_WANTED:
    return {110, 110, 110};
  }
  return colorOf(pcl::TriangleOrigin::MINIMUM_WEIGHT);
}

Rgb
colorOfBridge(double strength)
{
  return mix({155, 215, 90}, {0, 105, 45}, std::clamp(strength, 0.0, 1.0));
}

Rgb
colorOfTension(double share)
{
  constexpr std::array<Rgb, 5> stops{
      {{255, 255, 255}, {255, 225, 120}, {250, 140, 50}, {200, 30, 40}, {70, 0, 40}}};
  const double place = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mix(stops[below], stops[below + 1], place - static_cast<double>(below));
}

} // namespace app
