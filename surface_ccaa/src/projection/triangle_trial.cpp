// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a triangle must pass before it joins a surface.
#include <pcl/surface_ccaa/projection/empty_ball.h>
#include <pcl/surface_ccaa/projection/triangle_trial.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace ccaa {
namespace {

/** Neighbors whose distance tells the spacing of a free point. */
constexpr unsigned int SPACING_NEIGHBORS = 6;
/** An equilateral triangle's side in circumradii. */
constexpr double SIDE_OF_UNIT_RADIUS = 1.7320508075688772;
/** Share of the longest edge in closed parts close by that counts as spacing. */
constexpr double CLOSED_EDGE_SHARE = 0.5;
/** Ratio of spacings between neighboring samples beyond which they do not belong
 * together: outliers would tie themselves to the surface. */
constexpr double LARGEST_SPACING_RATIO = 2.0;

Box
boxOf(const Corners& corners)
{
  return {corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
          corners[0].cwiseMax(corners[1]).cwiseMax(corners[2])};
}

} // namespace

TriangleTrial::TriangleTrial(const OpenSurface& open,
                             const GrowingSurface& surface,
                             double support,
                             const NearbyTriangles* nearby)
: open_(open)
, surface_(surface)
, support_(support)
, nearby_(nearby)
, spacings_(open.spacings)
{
  spacings_.resize(open.open_points, 0.0);
  spacingsFromNeighbors();
  const std::vector<double> closed = longestClosedEdges();
  for (std::size_t i = 0; i < spacings_.size(); ++i)
    spacings_[i] = std::max(spacings_[i], CLOSED_EDGE_SHARE * closed[i]);
}

/** Of every open point, the longest edge between closed points that lies across a
 * triangle from it or from an open point next to it. */
std::vector<double>
TriangleTrial::longestClosedEdges() const
{
  const auto is_open = [&](pcl::index_t v) {
    return static_cast<std::size_t>(v) < open_.open_points;
  };
  std::vector<double> across(open_.open_points, 0.0);
  for (const Triangle& t : open_.rim)
    for (std::size_t i = 0; i < 3; ++i) {
      const pcl::index_t a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      if (!is_open(t[i]) || is_open(a) || is_open(b))
        continue;
      double& longest = across[static_cast<std::size_t>(t[i])];
      longest = std::max(longest, (surface_.position(a) - surface_.position(b)).norm());
    }
  std::vector<double> around = across;
  for (const Triangle& t : open_.rim)
    for (const pcl::index_t a : t)
      for (const pcl::index_t b : t)
        if (is_open(a) && is_open(b))
          around[static_cast<std::size_t>(a)] = std::max(
              around[static_cast<std::size_t>(a)], across[static_cast<std::size_t>(b)]);
  return around;
}

void
TriangleTrial::spacingsFromNeighbors()
{
  for (std::size_t i = 0; i < open_.open_points; ++i) {
    if (spacings_[i] > 0.0)
      continue;
    const auto vertex = static_cast<pcl::index_t>(i);
    const unsigned int count =
        std::min(SPACING_NEIGHBORS, open_.neighbors.count(vertex));
    double sum = 0.0;
    for (unsigned int j = 0; j < count; ++j) {
      const pcl::index_t near = open_.neighbors.row(vertex)[j];
      sum += (surface_.position(vertex) - surface_.position(near)).squaredNorm();
    }
    spacings_[i] = count > 0 ? std::sqrt(sum / count) : 0.0;
  }
}

/** Length of an edge that the surface does not have yet, else 0. */
double
TriangleTrial::newLength(pcl::index_t a, pcl::index_t b) const
{
  const Front& front = surface_.front();
  if (front.find(a, b) != FrontEdge::NONE || front.find(b, a) != FrontEdge::NONE)
    return 0.0;
  return (surface_.position(a) - surface_.position(b)).norm();
}

/** Circumradius, or what it would be in an equilateral triangle whose side is the
 * longest new edge; the smaller of both. The second is not worked out when the first is
 * small enough. */
double
TriangleTrial::reach(pcl::index_t a,
                     pcl::index_t b,
                     pcl::index_t c,
                     double enough) const
{
  const double radius =
      EmptyBall(surface_.position(a), surface_.position(b), surface_.position(c))
          .circumradius();
  if (radius <= enough)
    return radius;
  const double longest = std::max({newLength(a, b), newLength(b, c), newLength(c, a)});
  return std::min(radius, longest / SIDE_OF_UNIT_RADIUS);
}

bool
TriangleTrial::isSupported(const FrontEdge& edge, pcl::index_t apex) const
{
  const double limit =
      support_ * std::min(std::max(spacing(edge.from), spacing(edge.to)),
                          LARGEST_SPACING_RATIO * spacing(apex));
  return reach(edge.from, edge.to, apex, limit) <= limit;
}

bool
TriangleTrial::isSupported(const Triangle& t) const
{
  const double limit =
      support_ * std::max({spacing(t[0]), spacing(t[1]), spacing(t[2])});
  return reach(t[0], t[1], t[2], limit) <= limit;
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
  for (std::size_t t = boxes_.size(); t < triangles.size(); ++t)
    boxes_.push_back(boxOf(cornersOf(triangles[t])));
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
  return nearby_ != nullptr && nearby_->meets(corners, box);
}

} // namespace ccaa
} // namespace pcl
