// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a surface to which triangles are added one by one.
#include "advancing_front/growing_surface.h"

#include <Eigen/Geometry>

#include "mesh/corners.h"

namespace pcl::ccaa {
namespace {

bool
hasCorner(const Triangle& triangle, pcl::index_t vertex)
{
  return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

} // namespace

GrowingSurface::GrowingSurface(const OpenSurface& open)
: positions_(open.positions)
, head_(open.positions.size(), NO_TRIANGLE)
, normal_sums_(open.positions.size(), Position::Zero())
, front_(open.positions.size())
{
  for (const Triangle& triangle : open.rim)
    record(triangle);
  const auto open_points = static_cast<pcl::index_t>(open.open_points);
  std::vector<FrontEdge> boundary;
  for (const Triangle& triangle : open.rim)
    for (std::size_t i = 0; i < 3; ++i) {
      FrontEdge edge;
      edge.from = triangle[i];
      edge.to = triangle[(i + 1) % 3];
      edge.apex = triangle[(i + 2) % 3];
      if (edge.from >= open_points && edge.to >= open_points)
        continue;
      std::size_t sharing = 0;
      forTrianglesAt(edge.from, [&](pcl::index_t t) {
        sharing += hasCorner(triangles_[static_cast<std::size_t>(t)], edge.to);
      });
      if (sharing == 1)
        boundary.push_back(edge);
    }
  front_.addBoundary(boundary, [this](pcl::index_t from, pcl::index_t to) {
    return endOfFan(from, to);
  });
}

/** The fan at the end of a boundary edge, walked to its other side: an edge that comes
 * in, the corner that the fan's last edge goes out to. */
pcl::index_t
GrowingSurface::endOfFan(pcl::index_t from, pcl::index_t at) const
{
  pcl::index_t rim = from;
  for (bool turned = true; turned;) {
    turned = false;
    forTrianglesAt(at, [&](pcl::index_t t) {
      const Triangle& triangle = triangles_[static_cast<std::size_t>(t)];
      for (std::size_t i = 0; i < 3 && !turned; ++i)
        if (triangle[i] == rim && triangle[(i + 1) % 3] == at) {
          rim = triangle[(i + 2) % 3];
          turned = true;
        }
    });
  }
  return rim;
}

void
GrowingSurface::advance(FrontIndex edge, pcl::index_t apex)
{
  record({front_[edge].to, front_[edge].from, apex});
  front_.advance(edge, apex);
}

void
GrowingSurface::addTriangle(const Triangle& triangle)
{
  record(triangle);
  front_.addTriangle(triangle);
}

bool
GrowingSurface::hasEdge(pcl::index_t one, pcl::index_t other) const
{
  bool found = false;
  forTrianglesAt(one, [&](pcl::index_t t) {
    found = found || hasCorner(triangles_[static_cast<std::size_t>(t)], other);
  });
  return found;
}

void
GrowingSurface::record(const Triangle& triangle)
{
  const auto t = static_cast<std::int32_t>(triangles_.size());
  triangles_.push_back(triangle);
  const Position unit = unitNormal(cornersOf(triangle, positions_));
  for (std::int32_t i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    const auto vertex = static_cast<std::size_t>(triangle[c]);
    following_.push_back(head_[vertex]);
    head_[vertex] = 3 * t + i;
    const Position u = position(triangle[(c + 1) % 3]) - position(triangle[c]);
    const Position v = position(triangle[(c + 2) % 3]) - position(triangle[c]);
    normal_sums_[vertex] += angleBetween(u, v) * unit;
  }
}

} // namespace pcl::ccaa
