// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: PCL's KdTree of floats over positions anywhere, of any
// size.
#include "field/float_tree.h"

#include <pcl/search/kdtree.h>
#include <pcl/memory.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl::repair {
namespace {

/** \brief Coordinates in the frame are at most 1 in size, and floats: what a search may
 * be wrong by. */
constexpr double FLOAT_MARGIN = 1e-6;
/** From further away all positions are equally near, as far as floats tell. */
constexpr double FARTHEST = 1e6;

pcl::PointXYZ
toPoint(const Position& position)
{
  return {static_cast<float>(position.x()),
          static_cast<float>(position.y()),
          static_cast<float>(position.z())};
}

} // namespace

FloatTree::FloatTree(const Positions& positions,
                     pcl::search::Search<pcl::PointXYZ>::Ptr search)
: tree_(std::move(search)), size_(static_cast<pcl::index_t>(positions.size()))
{
  if (positions.empty()) {
    tree_.reset();
    return;
  }
  Eigen::AlignedBox3d box;
  for (const Position& position : positions)
    box.extend(position);
  origin_ = box.center();
  const double extent = box.sizes().maxCoeff();
  scale_ = extent > 0.0 ? 1.0 / extent : 1.0;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(positions.size());
  for (const Position& position : positions)
    cloud->push_back(toPoint(toFrame(position)));
  if (!tree_)
    tree_ = pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false);
  tree_->setInputCloud(cloud);
}

void
FloatTree::near(const Position& center,
                double radius,
                std::vector<pcl::index_t>& found) const
{
  found.clear();
  if (!tree_ || !(radius >= 0.0) || !center.allFinite())
    return;
  const Position place = toFrame(center);
  const double reach = radius * scale_ * (1.0 + FLOAT_MARGIN) + FLOAT_MARGIN;
  if (reach > place.norm() + 1.0) { // all
    found.resize(static_cast<std::size_t>(size_));
    std::iota(found.begin(), found.end(), 0);
    return;
  }
  if (reach < place.cwiseAbs().maxCoeff() - 1.0) // none, and perhaps beyond floats
    return;
  std::vector<float> squared;
  tree_->radiusSearch(toPoint(place), reach, found, squared);
  std::sort(found.begin(), found.end());
}

std::vector<pcl::index_t>
FloatTree::nearest(const Position& center, std::size_t number) const
{
  std::vector<pcl::index_t> found;
  if (!tree_ || number == 0 || !center.allFinite())
    return found;
  std::vector<float> squared;
  const auto wanted = std::min(number, static_cast<std::size_t>(size_));
  const Position place = toFrame(center).cwiseMax(-FARTHEST).cwiseMin(FARTHEST);
  tree_->nearestKSearch(toPoint(place), static_cast<int>(wanted), found, squared);
  std::vector<std::pair<float, pcl::index_t>> order;
  for (std::size_t i = 0; i < found.size(); ++i)
    order.emplace_back(squared[i], found[i]);
  std::sort(order.begin(), order.end());
  for (std::size_t i = 0; i < found.size(); ++i)
    found[i] = order[i].second;
  return found;
}

} // namespace pcl::repair
