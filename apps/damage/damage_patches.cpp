// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: connected patches of random shape that are taken away.
#include "damage_patches.h"

#include <pcl/search/kdtree.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <memory>

namespace app {
namespace {

using Tree = pcl::search::KdTree<pcl::PointXYZ>;

std::unique_ptr<Tree>
makeTree(const Points& points)
{
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    (*cloud)[i].getVector3fMap() = points[i];
  cloud->is_dense = false;
  auto tree = std::make_unique<Tree>();
  tree->setInputCloud(cloud);
  return tree;
}

class EdgeNeighbors : public PointNeighbors {
public:
  EdgeNeighbors(const pcl::PolygonMesh& mesh, std::size_t points)
  : first_(points + 1, 0)
  {
    for (const pcl::Vertices& polygon : mesh.polygons)
      for (const pcl::index_t corner : polygon.vertices)
        first_[static_cast<std::size_t>(corner) + 1] += 2;
    for (std::size_t i = 0; i < points; ++i)
      first_[i + 1] += first_[i];
    ends_.resize(first_[points]);
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const pcl::Vertices& polygon : mesh.polygons) {
      const auto& corners = polygon.vertices;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const pcl::index_t from = corners[i];
        const pcl::index_t to = corners[(i + 1) % corners.size()];
        ends_[next[static_cast<std::size_t>(from)]++] = to;
        ends_[next[static_cast<std::size_t>(to)]++] = from;
      }
    }
  }

  void
  collect(std::size_t point_index, pcl::Indices& neighbors) override
  {
    const auto at = [&](std::size_t i) {
      return ends_.begin() + static_cast<std::ptrdiff_t>(first_[i]);
    };
    neighbors.assign(at(point_index), at(point_index + 1));
  }

  bool
  canStart(std::size_t point_index) const override
  {
    return first_[point_index] != first_[point_index + 1];
  }

private:
  std::vector<std::size_t> first_;
  pcl::Indices ends_;
};

class NearestNeighbors : public PointNeighbors {
public:
  explicit NearestNeighbors(const Points& points)
  : points_(points), tree_(makeTree(points))
  {}

  void
  collect(std::size_t point_index, pcl::Indices& neighbors) override
  {
    pcl::PointXYZ query;
    query.getVector3fMap() = points_[point_index];
    tree_->nearestKSearch(query, 9, neighbors, distances_);
    const auto self = static_cast<pcl::index_t>(point_index);
    neighbors.erase(std::remove(neighbors.begin(), neighbors.end(), self),
                    neighbors.end());
  }

  bool
  canStart(std::size_t point_index) const override
  {
    return points_[point_index].allFinite();
  }

private:
  const Points& points_;
  std::unique_ptr<Tree> tree_;
  std::vector<float> distances_;
};

} // namespace

std::unique_ptr<PointNeighbors>
makeNeighbors(const pcl::PolygonMesh& mesh, const Points& points)
{
  if (mesh.polygons.empty())
    return std::make_unique<NearestNeighbors>(points);
  return std::make_unique<EdgeNeighbors>(mesh, points.size());
}

std::size_t
growPatch(PointNeighbors& neighbors,
          std::size_t size,
          RandomNumbers& random,
          std::vector<char>& removed)
{
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < removed.size(); ++i)
    if (removed[i] == 0 && neighbors.canStart(i))
      starts.push_back(i);
  if (starts.empty())
    return 0;
  std::vector<std::size_t> front{starts[random.below(starts.size())]};
  std::size_t grown = 0;
  pcl::Indices around;
  while (grown < size && !front.empty()) {
    std::swap(front[random.below(front.size())], front.back());
    const std::size_t point_index = front.back();
    front.pop_back();
    if (removed[point_index] != 0)
      continue;
    removed[point_index] = 1;
    ++grown;
    neighbors.collect(point_index, around);
    for (const pcl::index_t neighbor : around)
      if (removed[static_cast<std::size_t>(neighbor)] == 0)
        front.push_back(static_cast<std::size_t>(neighbor));
  }
  return grown;
}

double
meanSpacing(const Points& points)
{
  const std::unique_ptr<Tree> tree = makeTree(points);
  const std::size_t step = points.size() / 20000 + 1;
  double sum = 0;
  std::size_t counted = 0;
  pcl::Indices found;
  std::vector<float> distances;
  for (std::size_t i = 0; i < points.size(); i += step) {
    if (!points[i].allFinite())
      continue;
    pcl::PointXYZ query;
    query.getVector3fMap() = points[i];
    // More than two, since duplicates lie at distance 0.
    tree->nearestKSearch(query, 8, found, distances);
    const auto other = std::find_if(distances.begin(),
                                    distances.end(),
                                    [](float distance) { return distance > 0; });
    if (other == distances.end())
      continue;
    sum += std::sqrt(static_cast<double>(*other));
    ++counted;
  }
  return counted == 0 ? 0 : sum / static_cast<double>(counted);
}

} // namespace app
