// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: one even layer of points from scans that overlap and
// disagree.
#include "clean_cloud.h"

#include <pcl/common/point_tests.h>
// Compiled here: with pcl_filters and what it needs, 50 000 symbols to look for, each
// program starts in 48 instead of 27 ms.
#include <pcl/filters/impl/filter_indices.hpp>
#include <pcl/filters/impl/statistical_outlier_removal.hpp>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/surface/mls.h>
#include <pcl/surface_ccaa/block_search.h>

#include "cloud_scale.h"
#include "io/point_columns.h"
#include "mesh/cloud_access.h"
#include "mesh/quantile.h"
#include "point_groups.h"
#include "run/threads.h"
#include "two_sheets.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace app {
namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** Edge of the grid's cells in spacings: about two points of the cloud share one. */
constexpr double CELL_SPACINGS = 1.5;
constexpr double RADIUS_SPACINGS = 4.0;
/** Sheets closer than this are one surface that was measured twice. */
constexpr double SHEET_SPACINGS = 2.0;
constexpr int OUTLIER_NEIGHBORS = 20;
/** A point and those that tell whether it was moved alone, as noise is. */
constexpr int MOVED_TOGETHER = 7;
/** Spacings, and times the median move, from which the mean move of these tells of a
 * shape: with noise of a spacing it reaches 0.36 and 1.6, where parts vanished 0.96. */
constexpr double SHAPE_SPACINGS = 0.5;
constexpr double SHAPE_MOVES = 3.0;
constexpr int PATCH_ORDER = 2;

Cloud::Ptr
positionsOf(const Model& model)
{
  auto cloud = pcl::make_shared<Cloud>();
  for (const Eigen::Vector3f& at : readPositions(model.mesh.cloud, model.shift))
    cloud->emplace_back(at.x(), at.y(), at.z());
  return cloud;
}

/** Spacing and radius, where they are not given, from the data. */
CleanParameters
completed(CleanParameters parameters, const Cloud::ConstPtr& points)
{
  const CloudScale scale = measureScale(points);
  if (parameters.spacing <= 0)
    parameters.spacing = scale.spacing;
  if (parameters.radius <= 0)
    parameters.radius =
        std::max(RADIUS_SPACINGS * parameters.spacing, scale.flat_radius);
  return parameters;
}

pcl::Indices
withoutOutliers(const Cloud::ConstPtr& cloud, double deviations)
{
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(cloud);
  removal.setMeanK(OUTLIER_NEIGHBORS);
  removal.setStddevMulThresh(deviations);
  pcl::Indices kept;
  removal.filter(kept);
  return kept;
}

/** Each point moved onto a smooth patch fitted to those around it. What has too few
 * neighbours, or lies in two sheets, stays where it is. */
Cloud::Ptr
smooth(const Cloud::ConstPtr& cloud,
       const CleanParameters& parameters,
       int threads,
       CleanReport& report)
{
  pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointXYZ> patches;
  patches.setInputCloud(cloud);
  patches.setSearchMethod(pcl::make_shared<pcl::search::BlockSearch<pcl::PointXYZ>>());
  patches.setSearchRadius(parameters.radius);
  patches.setPolynomialOrder(PATCH_ORDER);
  patches.setNumberOfThreads(static_cast<unsigned int>(threads));
  Cloud moved;
  patches.process(moved);
  // Threads put their points one behind the other in the order they came by them.
  const pcl::Indices& origins = patches.getCorrespondingIndices()->indices;
  const std::vector<std::uint8_t> stays = findTwoSheets(
      cloud, parameters.radius, SHEET_SPACINGS * parameters.spacing, threads);
  auto result = pcl::make_shared<Cloud>(*cloud);
  for (std::size_t i = 0; i < moved.size(); ++i)
    if (const auto origin = static_cast<std::size_t>(origins[i]);
        pcl::isFinite(moved[i]) && stays[origin] == 0)
      (*result)[origin] = moved[i];
  report.in_two_sheets =
      static_cast<std::size_t>(std::count(stays.begin(), stays.end(), 1));
  return result;
}

Eigen::Vector3f
moveOf(std::size_t point, const Cloud& before, const Cloud& after)
{
  return after[point].getVector3fMap() - before[point].getVector3fMap();
}

/** Length of the mean move of each point and those around it: as long as its own where
 * a shape changes, short for noise. */
std::vector<double>
meanMoves(const Cloud::ConstPtr& before, const Cloud& after, int threads)
{
  pcl::search::BlockSearch<pcl::PointXYZ> search;
  search.setInputCloud(before);
  std::vector<double> means(before->size());
  const auto count = static_cast<std::ptrdiff_t>(before->size());
#pragma omp parallel for schedule(dynamic, 256) num_threads(threads)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto point = static_cast<std::size_t>(i);
    pcl::Indices near;
    std::vector<float> sqr_distances;
    search.nearestKSearch((*before)[point], MOVED_TOGETHER, near, sqr_distances);
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const pcl::index_t other : near)
      sum += moveOf(static_cast<std::size_t>(other), *before, after);
    means[point] = static_cast<double>(sum.norm()) / MOVED_TOGETHER;
  }
  return means;
}

void
tellMoves(const Cloud::ConstPtr& before,
          const Cloud& after,
          int threads,
          CleanReport& report)
{
  if (before->empty())
    return;
  std::vector<double> moves;
  double sum = 0;
  for (std::size_t i = 0; i < before->size(); ++i) {
    moves.push_back(moveOf(i, *before, after).cast<double>().norm());
    sum += moves.back() * moves.back();
    report.moved_most = std::max(report.moved_most, moves.back());
  }
  report.moved = std::sqrt(sum / static_cast<double>(before->size()));
  const double least = std::max(SHAPE_SPACINGS * report.spacing,
                                SHAPE_MOVES * pcl::ccaa::medianOf(std::move(moves)));
  const std::vector<double> means = meanMoves(before, after, threads);
  report.moved_together = static_cast<std::size_t>(std::count_if(
      means.begin(), means.end(), [&](double mean) { return mean > least; }));
  const auto most = std::max_element(means.begin(), means.end()) - means.begin();
  report.moved_at =
      (*before)[static_cast<std::size_t>(most)].getVector3fMap().cast<double>();
}

/** Points of the result, and the points of the cloud that each is made of. */
struct Layer {
  Cloud::Ptr points;
  PointGroups sources;
};

/** \return no points when it was stopped */
Layer
makeLayer(const Cloud& cloud,
          const CleanParameters& parameters,
          int threads,
          const std::function<bool(double)>& goes_on,
          CleanReport& report)
{
  Layer layer;
  // The grid goes first: beside places that many scans have seen, those that only one
  // has seen would pass for outliers.
  const PointGroups cells = groupByCell(cloud, CELL_SPACINGS * parameters.spacing);
  const Cloud::Ptr even = meansOf(cells, cloud);
  report.grid_points = cells.size();
  if (!goes_on(0.2))
    return layer;
  const pcl::Indices kept = withoutOutliers(even, parameters.outlier_deviations);
  const PointGroups clean = PointGroups::singles(kept).unfolded(cells);
  const auto inliers = pcl::make_shared<Cloud>(*even, kept);
  report.outliers = cells.size() - kept.size();
  if (!goes_on(0.4))
    return layer;
  const Cloud::Ptr smoothed = smooth(inliers, parameters, threads, report);
  tellMoves(inliers, *smoothed, threads, report);
  if (!goes_on(0.8))
    return layer;
  std::vector<std::size_t> weights;
  for (std::size_t g = 0; g < clean.size(); ++g)
    weights.push_back(clean.sizeOf(g));
  const Thinning thinned = thin(smoothed, weights, parameters.spacing);
  layer.points = pcl::make_shared<Cloud>(*smoothed, thinned.kept);
  layer.sources = thinned.groups.unfolded(clean);
  return layer;
}

/** The points of a layer with weights of their sources: the nearest has most. */
std::vector<pcl::ccaa::NewVertex>
withSources(const Layer& layer,
            const Cloud& cloud,
            double spacing,
            const Eigen::Vector3d& offset)
{
  std::vector<pcl::ccaa::NewVertex> vertices(layer.points->size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Eigen::Vector3f at = (*layer.points)[i].getVector3fMap();
    vertices[i].position = at.cast<double>() + offset;
    for (std::size_t m = layer.sources.begins[i]; m < layer.sources.begins[i + 1];
         ++m) {
      const pcl::index_t source = layer.sources.members[m];
      const Eigen::Vector3f from =
          cloud[static_cast<std::size_t>(source)].getVector3fMap();
      const double away = (from - at).cast<double>().norm() / spacing;
      vertices[i].sources.push_back({source, 1.0 / (1.0 + away * away)});
    }
  }
  return vertices;
}

/** A mean of places where sensors stood is a place where none did. */
void
takeNearestSensors(const std::vector<pcl::ccaa::NewVertex>& vertices,
                   std::size_t old_points,
                   pcl::PCLPointCloud2& cloud)
{
  for (const char* name : {"vp_x", "vp_y", "vp_z"}) {
    const pcl::PCLPointField* const field = findField(cloud, name);
    if (field == nullptr)
      continue;
    const std::size_t size = scalarSize(field->datatype);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const auto nearest = std::max_element(
          vertices[i].sources.begin(),
          vertices[i].sources.end(),
          [](const auto& a, const auto& b) { return a.weight < b.weight; });
      std::memcpy(
          cloud.data.data() + (old_points + i) * cloud.point_step + field->offset,
          pointAt(cloud, static_cast<std::size_t>(nearest->vertex)) + field->offset,
          size);
    }
  }
}

/** Put new points in place of the old ones. */
void
replacePoints(const std::vector<pcl::ccaa::NewVertex>& vertices,
              pcl::PCLPointCloud2& cloud)
{
  const std::size_t old_points = pointCount(cloud);
  const auto problem = pcl::ccaa::appendVertices(cloud, vertices);
  if (problem != pcl::ccaa::CloudProblem::NONE)
    throw Failure(std::string("the cloud cannot be cleaned: ") +
                  pcl::ccaa::describe(problem));
  takeNearestSensors(vertices, old_points, cloud);
  const auto old_bytes =
      static_cast<std::ptrdiff_t>(old_points * std::size_t{cloud.point_step});
  cloud.data.erase(cloud.data.begin(), cloud.data.begin() + old_bytes);
  cloud.width = static_cast<pcl::uindex_t>(vertices.size());
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = true;
}

} // namespace

CleanReport
cleanCloud(const CleanParameters& parameters,
           unsigned int threads,
           const std::function<bool(double)>& goes_on,
           Model& model)
{
  const Cloud::ConstPtr cloud = positionsOf(model);
  CleanReport report;
  report.input_points = cloud->size();
  // Points that were measured twice at one place say nothing about the spacing.
  const PointGroups places = groupByCell(*cloud, 0.0);
  report.skipped_points = cloud->size() - places.members.size();
  if (places.size() < least_points || !goes_on(0.1))
    return report;
  const CleanParameters used = completed(parameters, meansOf(places, *cloud));
  report.spacing = used.spacing;
  report.radius = used.radius;
  const Layer layer =
      makeLayer(*cloud, used, pcl::ccaa::resolveThreads(threads), goes_on, report);
  if (!layer.points)
    return report;
  replacePoints(withSources(layer, *cloud, used.spacing, model.shift.offset()),
                model.mesh.cloud);
  report.output_points = layer.points->size();
  report.moved_at += model.shift.offset();
  return report;
}

} // namespace app
