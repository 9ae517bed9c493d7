// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the ring between two loops, cut open into polygons.

#include "listing/ring_polygons.h"

#include <algorithm>

namespace pcl::repair {

namespace {

/** Bridges over which a ring is cut open, one try after the other. */
constexpr std::size_t CUTS = 3;

void
add(const BoundaryLoop& loop, std::size_t place, RingPolygon& ring)
{
  ring.vertices.push_back(loop.vertices[place]);
  ring.curve.points.push_back(loop.curve.points[place]);
  ring.curve.normals.push_back(loop.curve.normals[place]);
}

/** Go along a loop, from one place up to but without another one; the same place twice
 * is once around. */
void
follow(const BoundaryLoop& loop, std::size_t from, std::size_t to, RingPolygon& ring)
{
  std::size_t place = from;
  do {
    add(loop, place, ring);
    place = (place + 1) % loop.vertices.size();
  }
  while (place != to);
}

/** The ring cut open over a bridge. */
RingPolygon
cutAt(const LoopPlaces& bridge, const BoundaryLoop& outer, const BoundaryLoop& inner)
{
  RingPolygon ring;
  follow(outer, bridge.first, bridge.first, ring);
  add(outer, bridge.first, ring);
  const std::size_t first_inner = ring.vertices.size();
  ring.second_loop = first_inner;
  follow(inner, bridge.second, bridge.second, ring);
  add(inner, bridge.second, ring);
  const Direction across =
      (ring.curve.normals.front() + ring.curve.normals[first_inner]).normalized();
  ring.curve.normals[first_inner - 1] = ring.curve.normals.back() = across;
  return ring;
}

/** Ends of bridges between two loops, the shortest first, one each from a part of the
 * inner loop. */
std::vector<LoopPlaces>
bridgesBetween(const BoundaryLoop& outer, const BoundaryLoop& inner)
{
  std::vector<LoopPlaces> bridges;
  const std::size_t count = inner.vertices.size();
  const auto length = [&](const LoopPlaces& bridge) {
    return (outer.curve.points[bridge.first] - inner.curve.points[bridge.second])
        .norm();
  };
  for (std::size_t part = 0; part < CUTS; ++part) {
    LoopPlaces best{0, part * count / CUTS};
    for (std::size_t i = part * count / CUTS; i < (part + 1) * count / CUTS; ++i)
      for (std::size_t o = 0; o < outer.vertices.size(); ++o)
        if (length({o, i}) < length(best))
          best = {o, i};
    bridges.push_back(best);
  }
  std::stable_sort(
      bridges.begin(), bridges.end(), [&](const LoopPlaces& a, const LoopPlaces& b) {
        return length(a) < length(b);
      });
  return bridges;
}

/** The polygons between two loops that touch in points, by ascending places of the
 * outer one; none where they do not touch one after the other. */
std::vector<RingPolygon>
cutWhereTouching(const std::vector<LoopPlaces>& touching,
                 const BoundaryLoop& outer,
                 const BoundaryLoop& inner)
{
  std::vector<RingPolygon> rings;
  std::size_t inner_edges = 0;
  for (std::size_t i = 0; i < touching.size(); ++i) {
    const LoopPlaces& begin = touching[i];
    const LoopPlaces& end = touching[(i + 1) % touching.size()];
    RingPolygon ring;
    follow(outer, begin.first, end.first, ring);
    const std::size_t outer_edges = ring.vertices.size();
    follow(inner, end.second, begin.second, ring);
    inner_edges += ring.vertices.size() - outer_edges;
    rings.push_back(std::move(ring));
  }
  return inner_edges == inner.vertices.size() ? rings : std::vector<RingPolygon>();
}

} // namespace

std::vector<std::vector<RingPolygon>>
cutsOf(const BoundaryLoop& outer,
       const BoundaryLoop& inner,
       const std::vector<LoopPlaces>& touching)
{
  if (!touching.empty())
    return {cutWhereTouching(touching, outer, inner)};
  std::vector<std::vector<RingPolygon>> cuts;
  for (const LoopPlaces& bridge : bridgesBetween(outer, inner))
    cuts.push_back({cutAt(bridge, outer, inner)});
  return cuts;
}

} // namespace pcl::repair
