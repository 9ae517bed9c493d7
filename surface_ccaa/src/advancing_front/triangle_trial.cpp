// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a triangle must pass before it joins a surface.
#include "advancing_front/triangle_trial.h"

#include "advancing_front/empty_ball.h"
#include "advancing_front/tuning.h"

#include <algorithm>
#include <utility>

namespace pcl::ccaa {
namespace {

/** An equilateral triangle's side in circumradii. */
constexpr double SIDE_OF_UNIT_RADIUS = 1.7320508075688772;

} // namespace

TriangleTrial::TriangleTrial(const OpenSurface& open,
                             const GrowingSurface& surface,
                             double support,
                             const NearbyTriangles* nearby)
: open_(open)
, surface_(surface)
, support_(support)
, nearby_(nearby)
, around_(open.positions.size())
, asked_(open.positions.size(), 0)
{}

/** Whether an edge is as short as the side of an equilateral triangle with a
 * circumradius may be, or the surface has it already. */
bool
TriangleTrial::isShort(pcl::index_t a, pcl::index_t b, double radius) const
{
  const Front& front = surface_.front();
  return (surface_.position(a) - surface_.position(b)).norm() / SIDE_OF_UNIT_RADIUS <=
             radius ||
         front.find(a, b) != FrontEdge::NONE || front.find(b, a) != FrontEdge::NONE;
}

double
TriangleTrial::circumradius(const Triangle& t) const
{
  return EmptyBall(
             surface_.position(t[0]), surface_.position(t[1]), surface_.position(t[2]))
      .circumradius();
}

bool
TriangleTrial::isSupported(const FrontEdge& edge,
                           pcl::index_t apex,
                           double radius) const
{
  return isSupported({edge.to, edge.from, apex},
                     std::max(spacing(edge.from), spacing(edge.to)),
                     radius);
}

bool
TriangleTrial::isSupported(const Triangle& t) const
{
  return isSupported(
      t, std::max({spacing(t[0]), spacing(t[1]), spacing(t[2])}), circumradius(t));
}

bool
TriangleTrial::isSupportedByAll(const Triangle& t) const
{
  return isSupported(
      t, std::min({spacing(t[0]), spacing(t[1]), spacing(t[2])}), circumradius(t));
}

/** Small enough must be the circumradius, or what it would be in an equilateral
 * triangle whose side is the longest new edge. \param[in] spacing_there that the
 * corners would like; the most densely sampled of them has the last word */
bool
TriangleTrial::isSupported(const Triangle& t, double spacing_there, double radius) const
{
  const double least = std::min({spacing(t[0]), spacing(t[1]), spacing(t[2])});
  const double limit =
      support_ * std::min(spacing_there, tuning::MOST_SPACING_RATIO * least);
  return radius <= limit || (isShort(t[0], t[1], limit) && isShort(t[1], t[2], limit) &&
                             isShort(t[2], t[0], limit));
}

bool
TriangleTrial::meets(const Corners& corners, const Box& box, pcl::index_t triangle)
{
  const auto t = static_cast<std::size_t>(triangle);
  if (seen_[t] == call_)
    return false;
  seen_[t] = call_;
  return boxes_[t].intersects(box) &&
         trianglesMeet(corners, cornersOf(surface_.triangles()[t]));
}

bool
TriangleTrial::meetsAt(const Corners& corners, const Box& box, pcl::index_t vertex)
{
  if (std::exchange(asked_[static_cast<std::size_t>(vertex)], call_) == call_ ||
      !around_[static_cast<std::size_t>(vertex)].intersects(box))
    return false;
  bool found = false;
  surface_.forTrianglesAt(
      vertex, [&](pcl::index_t t) { found = found || meets(corners, box, t); });
  return found;
}

/** Keep up with the growing surface. */
void
TriangleTrial::noteBoxes()
{
  const Triangles& triangles = surface_.triangles();
  for (std::size_t t = boxes_.size(); t < triangles.size(); ++t) {
    boxes_.push_back(boxOf(cornersOf(triangles[t])));
    for (const pcl::index_t corner : triangles[t])
      around_[static_cast<std::size_t>(corner)].extend(boxes_[t]);
  }
  seen_.resize(triangles.size(), 0);
  ++call_;
}

bool
TriangleTrial::crossesSurface(const Triangle& triangle)
{
  const Corners corners = cornersOf(triangle);
  if (isCollinear(corners))
    return true;
  noteBoxes();
  const Box box = boxOf(corners);
  for (const pcl::index_t corner : triangle) {
    if (meetsAt(corners, box, corner))
      return true;
    for (unsigned int j = 0; j < open_.neighbors.k; ++j) {
      const pcl::index_t near = open_.neighbors.row(corner)[j];
      if (near != NeighborRows::NONE && meetsAt(corners, box, near))
        return true;
    }
  }
  return nearby_ != nullptr && nearby_->meets(corners, open_.removed);
}

} // namespace pcl::ccaa
