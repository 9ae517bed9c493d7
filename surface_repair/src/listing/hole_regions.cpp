// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which holes meet, and so have vertices in common and are
// closed together.

#include "listing/hole_regions.h"

#include "boundary/extraction.h"
#include "mesh/disjoint_sets.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace pcl::repair {

namespace {

/** Without the points that are there once more right after themselves. */
void
dropRepeated(HolePolygon& polygon)
{
  HolePolygon left;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    if (k == polygon.second_loop)
      left.second_loop = left.vertices.size();
    if (polygon.vertices[k] != polygon.vertices[polygon.curve.next(k)]) {
      left.vertices.push_back(polygon.vertices[k]);
      left.curve.points.push_back(polygon.curve.points[k]);
      left.curve.normals.push_back(polygon.curve.normals[k]);
    }
  }
  polygon = std::move(left);
}

/** The ends of bridges without a length, where these are part of holes to be closed. */
void
addTouching(const ModelSurvey& survey, HoleList& list)
{
  std::set<std::size_t> passed;
  for (const OpenHole& hole : list.holes)
    if (hole.open == OpenReason::NONE)
      passed.insert(hole.bridges.begin(), hole.bridges.end());
  VertexMap& replaced = list.replaced;
  const auto vertexAt = [&](const BoundaryPoint& end) {
    return survey.loops[survey.joined.loops[end.curve]].vertices[end.edge];
  };
  const auto lowest = [&](pcl::index_t vertex) {
    const auto found = replaced.find(vertex);
    return found == replaced.end() ? vertex : found->second;
  };
  for (const std::size_t number : passed) {
    const Bridge& bridge = survey.joined.bridges[number];
    if (bridge.points.size() > 2 || bridge.points.front() != bridge.points.back())
      continue;
    const auto [kept, other] =
        std::minmax({lowest(vertexAt(bridge.begin)), lowest(vertexAt(bridge.end))});
    if (kept == other)
      continue;
    for (auto& [vertex, target] : replaced)
      target = target == other ? kept : target;
    replaced.emplace(other, kept);
  }
}

/** Welding closes what has fewer edges than a triangle. */
bool
isToBeFilled(const OpenHole& hole)
{
  return hole.open == OpenReason::NONE && hole.polygon.size() >= 3;
}

/** Two fillings could have the edge between two points that both holes have. */
void
joinHolesThatMeetTwice(const std::map<pcl::index_t, std::vector<std::size_t>>& holes_at,
                       ccaa::DisjointSets& groups)
{
  std::set<std::pair<std::size_t, std::size_t>> met;
  for (const auto& [vertex, holes] : holes_at)
    for (const std::size_t first : holes)
      for (const std::size_t second : holes)
        if (first < second && !met.emplace(first, second).second)
          groups.join(first, second);
}

} // namespace

void
weldHoles(const ModelSurvey& survey, HoleList& list)
{
  list.replaced = pinchedVertices(survey.model, survey.loops);
  addTouching(survey, list);
  if (list.replaced.empty())
    return;
  for (OpenHole& hole : list.holes) {
    for (pcl::index_t& vertex : hole.polygon.vertices) {
      const auto found = list.replaced.find(vertex);
      if (found != list.replaced.end())
        vertex = found->second;
    }
    dropRepeated(hole.polygon);
  }
}

void
groupHoles(HoleList& list)
{
  ccaa::DisjointSets groups(list.holes.size());
  std::map<std::size_t, std::size_t> hole_at; // bridge -> first hole that passes it
  std::map<pcl::index_t, std::vector<std::size_t>> holes_at; // a pinched vertex
  for (const auto& [vertex, kept] : list.replaced)
    holes_at[kept];
  for (std::size_t h = 0; h < list.holes.size(); ++h) {
    if (!isToBeFilled(list.holes[h]))
      continue;
    for (const std::size_t bridge : list.holes[h].bridges)
      groups.join(h, hole_at.emplace(bridge, h).first->second);
    for (const pcl::index_t vertex : list.holes[h].polygon.vertices) {
      const auto met = holes_at.find(vertex);
      if (met != holes_at.end())
        met->second.push_back(h);
    }
  }
  joinHolesThatMeetTwice(holes_at, groups);
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t h = 0; h < list.holes.size(); ++h)
    if (isToBeFilled(list.holes[h]))
      members[groups.find(h)].push_back(h);
  for (auto& [first, holes] : members)
    list.regions.push_back(std::move(holes));
}

} // namespace pcl::repair
