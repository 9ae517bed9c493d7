// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: example, a mesh from scans that overlap and disagree.
//
// Usage: registered_scans SCANS.ply|SCANS.pcd MESH.ply
//                         [-z MIN,MAX] [-patch LEAVES] [-viewpoint X,Y,Z]
//                         [-seconds LIMIT]
//
// The points of several registered scans lie in layers: where scans overlap, the cloud
// is dense, and the layers are as far apart as the points. An interpolating
// reconstruction would weave triangles between them. PCL's filters make one layer of
// them first; all their sizes follow from the spacing of the cloud.
//
// -z keeps what lies between two heights; -patch says how far points are smoothed, in
// cells of the grid; -viewpoint says where the sensor stood, for
// scans whose outer side cannot be told by shape; -seconds and Ctrl-C end the run
// without a result: exit code 130.
#include <pcl/common/point_tests.h>
#include <pcl/console/parse.h>
#include <pcl/console/print.h>
#include <pcl/filters/passthrough.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/surface/mls.h>
#include <pcl/surface_ccaa/block_search.h>
#include <pcl/surface_ccaa/consecutive_reconstruction.h>
#include <pcl/surface_ccaa/umbrella_filter.h>
#include <pcl/conversions.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using BlockSearch = pcl::search::BlockSearch<pcl::PointXYZ>;

/** Edge of the grid's cells in mean spacings: about two points of the raw cloud share
 * one. */
constexpr double LEAF_SPACINGS = 1.5;
constexpr int PATCH_ORDER = 2;
/** A point is an outlier when its neighbors are this many standard deviations farther
 * than usual. Less would take thinly scanned places away as well. */
constexpr double OUTLIER_DEVIATIONS = 4.0;
constexpr int OUTLIER_NEIGHBORS = 20;

/** \brief What the user asks for. */
struct Settings {
  /** \brief Radius of the surface patches that smooth the points, in cells of the grid:
   * some fifty points, enough for the noise and few enough for the folds. */
  double patch_leaves = 4.0;
  double lowest = -std::numeric_limits<float>::max(); /**< z, units of the cloud */
  double highest = std::numeric_limits<float>::max();
  std::optional<Eigen::Vector3f> viewpoint; /**< where the sensor stood */
  double seconds = std::numeric_limits<double>::infinity(); /**< of reconstruction */
};

/** \brief The finite points of a file; empty if it cannot be read. */
Cloud::Ptr
readScans(const std::string& file)
{
  const bool is_pcd = file.size() > 4 && file.substr(file.size() - 4) == ".pcd";
  Cloud all;
  if ((is_pcd ? pcl::io::loadPCDFile(file, all) : pcl::io::loadPLYFile(file, all)) < 0)
    all.clear();
  Cloud::Ptr finite(new Cloud);
  std::copy_if(all.begin(),
               all.end(),
               std::back_inserter(*finite),
               [](const pcl::PointXYZ& point) { return pcl::isFinite(point); });
  return finite;
}

/** \brief Root mean square distance to the six nearest neighbors, averaged; in units of
 * the cloud, which must have seven points at least. */
double
meanSpacing(const Cloud::Ptr& cloud)
{
  constexpr int NEIGHBORS = 6;
  BlockSearch search;
  search.setInputCloud(cloud);
  pcl::Indices near;
  std::vector<float> sqr_distances;
  double sum = 0;
  for (const pcl::PointXYZ& point : *cloud) {
    search.nearestKSearch(point, NEIGHBORS + 1, near, sqr_distances);
    double sqr_sum = 0; // the point itself is one of those found, at distance 0
    for (const float sqr_distance : sqr_distances)
      sqr_sum += sqr_distance;
    sum += std::sqrt(sqr_sum / NEIGHBORS);
  }
  return sum / double(cloud->size());
}

//! [crop]
/** \brief The points between two heights. */
pcl::IndicesPtr
between(const Cloud::Ptr& cloud, double lowest, double highest)
{
  pcl::PassThrough<pcl::PointXYZ> pass;
  pass.setInputCloud(cloud);
  pass.setFilterFieldName("z");
  pass.setFilterLimits(float(lowest), float(highest));
  const auto inside = pcl::make_shared<pcl::Indices>();
  pass.filter(*inside);
  return inside;
}
//! [crop]

//! [grid]
/** \brief One point, the mean, for each cell of a grid that holds any. */
Cloud::Ptr
evenOut(const Cloud::Ptr& cloud, const pcl::IndicesPtr& indices, double leaf)
{
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud);
  grid.setIndices(indices);
  grid.setLeafSize(float(leaf), float(leaf), float(leaf));
  Cloud::Ptr result(new Cloud);
  grid.filter(*result);
  return result;
}
//! [grid]

//! [outliers]
Cloud::Ptr
removeOutliers(const Cloud::Ptr& cloud)
{
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(cloud);
  removal.setMeanK(OUTLIER_NEIGHBORS);
  removal.setStddevMulThresh(OUTLIER_DEVIATIONS);
  Cloud::Ptr result(new Cloud);
  removal.filter(*result);
  return result;
}
//! [outliers]

//! [smooth]
/** \brief Each point moved onto a smooth patch fitted to those around it. */
Cloud::Ptr
smooth(const Cloud::Ptr& cloud, double radius)
{
  pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointXYZ> patches;
  patches.setInputCloud(cloud);
  patches.setSearchMethod(pcl::make_shared<BlockSearch>());
  patches.setSearchRadius(radius);
  patches.setPolynomialOrder(PATCH_ORDER);
  patches.setNumberOfThreads(std::max(1u, std::thread::hardware_concurrency()));
  Cloud::Ptr result(new Cloud);
  patches.process(*result);
  return result;
}
//! [smooth]

//! [prepare]
/** \brief One even layer of points from many uneven ones. */
Cloud::Ptr
prepare(const Cloud::Ptr& scans, const Settings& settings)
{
  const double leaf = LEAF_SPACINGS * meanSpacing(scans);
  const double radius = settings.patch_leaves * leaf;
  // A margin around what is asked for: points at the edge keep their neighbors.
  const pcl::IndicesPtr wanted =
      between(scans, settings.lowest - radius, settings.highest + radius);
  // The grid goes first: beside places that many scans have seen, those that only one
  // has seen would pass for outliers.
  const Cloud::Ptr even = evenOut(scans, wanted, leaf);
  const Cloud::Ptr clean = removeOutliers(even);
  const Cloud::Ptr layer = smooth(clean, radius);
  // Smoothing brings points of different layers together; the mean of such neighbors
  // now lies on the surface, too.
  const Cloud::Ptr result = evenOut(layer, nullptr, leaf);
  std::printf("%zu points, %zu after the grid, %zu without outliers, %zu smooth and "
              "even\n",
              scans->size(),
              even->size(),
              clean->size(),
              result->size());
  return result;
}
//! [prepare]

//! [progress]
volatile std::sig_atomic_t interrupted = 0;

/** \brief Show where a run stands; false, which cancels it, after Ctrl-C or when the
 * time is over. */
pcl::ccaa::ProgressCallback
watch(double seconds)
{
  using Clock = std::chrono::steady_clock;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  return [seconds, begin = Clock::now()](const std::string& stage, double fraction) {
    std::fprintf(stderr, "\r%-24s %3.0f %%", stage.c_str(), 100 * fraction);
    const std::chrono::duration<double> passed = Clock::now() - begin;
    return interrupted == 0 && passed.count() < seconds;
  };
}
//! [progress]

//! [reconstruct]
/** \brief A mesh of the points asked for; without polygons when it was cancelled. */
pcl::PolygonMesh
reconstruct(const Cloud::Ptr& cloud, const Settings& settings)
{
  pcl::ConsecutiveReconstruction<pcl::PointXYZ> chain;
  chain.setInputCloud(cloud);
  chain.setIndices(between(cloud, settings.lowest, settings.highest));
  chain.setProgressCallback(watch(settings.seconds));
  pcl::PolygonMesh mesh;
  chain.reconstruct(mesh);
  std::fprintf(stderr, "\n");
  return mesh;
}
//! [reconstruct]

//! [viewpoint]
/** \brief Turn the triangles to where the sensor stood. */
void
turnTo(const Eigen::Vector3f& viewpoint, pcl::PolygonMesh& mesh)
{
  pcl::PointCloud<pcl::PointWithViewpoint> cloud;
  pcl::fromPCLPointCloud2(mesh.cloud, cloud);
  for (pcl::PointWithViewpoint& point : cloud) {
    point.vp_x = viewpoint.x();
    point.vp_y = viewpoint.y();
    point.vp_z = viewpoint.z();
  }
  const auto seen = pcl::make_shared<pcl::PolygonMesh>(mesh);
  pcl::toPCLPointCloud2(cloud, seen->cloud);

  pcl::UmbrellaFilter filter;
  filter.setInputMesh(seen);
  filter.setMinimumInternalPoints(0); // turn only, take nothing away
  pcl::PolygonMesh turned;
  filter.process(turned);
  mesh.polygons = turned.polygons;
}
//! [viewpoint]

//! [settings]
Settings
readSettings(int argc, char** argv)
{
  Settings settings;
  pcl::console::parse_2x_arguments(
      argc, argv, "-z", settings.lowest, settings.highest, false);
  pcl::console::parse_argument(argc, argv, "-patch", settings.patch_leaves);
  pcl::console::parse_argument(argc, argv, "-seconds", settings.seconds);
  Eigen::Vector3f at;
  if (pcl::console::parse_3x_arguments(
          argc, argv, "-viewpoint", at.x(), at.y(), at.z(), false) >= 0)
    settings.viewpoint = at;
  return settings;
}
//! [settings]

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 3) {
    std::fprintf(stderr,
                 "usage: registered_scans SCANS.ply|SCANS.pcd MESH.ply [-z MIN,MAX] "
                 "[-patch LEAVES] [-viewpoint X,Y,Z] [-seconds LIMIT]\n");
    return 1;
  }
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  const Cloud::Ptr scans = readScans(argv[1]);
  if (scans->size() < 7) {
    std::fprintf(stderr, "registered_scans: no points in %s\n", argv[1]);
    return 1;
  }
  //! [main]
  const Settings settings = readSettings(argc, argv);
  pcl::PolygonMesh mesh = reconstruct(prepare(scans, settings), settings);
  if (mesh.polygons.empty()) {
    std::fprintf(stderr, "registered_scans: no mesh\n");
    return 130;
  }
  if (settings.viewpoint)
    turnTo(*settings.viewpoint, mesh);
  //! [main]
  if (pcl::io::savePLYFileBinary(argv[2], mesh) < 0) {
    std::fprintf(stderr, "registered_scans: cannot write %s\n", argv[2]);
    return 1;
  }
  std::printf("%zu triangles written to %s\n", mesh.polygons.size(), argv[2]);
}
