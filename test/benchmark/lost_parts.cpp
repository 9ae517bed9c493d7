// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: closed surfaces that lose a share of their triangles.
#include "lost_parts.h"

#include "damage/random_numbers.h"
#include "measuring.h"
#include "support/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace bench {
namespace {

using pcl::ccaa::Position;
using pcl::ccaa::Triangle;
using pcl::ccaa::Triangles;
using namespace pcl::ccaa::test;

/** Halvings of the range of sizes. */
constexpr int HALVINGS = 40;
/** Spread of the lengths of edges by which patches grow, as a power of e. */
constexpr double TORN = 0.7;
constexpr std::size_t PATCH_COUNT = 4;
/** Of the lost vertices that are free points. */
constexpr double FREE_SHARE = 0.05;

using Edges = std::vector<std::pair<std::size_t, std::size_t>>; // the lower end first

Edges
edgesOf(const Triangles& triangles)
{
  Edges edges;
  for (const Triangle& triangle : triangles)
    for (std::size_t c = 0; c < 3; ++c)
      edges.push_back(std::minmax(static_cast<std::size_t>(triangle[c]),
                                  static_cast<std::size_t>(triangle[(c + 1) % 3])));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/** How far each vertex is from the middle of what is lost. */
class Distances {
public:
  Distances(const Shape& whole, std::uint64_t seed) : whole_(whole), random_(seed) {}

  std::vector<double>
  of(LossKind kind, double share)
  {
    switch (kind) {
    case LossKind::PATCHES:
      return toPatches();
    case LossKind::BALLS:
      return toBalls(share < 0.1 ? 5 : share < 0.3 ? 6 : 8);
    case LossKind::SLABS3:
      return toPlanes(3);
    case LossKind::SLABS6:
      break;
    }
    return toPlanes(6);
  }

private:
  const Position&
  anyVertex()
  {
    return whole_.vertices[random_.below(whole_.vertices.size())];
  }

  /** The least of some distances of each vertex. */
  template <typename Distance>
  void
  lower(const Distance& distance, std::vector<double>& least) const
  {
    least.resize(whole_.vertices.size(), std::numeric_limits<double>::infinity());
    for (std::size_t v = 0; v < least.size(); ++v)
      least[v] = std::min(least[v], distance(whole_.vertices[v]));
  }

  std::vector<double>
  toBalls(int count)
  {
    std::vector<double> least;
    for (int i = 0; i < count; ++i) {
      const Position center = anyVertex();
      const double weight = 0.6 + random_.uniform();
      lower([&](const Position& p) { return weight * (p - center).norm(); }, least);
    }
    return least;
  }

  std::vector<double>
  toPlanes(int count)
  {
    std::vector<double> least;
    for (int i = 0; i < count; ++i) {
      const Position normal =
          Position(random_.normal(), random_.normal(), random_.normal()).normalized();
      std::vector<double> heights;
      for (const Position& p : whole_.vertices)
        heights.push_back(p.dot(normal));
      const double quantile = 0.1 + 0.8 * random_.uniform();
      const auto place =
          heights.begin() +
          static_cast<std::ptrdiff_t>(quantile * static_cast<double>(heights.size()));
      std::nth_element(heights.begin(), place, heights.end());
      const double height = *place;
      lower([&](const Position& p) { return std::abs(p.dot(normal) - height); }, least);
    }
    return least;
  }

  /** Shortest ways over edges of random lengths. */
  std::vector<double>
  toPatches()
  {
    std::vector<std::vector<std::pair<std::size_t, double>>> ways(
        whole_.vertices.size());
    for (const auto& [a, b] : edgesOf(whole_.triangles)) {
      const double length = (whole_.vertices[a] - whole_.vertices[b]).norm() *
                            std::exp(TORN * random_.normal());
      ways[a].emplace_back(b, length);
      ways[b].emplace_back(a, length);
    }
    using Entry = std::pair<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::vector<double> least(ways.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < PATCH_COUNT; ++i)
      queue.emplace(0.0, random_.below(ways.size()));
    while (!queue.empty()) {
      const auto [distance, vertex] = queue.top();
      queue.pop();
      if (distance >= least[vertex])
        continue;
      least[vertex] = distance;
      for (const auto& [other, length] : ways[vertex])
        queue.emplace(distance + length, other);
    }
    return least;
  }

  const Shape& whole_;
  app::RandomNumbers random_;
};

std::size_t
countLost(const Triangles& triangles, const std::vector<double>& distances, double size)
{
  return static_cast<std::size_t>(
      std::count_if(triangles.begin(), triangles.end(), [&](const Triangle& triangle) {
        return std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
          return distances[static_cast<std::size_t>(corner)] < size;
        });
      }));
}

} // namespace

const char*
nameOf(LossKind kind)
{
  switch (kind) {
  case LossKind::PATCHES:
    return "patches";
  case LossKind::BALLS:
    return "balls";
  case LossKind::SLABS3:
    return "three slabs";
  case LossKind::SLABS6:
    break;
  }
  return "six slabs";
}

LostPart
without(const Shape& whole, const std::vector<bool>& is_lost)
{
  LostPart part;
  part.left.vertices = part.lost.vertices = whole.vertices;
  std::vector<bool> is_used(whole.vertices.size(), false);
  for (const Triangle& triangle : whole.triangles) {
    const bool goes =
        std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
          return is_lost[static_cast<std::size_t>(corner)];
        });
    (goes ? part.lost : part.left).triangles.push_back(triangle);
    for (const pcl::index_t corner : triangle)
      if (!goes)
        is_used[static_cast<std::size_t>(corner)] = true;
  }
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (!is_used[v])
      part.lost_vertices.push_back(whole.vertices[v]);
  part.left = withoutFreeVertices(part.left);
  std::vector<double> lengths;
  for (const auto& [a, b] : edgesOf(whole.triangles))
    lengths.push_back((whole.vertices[a] - whole.vertices[b]).norm());
  part.edge = median(std::move(lengths));
  return part;
}

LostPart
lose(const Shape& whole, LossKind kind, double share, std::uint64_t seed)
{
  const std::vector<double> distances =
      Distances(whole,
                100 * seed + 10 * static_cast<std::uint64_t>(kind) +
                    static_cast<std::uint64_t>(20 * share))
          .of(kind, share);
  double low = 0.0;
  double high = 0.0;
  for (const double distance : distances)
    high = std::isfinite(distance) ? std::max(high, distance) : high;
  for (int i = 0; i < HALVINGS; ++i) {
    const double size = 0.5 * (low + high);
    const auto lost = static_cast<double>(countLost(whole.triangles, distances, size));
    (lost > share * static_cast<double>(whole.triangles.size()) ? high : low) = size;
  }
  std::vector<bool> is_lost;
  for (const double distance : distances)
    is_lost.push_back(distance < low);
  return without(whole, is_lost);
}

bool
hasLostHandle(const LostPart& part)
{
  std::map<std::size_t, Triangles> pieces;
  const std::vector<std::size_t> piece_of = componentOfTriangles(part.lost.triangles);
  for (std::size_t t = 0; t < piece_of.size(); ++t)
    pieces[piece_of[t]].push_back(part.lost.triangles[t]);
  return std::any_of(pieces.begin(), pieces.end(), [](const auto& piece) {
    const Topology found = topologyOf(piece.second);
    return 2 - found.characteristic - static_cast<long>(found.borders) >= 2;
  });
}

pcl::ccaa::Positions
freePoints(const LostPart& part, double noise, std::uint64_t seed)
{
  app::RandomNumbers random(seed);
  pcl::ccaa::Positions points;
  for (const auto& position : part.lost_vertices)
    if (random.uniform() < FREE_SHARE)
      points.push_back(position + noise * Position(random.normal(),
                                                   random.normal(),
                                                   random.normal()));
  return points;
}

} // namespace bench
