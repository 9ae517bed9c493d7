// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a patch together with the model's triangles around it.

#include "fairing/joined_surface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

namespace pcl::repair {

namespace {

/** Takes in triangles of the model ring by ring. */
class RingGathering {
public:
  RingGathering(const IncompleteModel& model,
                const Patch& patch,
                JoinedSurface& surface)
  : model_(model), surface_(surface)
  {
    for (std::size_t v = 0; v < patch.rim.size(); ++v) {
      number_.emplace(patch.rim[v], static_cast<pcl::index_t>(v));
      front_.push_back(patch.rim[v]);
    }
  }

  void
  addRing(std::size_t ring)
  {
    std::vector<pcl::index_t> next;
    for (const pcl::index_t vertex : front_)
      for (const auto* t = model_.adjacency.begin(vertex);
           t != model_.adjacency.end(vertex);
           ++t)
        if (taken_.insert(*t).second)
          addTriangle(*t, ring, next);
    front_.swap(next);
  }

private:
  void
  addTriangle(pcl::index_t triangle, std::size_t ring, std::vector<pcl::index_t>& next)
  {
    Triangle corners = model_.triangles[static_cast<std::size_t>(triangle)];
    for (pcl::index_t& corner : corners) {
      const auto [place, is_new] =
          number_.emplace(corner, static_cast<pcl::index_t>(surface_.positions.size()));
      if (is_new) {
        surface_.positions.push_back(
            model_.positions[static_cast<std::size_t>(corner)]);
        next.push_back(corner);
      }
      corner = place->second;
    }
    surface_.triangles.push_back(corners);
    surface_.rings.push_back(ring);
  }

  const IncompleteModel& model_;
  JoinedSurface& surface_;
  std::unordered_map<pcl::index_t, pcl::index_t> number_; /**< for look-up only */
  std::unordered_set<pcl::index_t> taken_;                /**< for look-up only */
  std::vector<pcl::index_t> front_;
};

void
normalise(JoinedSurface& surface)
{
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < surface.patch_vertices; ++v)
    box.extend(surface.positions[v]);
  surface.centre = box.center();
  surface.size = box.diagonal().norm();
  for (Position& position : surface.positions)
    position = (position - surface.centre) / surface.size;
}

/** Every edge at the vertex has two triangles. */
std::vector<char>
wholeVertices(const JoinedSurface& surface)
{
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * surface.triangles.size());
  for (const Triangle& triangle : surface.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const auto a = static_cast<std::uint64_t>(triangle[c]);
      const auto b = static_cast<std::uint64_t>(triangle[(c + 1) % 3]);
      edges.push_back(std::min(a, b) << 32 | std::max(a, b));
    }
  std::sort(edges.begin(), edges.end());
  std::vector<char> whole(surface.positions.size(), 1);
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    while (next < edges.size() && edges[next] == edges[i])
      ++next;
    if (next - i == 2)
      continue;
    whole[edges[i] >> 32] = 0;
    whole[edges[i] & 0xffffffffu] = 0;
  }
  return whole;
}

} // namespace

JoinedSurface
joinSurface(const IncompleteModel& model, const Patch& patch, std::size_t rings)
{
  JoinedSurface surface;
  surface.positions = patch.positions;
  surface.triangles = patch.triangles;
  surface.patch_vertices = patch.positions.size();
  surface.patch_triangles = patch.triangles.size();
  RingGathering gathering(model, patch, surface);
  for (std::size_t ring = 1; ring <= rings; ++ring)
    gathering.addRing(ring);
  normalise(surface);
  surface.whole = wholeVertices(surface);
  return surface;
}

} // namespace pcl::repair
