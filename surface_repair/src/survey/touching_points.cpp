// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points in which islands touch.

#include "survey/touching_points.h"

#include <map>
#include <utility>

namespace pcl::repair {

namespace {

/** A place on one of the boundaries. */
struct Place {
  std::size_t curve = 0;
  std::size_t vertex = 0; /**< of the loop */
};

class Touching {
public:
  Touching(const ModelSurvey& survey, const BoundaryEdges& boundaries)
  : survey_(survey), boundaries_(boundaries)
  {}

  std::vector<Bridge>
  run() const
  {
    std::map<pcl::index_t, std::vector<Place>> places_at; // a point of the cloud
    for (std::size_t curve = 0; curve < survey_.joined.loops.size(); ++curve)
      for (std::size_t k = 0; k < loopOf(curve).vertices.size(); ++k)
        if (pointAt({curve, k}) != pcl::UNAVAILABLE)
          places_at[pointAt({curve, k})].push_back({curve, k});
    std::vector<Bridge> bridges;
    for (const auto& [point, places] : places_at)
      for (std::size_t i = 1; i < places.size(); ++i)
        if (mayMeet(places[i - 1], places[i]))
          bridges.push_back(between(places[i - 1], places[i]));
    return bridges;
  }

private:
  const BoundaryLoop&
  loopOf(std::size_t curve) const
  {
    return survey_.loops[survey_.joined.loops[curve]];
  }

  /** Of a place some vertices further. */
  pcl::index_t
  pointAt(const Place& place, std::size_t further = 0) const
  {
    const std::vector<pcl::index_t>& vertices = loopOf(place.curve).vertices;
    const pcl::index_t vertex = vertices[(place.vertex + further) % vertices.size()];
    return survey_.model.point_of_vertex[static_cast<std::size_t>(vertex)];
  }

  bool
  areAtSeam(const Place& one, const Place& other) const
  {
    const auto before = [&](const Place& place) {
      return pointAt(place, loopOf(place.curve).vertices.size() - 1);
    };
    return pointAt(one, 1) == before(other) || pointAt(other, 1) == before(one);
  }

  const Direction&
  normalAt(const Place& place) const
  {
    return survey_.model
        .normals[static_cast<std::size_t>(loopOf(place.curve).vertices[place.vertex])];
  }

  bool
  mayMeet(const Place& one, const Place& other) const
  {
    const BoundaryLoop& first = loopOf(one.curve);
    const BoundaryLoop& second = loopOf(other.curve);
    return first.island != second.island && !areAtSeam(one, other) &&
           normalAt(one).dot(normalAt(other)) > 0.0 &&
           (!survey_.wishes.keepApart() ||
            survey_.wishes.mayJoin(survey_.model, first, second));
  }

  BoundaryPoint
  pointOn(const Place& place) const
  {
    const BoundaryCurve& curve = boundaries_.curves()[place.curve].curve;
    return {place.curve, place.vertex, 0.0, curve.points[place.vertex]};
  }

  Bridge
  between(const Place& one, const Place& other) const
  {
    Bridge bridge;
    bridge.begin = pointOn(one);
    bridge.end = pointOn(other);
    bridge.points = {bridge.begin.position, bridge.end.position};
    bridge.normals = {normalAt(one), normalAt(other)};
    return bridge;
  }

  const ModelSurvey& survey_;
  const BoundaryEdges& boundaries_;
};

} // namespace

std::vector<Bridge>
touchingBridges(const ModelSurvey& survey, const BoundaryEdges& boundaries)
{
  return Touching(survey, boundaries).run();
}

} // namespace pcl::repair
