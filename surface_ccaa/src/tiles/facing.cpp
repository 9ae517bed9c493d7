// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which sides of pieces look the same way across a gap.
#include "tiles/facing.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "mesh/corners.h"
#include "mesh/label_votes.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::ccaa {
namespace {

/** Nearest triangles among which that across a gap is looked for. */
constexpr unsigned int ACROSS = 24;

/** Triangles with an open corner. */
std::vector<std::size_t>
rimOf(const Seam& seam, const Triangles& given)
{
  std::vector<std::size_t> rim;
  for (std::size_t t = 0; t < given.size(); ++t)
    if (anyCorner(given[t], seam.is_open))
      rim.push_back(t);
  return rim;
}

/** Sums of cosines between triangles of two pieces that lie before each other. */
std::vector<LabelVote>
facingVotes(const Seam& seam, const Winding& pieces, const Triangles& given)
{
  const std::vector<std::size_t> rim = rimOf(seam, given);
  if (rim.empty())
    return {};
  auto places = std::make_shared<PointCloud<PointXYZ>>();
  std::vector<Eigen::Vector3d> normals;
  for (const std::size_t t : rim) {
    const Corners c = cornersOf(given[t], PointView(seam.points));
    const Eigen::Vector3f place = ((c[0] + c[1] + c[2]) / 3.0).cast<float>();
    places->emplace_back(place.x(), place.y(), place.z());
    normals.push_back(unitNormal(c));
  }
  KdTreeFLANN<PointXYZ> tree;
  tree.setInputCloud(places);
  const auto pieceOf = [&](std::size_t t) {
    return static_cast<pcl::index_t>(pieces.componentOf(t));
  };
  std::vector<LabelVote> votes;
  Indices near;
  std::vector<float> sqr_distances;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const auto count = std::min(ACROSS, static_cast<unsigned int>(rim.size()));
    tree.nearestKSearch((*places)[i], count, near, sqr_distances);
    const pcl::index_t own = pieceOf(rim[i]);
    for (const pcl::index_t k : near) {
      const auto faced = static_cast<std::size_t>(k);
      const pcl::index_t its = pieceOf(rim[faced]);
      if (its == own)
        continue;
      votes.push_back({{own, its}, normals[i].dot(normals[faced])});
      break;
    }
  }
  return votes;
}

/** \param[in] labels of the pieces, and others \return whether any was turned */
bool
turnByVotes(std::vector<LabelVote> votes,
            std::size_t labels,
            const Winding& pieces,
            Triangles& given)
{
  LabelSets sides;
  for (std::size_t i = 0; i < labels; ++i)
    sides.add();
  joinClearest(std::move(votes), sides);
  bool has_turned = false;
  for (std::size_t t = 0; t < given.size(); ++t)
    if ((sides.find(2 * static_cast<pcl::index_t>(pieces.componentOf(t))) & 1) != 0) {
      std::swap(given[t][1], given[t][2]);
      has_turned = true;
    }
  return has_turned;
}

} // namespace

void
turnAsMade(const Seam& seam, const Winding& pieces, Triangles& given)
{
  std::vector<std::size_t> tiles = seam.tile_of;
  sortUnique(tiles);
  const std::size_t count = pieces.components().size();
  std::vector<LabelVote> votes;
  for (std::size_t t = 0; t < seam.tile_of.size(); ++t) {
    const auto tile = std::lower_bound(tiles.begin(), tiles.end(), seam.tile_of[t]);
    votes.push_back(
        {{static_cast<pcl::index_t>(pieces.componentOf(t)),
          static_cast<pcl::index_t>(count + std::size_t(tile - tiles.begin()))},
         pieces.sign(t)});
  }
  turnByVotes(std::move(votes), count + tiles.size(), pieces, given);
}

bool
turnToFace(const Seam& seam, const Winding& pieces, Triangles& given)
{
  if (pieces.components().size() < 2)
    return false;
  return turnByVotes(
      facingVotes(seam, pieces, given), pieces.components().size(), pieces, given);
}

} // namespace pcl::ccaa
