// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what tiles that see the same place make of it alike.
#include "tiles/agreement.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "mesh/disjoint_sets.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <memory>

namespace pcl::ccaa {
namespace {

/** Whether a tile sees all corners. */
bool
sees(const Tile& tile, const std::array<BorderPoint, 3>& corners)
{
  return std::all_of(corners.begin(), corners.end(), [&](const BorderPoint& corner) {
    return tile.sees(corner.position, corner.halo);
  });
}

std::vector<WideTriangle>
sortedCorners(const std::vector<WideTriangle>& triangles)
{
  std::vector<WideTriangle> sorted;
  for (const WideTriangle& triangle : triangles)
    sorted.push_back(cornersInOrder(triangle));
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/** One tile's side of the bargain. */
class Bargain {
public:
  Bargain(const Tiling& tiling,
          std::size_t tile,
          const BorderMesh& own,
          const std::vector<std::vector<WideTriangle>>& others)
  : tiling_(tiling), tile_(tile), own_(own)
  {
    for (const auto& other : others)
      others_.push_back(sortedCorners(other));
    const TilesAround sight = TilesAround::sight(tiling, tile);
    for (const BorderPoint& point : own.points) {
      sight.forEachNear(
          point.position, point.halo, [&](std::size_t i) { seers_.push_back(i); });
      seers_end_.push_back(seers_.size());
    }
  }

  Agreed
  run()
  {
    for (const WideTriangle& triangle : own_.triangles)
      if (tiling_.tiles[tile_].owns(cornersInOrder(triangle).front()))
        judge(triangle);
    const std::vector<WideTriangle> own = sortedCorners(own_.triangles);
    for (const auto& other : others_)
      for (const WideTriangle& triangle : other)
        if (!std::binary_search(own.begin(), own.end(), triangle))
          agreed_.refused.push_back(triangle);
    sortUnique(agreed_.refused);
    return std::move(agreed_);
  }

private:
  void
  judge(const WideTriangle& triangle)
  {
    if (isAgreed(cornersInOrder(triangle)))
      agreed_.triangles.push_back(triangle);
    else
      agreed_.refused.push_back(cornersInOrder(triangle));
  }

  bool
  isAgreed(const WideTriangle& triangle) const
  {
    std::array<BorderPoint, 3> corners;
    std::vector<std::size_t> seers; // once for each corner that they see
    for (std::size_t i = 0; i < 3; ++i) {
      const auto place = findPoint(own_.points, triangle[i]);
      corners[i] = *place;
      const auto p = static_cast<std::size_t>(place - own_.points.begin());
      const auto all = seers_.begin();
      seers.insert(seers.end(),
                   all + static_cast<std::ptrdiff_t>(p == 0 ? 0 : seers_end_[p - 1]),
                   all + static_cast<std::ptrdiff_t>(seers_end_[p]));
    }
    std::sort(seers.begin(), seers.end());
    for (std::size_t i = 2; i < seers.size(); ++i)
      if (const auto& other = others_[seers[i]];
          seers[i - 2] == seers[i] &&
          !std::binary_search(other.begin(), other.end(), triangle))
        return false;
    if (seers.empty())
      return true;
    const double longest =
        longestEdge({corners[0].position, corners[1].position, corners[2].position});
    return std::all_of(corners.begin(), corners.end(), [&](const BorderPoint& corner) {
      const Tile& owner = tiling_.tiles[tiling_.ownerOf(corner.index)];
      return sees(owner, corners) &&
             longest <= Tile::LONGEST * std::max(owner.halo, corner.halo);
    });
  }

  const Tiling& tiling_;
  std::size_t tile_;
  const BorderMesh& own_;
  std::vector<std::vector<WideTriangle>> others_; /**< in order, by neighbor */
  std::vector<std::size_t> seers_;     /**< neighbors that see a border point */
  std::vector<std::size_t> seers_end_; /**< of each point, among these */
  Agreed agreed_;
};

} // namespace

Agreed
agree(const Tiling& tiling,
      std::size_t tile,
      const BorderMesh& own,
      const std::vector<std::vector<WideTriangle>>& others)
{
  return Bargain(tiling, tile, own, others).run();
}

std::vector<std::size_t>
groupDisputes(const std::vector<Dispute>& disputes)
{
  if (disputes.empty())
    return {};
  auto places = std::make_shared<PointCloud<PointXYZ>>();
  for (const Dispute& dispute : disputes)
    places->emplace_back(
        dispute.position.x(), dispute.position.y(), dispute.position.z());
  KdTreeFLANN<PointXYZ> tree;
  tree.setInputCloud(places);
  DisjointSets sets(disputes.size());
  Indices near;
  std::vector<float> sqr_distances;
  for (std::size_t i = 0; i < disputes.size(); ++i) {
    tree.radiusSearch((*places)[i], 2.0F * disputes[i].room, near, sqr_distances);
    for (const pcl::index_t other : near)
      sets.join(i, static_cast<std::size_t>(other));
  }
  std::vector<std::size_t> groups(disputes.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < disputes.size(); ++i) {
    const std::size_t root = sets.find(i); // the lowest of its group
    groups[i] = root == i ? count++ : groups[root];
  }
  return groups;
}

} // namespace pcl::ccaa
