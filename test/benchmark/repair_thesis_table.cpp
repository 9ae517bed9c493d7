// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: table T4.8-1 of the thesis on today's data.
#include <pcl/surface_ccaa/consecutive_reconstruction.h>

#include <Eigen/Geometry>

#include "input_clouds.h"
#include "mesh/polygon_access.h"
#include "mesh/surface_topology.h"
#include "repair_time_table.h"
#include "repair_trial.h"
#include "support/completion_shapes.h"
#include "survey/model_survey.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <ostream>

namespace bench {
namespace {

using namespace pcl::ccaa::test;
using pcl::ccaa::Position;

/** \brief Whether a place, in shares of the box, is in what is taken away. */
using IsLost = std::function<bool(const Position&)>;

struct ThesisCase {
  const char* name;
  const char* file;
  IsLost is_lost;
  double falloff_exponent; /**< chi */
  double interpolation;    /**< k_i */
  bool by_start;           /**< mesh made by start and filter, not that of the file */
};

bool
inBall(const Position& place, const Position& middle, double radius)
{
  return (place - middle).norm() < radius;
}

/** \brief In the spirit of the figures F4.8-1 to 4: holes; long ones; the front of a
 * body; slabs that leave islands. */
std::vector<ThesisCase>
thesisCases()
{
  const auto holes = [](const Position& p) {
    return inBall(p, {0.3, 0.5, 0.9}, 0.12) || inBall(p, {0.8, 0.3, 0.5}, 0.1) ||
           inBall(p, {0.25, 0.75, 0.5}, 0.1) || inBall(p, {0.6, 0.4, 0.05}, 0.12);
  };
  const auto long_holes = [](const Position& p) {
    return (std::abs(p.y() - 0.3) < 0.04 && p.z() > 0.35) ||
           (std::abs(p.x() - 0.55) < 0.04 && p.y() > 0.1 && p.y() < 0.5);
  };
  const auto front = [](const Position& p) {
    const auto near = [&](double x, double y, double radius) {
      return std::hypot(p.x() - x, p.y() - y) < radius && p.z() > 0.35;
    };
    return near(0.5, 0.76, 0.07) || near(0.5, 0.6, 0.06) || near(0.56, 0.4, 0.04) ||
           near(0.44, 0.4, 0.04) || near(0.5, 0.95, 0.03);
  };
  const auto slabs = [](const Position& p) {
    return std::abs(p.y() - 0.33) < 0.03 || std::abs(p.y() - 0.66) < 0.03 ||
           std::abs(p.x() - 0.5) < 0.03;
  };
  const char* bunny = "bunny/bun_zipper.ply";
  return {{"Bunny-1", bunny, holes, 2.5, 0.0, true},
          {"Bunny-2", bunny, long_holes, 2.5, 0.0, true},
          {"Woman-1", "woman/human_woman.ply", front, 1.7, 1.0, false},
          {"Bunny-3", bunny, slabs, 2.5, 0.0, true}};
}

PieceOf
keptPlaces(const Shape& shape, const IsLost& is_lost)
{
  Eigen::AlignedBox3d box;
  for (const Position& position : shape.vertices)
    box.extend(position);
  return [box, is_lost](const Position& p) {
    return is_lost((p - box.min()).cwiseQuotient(box.sizes())) ? -1 : 0;
  };
}

/** \brief The triangles that start and filter make of the points: an ICADM. */
Shape
startedMesh(const Shape& points)
{
  auto cloud = pcl::make_shared<Cloud>();
  for (const Position& position : points.vertices) {
    cloud->emplace_back();
    cloud->back().getVector3fMap() = position.cast<float>();
  }
  pcl::ConsecutiveReconstruction<pcl::PointXYZ> chain;
  chain.setBaseAlgorithm(nullptr);
  chain.setInputCloud(cloud);
  chain.setNumberOfThreads(1);
  pcl::PolygonMesh mesh;
  chain.reconstruct(mesh);
  return {points.vertices, pcl::ccaa::fanTriangles(mesh.polygons)};
}

std::size_t
boundaryPoints(const pcl::RepairReport& report)
{
  std::size_t points = 0;
  for (const auto& loop : report.loops)
    points += loop.edges;
  return points;
}

std::size_t
bridgePoints(const pcl::RepairReport& report)
{
  std::size_t points = 0;
  for (const auto& bridge : report.bridges)
    points += bridge.points.size() - std::min<std::size_t>(bridge.points.size(), 2);
  return points;
}

void
printRow(std::ostream& out, const ThesisCase& tried, bool full, std::size_t repeats)
{
  const Shape whole = readShared(tried.file);
  const PieceOf kept_places = keptPlaces(whole, tried.is_lost);
  const Shape kept = inPieces(whole, kept_places);
  const Shape damaged = tried.by_start ? startedMesh(kept) : kept;
  TrialSettings settings;
  settings.repeats = repeats;
  auto& field = settings.parameters.survey.field;
  field.mode = full ? pcl::repair::FieldMode::FULL : pcl::repair::FieldMode::LIGHT;
  field.falloff_exponent = tried.falloff_exponent;
  field.interpolation = tried.interpolation;
  const RepairTrial trial = runTrial(damaged, settings);
  const Shape lost = lostPart(whole, inPieces(whole, kept_places, true).triangles);
  const Topology found = topologyOf(trial.result.triangles);
  const std::size_t crossings =
      countIntersections(trial.result) - countIntersections(roundedToFloat(damaged));
  out << "  " << std::left << std::setw(9) << tried.name << std::setw(6)
      << (full ? "full" : "light") << std::right << "ICM"
      << static_cast<int>(trial.report.class_before) + 1 << std::setw(8)
      << boundaryPoints(trial.report) << std::setw(8) << bridgePoints(trial.report)
      << std::setprecision(3) << std::setw(9) << trial.seconds << std::setw(11)
      << crossings << std::setw(6) << found.components << std::setw(6)
      << found.characteristic << std::setw(9) << found.borders << std::setw(11)
      << trial.report.shortfalls << std::setprecision(4) << std::setw(10)
      << meanDistance(lost, trial.result, diagonalOf(whole)) << std::endl;
}

} // namespace

void
printThesisTable(std::ostream& out, std::size_t repeats)
{
  out << "T4.8-1, one thread; error: mean distance of the lost surface to the result "
         "in "
         "% of the diagonal\n"
         "  ICADM    mode  class   N_bnd   N_bdg        s  crossings parts   chi  "
         "borders  left open     error\n"
      << std::fixed;
  for (const ThesisCase& tried : thesisCases())
    for (const bool full : {false, true})
      printRow(out, tried, full, repeats);
}

} // namespace bench
