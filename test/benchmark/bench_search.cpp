// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: table of times for the neighbors of all points of a cloud.
//
// Usage: bench_search [--k K] [--repeats R] [--generate N]... [CLOUD.ply |
// CLOUD.pcd]... Prints microseconds per point, structure included, for PCL's default
// tree (FLANN), nanoflann and PointBlocks: the best of R interleaved runs. Nothing
// passes or fails.
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface_ccaa/impl/point_array.h>
#include <pcl/surface_ccaa/impl/point_blocks.h>

#include "mesh/curve_order.h"

#if __has_include(<nanoflann.hpp>)
#include <nanoflann.hpp>
#define PSR_HAVE_NANOFLANN
#endif

#include "measuring.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Settings {
  unsigned int k = 16;
  int repeats = 5;
  std::vector<std::size_t> generated;
  std::vector<std::string> files;
};

/** A sphere with bumps, evenly covered, in random order. */
Cloud::Ptr
bumpySphere(std::size_t size)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  Cloud::Ptr cloud(new Cloud);
  for (std::size_t i = 0; i < size; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random);
    const double length = std::sqrt(x * x + y * y + z * z);
    const double radius =
        1 + 0.05 * std::sin(9 * x / length) * std::sin(8 * y / length + 1);
    const double scale = radius / length;
    cloud->push_back({float(scale * x), float(scale * y), float(scale * z)});
  }
  return cloud;
}

Cloud::Ptr
finitePoints(const Cloud& cloud)
{
  Cloud::Ptr finite(new Cloud);
  for (const auto& point : cloud)
    if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z))
      finite->push_back(point);
  return finite;
}

Cloud::Ptr
loadCloud(const std::string& file)
{
  Cloud cloud;
  const bool is_pcd = file.size() > 4 && file.substr(file.size() - 4) == ".pcd";
  if ((is_pcd ? pcl::io::loadPCDFile(file, cloud)
              : pcl::io::loadPLYFile(file, cloud)) != 0)
    return nullptr;
  return finitePoints(cloud);
}

Cloud::Ptr
shuffled(const Cloud& cloud)
{
  Cloud::Ptr result(new Cloud(cloud));
  std::mt19937 random(11);
  std::shuffle(result->begin(), result->end(), random);
  return result;
}

/** What the trees gain from our order alone; the time to find it is not counted. */
Cloud::Ptr
alongCurve(const Cloud& cloud)
{
  return Cloud::Ptr(
      new Cloud(cloud, pcl::ccaa::curveOrder(pcl::ccaa::pointArrayOf(cloud), 1)));
}

#ifdef PSR_HAVE_NANOFLANN

struct NanoflannView {
  const Cloud& cloud;

  std::size_t
  kdtree_get_point_count() const
  {
    return cloud.size();
  }

  float
  kdtree_get_pt(std::size_t i, std::size_t axis) const
  {
    return cloud[i].data[axis];
  }

  template <class Box>
  bool
  kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

void
runFlann(const Cloud::ConstPtr& cloud, unsigned int k, int threads)
{
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  std::vector<int> table(cloud->size() * k);
#pragma omp parallel num_threads(threads)
  {
    pcl::Indices neighbors;
    std::vector<float> sqr_distances;
#pragma omp for schedule(dynamic, 1024)
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      tree.nearestKSearch((*cloud)[i], int(k + 1), neighbors, sqr_distances);
      std::copy_n(
          neighbors.begin(), std::min<std::size_t>(k, neighbors.size()), &table[i * k]);
    }
  }
}

void
runNanoflann(const Cloud::ConstPtr& cloud, unsigned int k, int threads)
{
  using Metric = nanoflann::L2_Simple_Adaptor<float, NanoflannView>;
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<Metric, NanoflannView, 3, int>;
  const NanoflannView view{*cloud};
  const Tree tree(3, view, nanoflann::KDTreeSingleIndexAdaptorParams(12));
  std::vector<int> table(cloud->size() * k);
#pragma omp parallel num_threads(threads)
  {
    std::vector<int> neighbors(k + 1);
    std::vector<float> sqr_distances(k + 1);
#pragma omp for schedule(dynamic, 1024)
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      const auto found = tree.knnSearch(
          (*cloud)[i].data, k + 1, neighbors.data(), sqr_distances.data());
      std::copy_n(neighbors.begin(), std::min<std::size_t>(k, found), &table[i * k]);
    }
  }
}

#else

void
runNanoflann(const Cloud::ConstPtr&, unsigned int, int)
{}

#endif

void
runBlocks(const Cloud::ConstPtr& cloud, unsigned int k, int threads)
{
  pcl::ccaa::PointBlocks blocks;
  blocks.build(pcl::ccaa::pointArrayOf(*cloud), threads);
  blocks.allNearest(k, pcl::ccaa::PointBlocks::Distances::OMIT, threads);
}

void
printRow(const std::string& name,
         const Cloud::ConstPtr& cloud,
         const Settings& settings,
         int threads)
{
  using Run = void (*)(const Cloud::ConstPtr&, unsigned int, int);
  const std::array<Run, 3> runs = {runFlann, runNanoflann, runBlocks};
  std::array<std::vector<double>, 3> times;
  for (int repeat = 0; repeat < settings.repeats; ++repeat)
    for (std::size_t i = 0; i < runs.size(); ++i)
      times[i].push_back(
          bench::secondsOf([&] { runs[i](cloud, settings.k, threads); }));
  std::array<double, 3> best;
  for (std::size_t i = 0; i < runs.size(); ++i)
    best[i] = *std::min_element(times[i].begin(), times[i].end()) * 1e6 /
              double(cloud->size());
  std::printf("%-34s %9zu %3u %3d %8.3f %8.3f %8.3f %7.2f %7.2f\n",
              name.c_str(),
              cloud->size(),
              settings.k,
              threads,
              best[0],
              best[1],
              best[2],
              best[0] / best[2],
              best[1] / best[2]);
  std::fflush(stdout);
}

void
printCloud(const std::string& name,
           const Cloud::ConstPtr& cloud,
           const Settings& settings)
{
  const Cloud::ConstPtr mixed = shuffled(*cloud);
  printRow(name + " along curve", alongCurve(*cloud), settings, 1);
  for (const int threads : {1, 2}) {
    printRow(name, cloud, settings, threads);
    printRow(name + " shuffled", mixed, settings, threads);
  }
}

Settings
readArguments(int argc, char** argv)
{
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--k" && i + 1 < argc)
      settings.k = static_cast<unsigned int>(std::stoul(argv[++i]));
    else if (argument == "--repeats" && i + 1 < argc)
      settings.repeats = std::stoi(argv[++i]);
    else if (argument == "--generate" && i + 1 < argc)
      settings.generated.push_back(std::stoul(argv[++i]));
    else
      settings.files.push_back(argument);
  }
  return settings;
}

} // namespace

int
main(int argc, char** argv)
{
  const Settings settings = readArguments(argc, argv);
  std::printf("%-34s %9s %3s %3s %8s %8s %8s %7s %7s\n",
              "cloud",
              "N",
              "k",
              "thr",
              "FLANN",
              "nanofl.",
              "blocks",
              "FL/bl",
              "na/bl");
  for (const std::string& file : settings.files)
    if (const Cloud::ConstPtr cloud = loadCloud(file))
      printCloud(file.substr(file.find_last_of('/') + 1), cloud, settings);
  for (const std::size_t size : settings.generated)
    printCloud("bumpy sphere", bumpySphere(size), settings);
  return 0;
}
