// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the work of pcl_ccaa_reconstruct.
#include "reconstruct_run.h"

#include <pcl/search/kdtree.h>
#include <pcl/surface_ccaa/impl/consecutive_reconstruction.hpp>

#include "grid_start.h"
#include "io/cloud_normals.h"
#include "io/point_columns.h"
#include "io/position_check.h"
#include "io/wording.h"
#include "mesh/cloud_access.h"
#include "mesh/polygon_access.h"
#include "repair_run.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/** Comes after the stages of the chain. */
constexpr std::uint8_t REPAIR_LABEL = 2;

void
setHints(const Model&, pcl::PointCloud<pcl::PointXYZ>&)
{}

void
setHints(const Model& model, pcl::PointCloud<pcl::PointNormal>& cloud)
{
  const auto normals = pcl::ccaa::normalView(model.mesh.cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud[i].getNormalVector3fMap() = normals[i].cast<float>();
}

void
setHints(const Model& model, pcl::PointCloud<pcl::PointWithViewpoint>& cloud)
{
  const auto sensors = pcl::ccaa::viewpointView(model.mesh.cloud);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3f at = (sensors[i] - model.shift.offset()).cast<float>();
    cloud[i].vp_x = at.x();
    cloud[i].vp_y = at.y();
    cloud[i].vp_z = at.z();
  }
}

/** The positions near the origin, and what of the other fields tells the outer side. */
template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr
toTypedCloud(const Model& model)
{
  const auto positions =
      pcl::ccaa::positionView(model.mesh.cloud).relativeTo(model.shift.offset());
  auto cloud = std::make_shared<pcl::PointCloud<PointT>>();
  cloud->resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    (*cloud)[i].getVector3fMap() = positions[i].template cast<float>();
  cloud->is_dense = model.mesh.cloud.is_dense;
  cloud->width = model.mesh.cloud.width;
  cloud->height = model.mesh.cloud.height;
  setHints(model, *cloud);
  return cloud;
}

template <typename PointT>
std::shared_ptr<pcl::GreedyStart<PointT>>
makeStart(const ReconstructSettings& settings)
{
  auto start = std::make_shared<pcl::GreedyStart<PointT>>();
  if (settings.search == "kdtree")
    start->setSearchMethod(std::make_shared<pcl::search::KdTree<PointT>>());
  else
    start->setSearchMethod(std::make_shared<pcl::search::BlockSearch<PointT>>());
  start->setNumberOfNeighbors(settings.neighbors);
  start->setMinimumAngle(settings.minimum_angle * M_PI / 180);
  start->setCertifiedMinimumAngle(settings.certified_minimum_angle * M_PI / 180);
  start->setLengthFactor(settings.length_factor);
  start->setUseCertificates(!settings.plain);
  return start;
}

/** What is known about the outer side, in the frame that is worked in. */
pcl::ccaa::SideHints
localHints(const ReconstructSettings& settings, const Model& model)
{
  return relativeTo(model.shift.offset(), sidesOf(settings.sides, model.viewpoint));
}

/** Where the sensor of an organised cloud stood, if that is known or likely. */
std::optional<Eigen::Vector3d>
sensorOfGrid(const ReconstructSettings& settings, const Model& model)
{
  if (model.mesh.cloud.height < 2 || model.mesh.cloud.width < 2)
    return std::nullopt;
  pcl::ccaa::SideHints hints = localHints(settings, model);
  takeOrigin(
      hints,
      pcl::ccaa::positionView(model.mesh.cloud).relativeTo(model.shift.offset()));
  return hints.told_viewpoint ? hints.told_viewpoint : hints.viewpoint;
}

/** Begin with the grid of an organised cloud where that is asked for, or leaves at most
 * half as many islands: cameras whose steps of depth are wider than their pixels make
 * clouds in which the nearest points lie on strips. */
template <typename PointT>
void
takeGrid(const ReconstructSettings& settings,
         const pcl::UmbrellaFilter& filter,
         pcl::ConsecutiveReconstruction<PointT>& chain,
         ReconstructResult& result)
{
  const auto sensor = sensorOfGrid(settings, result.model);
  if (settings.start == "grid" && !sensor)
    throw Failure("--start grid needs an organised cloud (PCD with a height, or PLY as "
                  "PCL writes it) and the place of the sensor (--viewpoint)");
  if (!sensor || settings.start == "greedy" || !settings.hasFilter())
    return;
  const auto greedy = chain.getStartAlgorithms().front();
  const auto grid = makeGridStart<PointT>(*sensor);
  if (settings.start != "grid") {
    const std::size_t by_grid = islandsAfter<PointT>(grid, filter, chain);
    if (by_grid > islandsAfter<PointT>(greedy, filter, chain) / 2)
      return; // with the greedy one set
  }
  chain.setStartAlgorithm(grid);
  result.has_grid_start = true;
}

template <typename PointT>
void
reconstruct(const ReconstructSettings& settings,
            const pcl::ccaa::ProgressCallback& progress,
            ReconstructResult& result)
{
  const auto start = makeStart<PointT>(settings);
  const auto filter = std::make_shared<pcl::UmbrellaFilter>();
  filter->setMinimumInternalPoints(settings.minimum_internal_points);
  pcl::ConsecutiveReconstruction<PointT> chain;
  chain.setStartAlgorithm(start);
  chain.setFilter(settings.hasFilter() ? filter : nullptr);
  if (settings.until != "base")
    chain.setBaseAlgorithm(nullptr);
  pcl::ccaa::SideHints hints = localHints(settings, result.model);
  hints.guess_plane = true;
  chain.setSideHints(hints);
  chain.setComputeNormals(settings.normals);
  chain.setNumberOfThreads(settings.threads);
  chain.setProgressCallback(progress);
  chain.setInputCloud(toTypedCloud<PointT>(result.model));
  takeGrid(settings, *filter, chain, result);
  if (settings.measure_speedup)
    result.speedup = chain.measureSpeedup();
  chain.reconstruct(result.model.mesh.polygons);
  result.start = start->getReport();
  result.filter = filter->getReport();
  result.chain = chain.getReport();
  if (result.has_grid_start) {
    result.start = {};
    result.start.points = result.chain.points - result.chain.skipped_points;
    result.start.greedy_seconds = result.chain.start_seconds;
  }
  result.labels = chain.getTriangleLabels();
  result.normals = chain.getNormals();
  result.sides = chain.getSideTally();
}

/** Of a mesh of triangles whose corners are points. */
pcl::ccaa::SurfaceTopology
topologyOf(const std::vector<pcl::Vertices>& triangles,
           std::size_t point_count,
           int threads)
{
  const pcl::ccaa::Triangles indexed = pcl::ccaa::fanTriangles(triangles);
  pcl::ccaa::TriangleAdjacency adjacency;
  adjacency.build(indexed, point_count, threads);
  return pcl::ccaa::topologyOf(indexed, adjacency);
}

/** Note from where the surface is seen, as far as the user has told it or the origin
 * was taken for it: it goes into files with the rest. */
void
noteViewpoint(const pcl::ccaa::SideHints& told,
              const pcl::ccaa::SideTally& tally,
              Viewpoint& viewpoint)
{
  viewpoint.is_origin = tally[pcl::ccaa::OutwardRule::ORIGIN] > 0;
  if (!told.told_viewpoint)
    return;
  viewpoint.known = true;
  viewpoint.position = *told.told_viewpoint;
}

} // namespace

pcl::ccaa::SideHints
sidesForRepair(pcl::ccaa::SideHints told, const pcl::ccaa::SideTally& found)
{
  if (found.guessed_axis < 0)
    return told;
  told.up = Eigen::Vector3d::Unit(found.guessed_axis);
  told.up_is_guessed = true;
  return told;
}

StageTimes
stageTimes(const ReconstructSettings& settings, const ReconstructResult& result)
{
  const pcl::ConsecutiveReport& chain = result.chain;
  const double greedy = std::min(result.start.greedy_seconds, chain.start_seconds);
  StageTimes stages = {{"search", chain.start_seconds - greedy}, {"start", greedy}};
  double sum = chain.start_seconds;
  if (settings.hasFilter()) {
    stages.emplace_back("filter", chain.filter_seconds);
    sum += chain.filter_seconds;
  }
  if (settings.until == "base") {
    stages.emplace_back("base", chain.base_seconds);
    sum += chain.base_seconds;
  }
  stages.emplace_back("joining", std::max(0.0, chain.total_seconds - sum));
  return stages;
}

void
cleanInput(const ReconstructSettings& settings,
           ProgressBar& bar,
           ReconstructResult& result)
{
  Stopwatch watch;
  result.cleaning = cleanCloud(
      settings.cleaning,
      settings.threads,
      [&](double share) { return bar.show("cleaning", share); },
      result.model);
  if (result.cleaning->output_points == 0)
    result.model.warnings.push_back(
        "the cloud has too few points to be cleaned; it was taken as it is");
  if (result.cleaning->in_two_sheets > 0)
    result.model.warnings.push_back(
        pluralIs(result.cleaning->in_two_sheets, "point") +
        " part of two sheets closer than the radius of --clean and not smoothed");
  if (const CleanReport& done = *result.cleaning; done.moved_together > 0)
    result.model.warnings.push_back(
        plural(done.moved_together, "point") +
        (done.moved_together == 1 ? " was" : " were") +
        " moved by --clean together with those around (one at " +
        placeIn(result.model.mesh.cloud, done.moved_at) +
        "): what is thin there may be gone or closed, so look; a lower --clean-radius "
        "moves less");
  result.stages.emplace_back("cleaning", watch.lap());
}

/** Wires beside each other look the same. */
void
noteLines(ReconstructResult& result)
{
  if (result.start.line_gap > 0.0)
    result.model.warnings.push_back(
        "the points lie in lines, the next " +
        formatted("%.1f", result.start.line_gap) +
        " spacings away: these were taken for a scanner's, and joined");
}

void
runReconstruction(const ReconstructSettings& settings,
                  const pcl::ccaa::ProgressCallback& progress,
                  ReconstructResult& result)
{
  const Model& model = result.model;
  if (!pcl::ccaa::normalView(model.mesh.cloud).empty())
    reconstruct<pcl::PointNormal>(settings, progress, result);
  else if (!pcl::ccaa::viewpointView(model.mesh.cloud).empty())
    reconstruct<pcl::PointWithViewpoint>(settings, progress, result);
  else
    reconstruct<pcl::PointXYZ>(settings, progress, result);
  if (!result.chain.cancelled && result.chain.points == 0)
    throw Failure("the reconstruction failed, perhaps for lack of memory");
  const StageTimes stages = stageTimes(settings, result);
  result.stages.insert(result.stages.end(), stages.begin(), stages.end());
  noteViewpoint(settings.sides, result.sides, result.model.viewpoint);
  noteLines(result);
}

void
countTopology(const ReconstructSettings& settings, ReconstructResult& result)
{
  if (settings.hasFilter())
    result.topology = topologyOf(result.model.mesh.polygons,
                                 pointCount(result.model.mesh.cloud),
                                 pcl::ccaa::resolveThreads(settings.threads));
}

void
repairResult(const ReconstructSettings& settings,
             ProgressBar& bar,
             ReconstructResult& result)
{
  if (result.model.mesh.polygons.empty())
    return;
  RepairTask task;
  task.method = settings.method;
  task.threads = settings.threads;
  task.method.survey.orientation.sides = sidesForRepair(settings.sides, result.sides);
  pcl::RepairReport report;
  repairMesh(task, result.model.viewpoint, bar, result.model.mesh, report);
  if (report.cancelled)
    return;
  result.labels.resize(report.input_triangles, REPAIR_LABEL);
  result.labels.resize(report.origins.size(), REPAIR_LABEL);
  result.stages.emplace_back("repair", totalSeconds(report.seconds));
  result.topology = report.after;
  result.repair = std::move(report);
}

void
addNormals(ReconstructResult& result)
{
  if (!result.normals)
    return;
  if (appendNormals(*result.normals, result.model.mesh.cloud))
    return;
  result.model.warnings.push_back(
      "the cloud has normals already; they were kept, and none were computed");
}

} // namespace app
