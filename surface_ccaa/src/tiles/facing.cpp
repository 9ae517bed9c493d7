// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which sides of pieces look the same way across a gap.
#include "tiles/facing.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "mesh/corners.h"
#include "mesh/label_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace pcl::ccaa {
namespace {

/** Nearest triangles among which that across a gap is looked for. */
constexpr unsigned int ACROSS = 24;

/** Numbers of two pieces, the lower first. */
using Pair = std::array<std::size_t, 2>;

/** Sums of cosines between triangles of two pieces that lie before each other. */
using FacingVotes = std::map<Pair, double>;

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

FacingVotes
vote(const Seam& seam, const Winding& pieces, const Triangles& given)
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
  FacingVotes votes;
  Indices near;
  std::vector<float> sqr_distances;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const auto count = std::min(ACROSS, static_cast<unsigned int>(rim.size()));
    tree.nearestKSearch((*places)[i], count, near, sqr_distances);
    const std::size_t own = pieces.componentOf(rim[i]);
    for (const pcl::index_t k : near) {
      const auto faced = static_cast<std::size_t>(k);
      const std::size_t its = pieces.componentOf(rim[faced]);
      if (its == own)
        continue;
      votes[{std::min(own, its), std::max(own, its)}] += normals[i].dot(normals[faced]);
      break;
    }
  }
  return votes;
}

} // namespace

bool
turnToFace(const Seam& seam, const Winding& pieces, Triangles& given)
{
  if (pieces.components().size() < 2)
    return false;
  std::vector<std::pair<Pair, double>> clearest;
  for (const auto& votes : vote(seam, pieces, given))
    clearest.emplace_back(votes);
  std::stable_sort(clearest.begin(), clearest.end(), [](const auto& a, const auto& b) {
    return std::abs(a.second) > std::abs(b.second);
  });
  LabelSets sides;
  for (std::size_t i = 0; i < pieces.components().size(); ++i)
    sides.add();
  for (const auto& [pair, votes] : clearest)
    sides.join(2 * static_cast<pcl::index_t>(pair[0]),
               2 * static_cast<pcl::index_t>(pair[1]) + (votes < 0.0 ? 1 : 0));
  bool has_turned = false;
  for (std::size_t t = 0; t < given.size(); ++t)
    if ((sides.find(2 * static_cast<pcl::index_t>(pieces.componentOf(t))) & 1) != 0) {
      std::swap(given[t][1], given[t][2]);
      has_turned = true;
    }
  return has_turned;
}

} // namespace pcl::ccaa
