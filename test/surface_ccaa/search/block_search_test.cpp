// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: tests of the block search as a PCL search method.
#include <pcl/features/impl/normal_3d.hpp>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/gp3.h>
#include <pcl/surface_ccaa/block_search.h>

#include <gtest/gtest.h>

#include "search_inputs.h"

namespace pcl::ccaa::test {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using BlockSearch = pcl::search::BlockSearch<pcl::PointXYZ>;
using KdTree = pcl::search::KdTree<pcl::PointXYZ>;

struct Found {
  pcl::Indices indices;
  std::vector<float> sqr_distances;
};

Found
nearest(const pcl::search::Search<pcl::PointXYZ>& search, const pcl::PointXYZ& p, int k)
{
  Found found;
  const int count = search.nearestKSearch(p, k, found.indices, found.sqr_distances);
  EXPECT_EQ(static_cast<std::size_t>(count), found.indices.size());
  EXPECT_EQ(static_cast<std::size_t>(count), found.sqr_distances.size());
  return found;
}

Found
within(const pcl::search::Search<pcl::PointXYZ>& search,
       const pcl::PointXYZ& p,
       double radius,
       unsigned int max_nn = 0)
{
  Found found;
  const int count =
      search.radiusSearch(p, radius, found.indices, found.sqr_distances, max_nn);
  EXPECT_EQ(static_cast<std::size_t>(count), found.indices.size());
  return found;
}

TEST(BlockSearch, AgreesWithKdTree)
{
  const Cloud::Ptr cloud = toCloud(shuffled(noisySphere(3000, 0.01), 2));
  BlockSearch blocks;
  KdTree tree;
  blocks.setInputCloud(cloud);
  tree.setInputCloud(cloud);
  for (std::size_t i = 0; i < cloud->size(); i += 7) {
    const pcl::PointXYZ& p = (*cloud)[i];
    ASSERT_EQ(nearest(blocks, p, 16).sqr_distances, nearest(tree, p, 16).sqr_distances);
    ASSERT_EQ(within(blocks, p, 0.1).sqr_distances, within(tree, p, 0.1).sqr_distances);
    ASSERT_EQ(within(blocks, p, 0.1, 5).sqr_distances,
              within(tree, p, 0.1, 5).sqr_distances);
  }
}

TEST(BlockSearch, SortsByDistanceThenIndex)
{
  const Cloud::Ptr cloud = toCloud(shuffled(lattice(6), 3));
  BlockSearch blocks;
  blocks.setInputCloud(cloud);
  const Found found = within(blocks, (*cloud)[17], 2.5);
  EXPECT_EQ(found.indices[0], 17);
  for (std::size_t i = 1; i < found.indices.size(); ++i)
    EXPECT_LT(std::make_pair(found.sqr_distances[i - 1], found.indices[i - 1]),
              std::make_pair(found.sqr_distances[i], found.indices[i]));
}

TEST(BlockSearch, FindsOnlyAmongTheIndicesGiven)
{
  const Cloud::Ptr cloud = toCloud(noisySphere(500, 0.01));
  const pcl::IndicesPtr indices(new pcl::Indices{40, 4, 400});
  BlockSearch blocks;
  blocks.setInputCloud(cloud, indices);
  Found found;
  EXPECT_EQ(blocks.nearestKSearch(2, 10, found.indices, found.sqr_distances), 3);
  EXPECT_EQ(found.indices[0], 400);
  std::sort(found.indices.begin(), found.indices.end());
  EXPECT_EQ(found.indices, (pcl::Indices{4, 40, 400}));
  EXPECT_EQ(blocks.getIndices(), indices);
  EXPECT_EQ(blocks.getInputCloud(), cloud);
}

TEST(BlockSearch, RefusesIndicesOutOfRange)
{
  const Cloud::Ptr cloud = toCloud(noisySphere(50, 0.01));
  BlockSearch blocks;
  for (const pcl::index_t wrong : {-1, 50}) {
    blocks.setInputCloud(cloud, pcl::IndicesPtr(new pcl::Indices{1, wrong}));
    EXPECT_TRUE(nearest(blocks, (*cloud)[0], 5).indices.empty());
  }
}

TEST(BlockSearch, SkipsNonFinitePoints)
{
  const Cloud::Ptr cloud = toCloud(withNonFinite(noisySphere(300, 0.01), 100));
  BlockSearch blocks;
  blocks.setInputCloud(cloud);
  EXPECT_EQ(nearest(blocks, {0, 0, 0}, 1000).indices.size(), 200u);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(nearest(blocks, {nan, 0, 0}, 5).indices.empty());
  EXPECT_TRUE(within(blocks, {0, 0, nan}, 5).indices.empty());
}

TEST(BlockSearch, CopesWithNoCloudAndNoPoints)
{
  BlockSearch blocks;
  EXPECT_TRUE(nearest(blocks, {0, 0, 0}, 5).indices.empty());
  blocks.setInputCloud(Cloud::Ptr(new Cloud));
  EXPECT_TRUE(nearest(blocks, {0, 0, 0}, 5).indices.empty());
  EXPECT_TRUE(within(blocks, {0, 0, 0}, 5).indices.empty());
  blocks.setInputCloud(nullptr);
  EXPECT_TRUE(within(blocks, {0, 0, 0}, 5).indices.empty());
}

TEST(BlockSearch, FindsNothingForSenselessNumbers)
{
  const Cloud::Ptr cloud = toCloud(noisySphere(50, 0.01));
  BlockSearch blocks;
  blocks.setInputCloud(cloud);
  EXPECT_TRUE(nearest(blocks, (*cloud)[0], 0).indices.empty());
  EXPECT_TRUE(nearest(blocks, (*cloud)[0], -3).indices.empty());
  EXPECT_TRUE(within(blocks, (*cloud)[0], -1).indices.empty());
  EXPECT_EQ(within(blocks, (*cloud)[0], 0).indices, pcl::Indices{0});
  EXPECT_EQ(within(blocks, (*cloud)[0], 1e300).indices.size(), 50u);
}

TEST(BlockSearch, CanBeAskedFromManyThreads)
{
  const Cloud::Ptr cloud = toCloud(noisySphere(2000, 0.01));
  BlockSearch blocks;
  blocks.setInputCloud(cloud);
  std::vector<pcl::index_t> nearest_index(cloud->size());
#pragma omp parallel for num_threads(4)
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    Found found;
    blocks.nearestKSearch((*cloud)[i], 3, found.indices, found.sqr_distances);
    nearest_index[i] = found.indices[0];
  }
  for (std::size_t i = 0; i < cloud->size(); ++i)
    EXPECT_EQ(nearest_index[i], static_cast<pcl::index_t>(i));
}

TEST(BlockSearch, SaysItsName) { EXPECT_EQ(BlockSearch().getName(), "BlockSearch"); }

pcl::PointCloud<pcl::PointNormal>::Ptr
withNormals(const Cloud::Ptr& cloud,
            const pcl::search::Search<pcl::PointXYZ>::Ptr& search)
{
  pcl::NormalEstimation<pcl::PointXYZ, pcl::PointNormal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(search);
  estimation.setKSearch(12);
  estimation.setViewPoint(9, 9, 9);
  pcl::PointCloud<pcl::PointNormal>::Ptr result(new pcl::PointCloud<pcl::PointNormal>);
  estimation.compute(*result);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    (*result)[i].getVector3fMap() = (*cloud)[i].getVector3fMap();
  return result;
}

TEST(BlockSearch, ServesNormalEstimation)
{
  const Cloud::Ptr cloud = toCloud(noisySphere(2000, 0.001));
  const auto a = withNormals(cloud, BlockSearch::Ptr(new BlockSearch));
  const auto b = withNormals(cloud, KdTree::Ptr(new KdTree));
  for (std::size_t i = 0; i < cloud->size(); ++i)
    EXPECT_GT((*a)[i].getNormalVector3fMap().dot((*b)[i].getNormalVector3fMap()),
              0.9999f);
}

TEST(BlockSearch, ServesGreedyProjectionTriangulation)
{
  const Cloud::Ptr cloud = toCloud(noisySphere(1000, 0.001));
  const auto points = withNormals(cloud, BlockSearch::Ptr(new BlockSearch));
  const auto triangulate = [&points](const auto& search) {
    pcl::GreedyProjectionTriangulation<pcl::PointNormal> gp3;
    gp3.setInputCloud(points);
    gp3.setSearchMethod(search);
    gp3.setSearchRadius(0.4);
    gp3.setMu(2.5);
    gp3.setMaximumNearestNeighbors(60);
    pcl::PolygonMesh mesh;
    gp3.reconstruct(mesh);
    return mesh.polygons.size();
  };
  using Blocks = pcl::search::BlockSearch<pcl::PointNormal>;
  using Tree = pcl::search::KdTree<pcl::PointNormal>;
  const std::size_t polygons = triangulate(Blocks::Ptr(new Blocks));
  EXPECT_GT(polygons, 1500u);
  EXPECT_EQ(polygons, triangulate(Tree::Ptr(new Tree)));
}

} // namespace
} // namespace pcl::ccaa::test
