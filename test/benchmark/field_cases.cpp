// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what the speed of the indicator field is measured on.
#include <pcl/io/ply_io.h>
#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "boundary/extraction.h"
#include "field/reach.h"
#include "field/source_sampling.h"
#include "field_speed.h"
#include "icadm/model_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace bench {
namespace {

using namespace pcl::repair;
using Points = pcl::PointCloud<pcl::PointXYZ>;

/** \brief Slabs taken away, as shares of the height. */
constexpr std::array<std::array<double, 2>, 3> SLABS = {
    {{0.27, 0.34}, {0.52, 0.59}, {0.75, 0.80}}};

/** \brief Boundaries with fewer edges are small holes of the scan. */
constexpr std::size_t FEWEST_EDGES = 40;

BoundaryCurve
ring(double height, double sign)
{
  BoundaryCurve curve;
  constexpr int EDGES = 1000;
  for (int k = 0; k < EDGES; ++k) {
    const double angle = sign * 2.0 * M_PI * k / EDGES;
    curve.points.emplace_back(std::cos(angle), std::sin(angle), height);
    curve.normals.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  return curve;
}

std::vector<bool>
pointsInSlabs(const Points& points)
{
  float low = std::numeric_limits<float>::max(), high = -low;
  for (const pcl::PointXYZ& point : points) {
    low = std::min(low, point.y);
    high = std::max(high, point.y);
  }
  std::vector<bool> inside;
  for (const pcl::PointXYZ& point : points) {
    const double share = (point.y - low) / (high - low);
    inside.push_back(std::any_of(SLABS.begin(), SLABS.end(), [&](const auto& slab) {
      return share > slab[0] && share < slab[1];
    }));
  }
  return inside;
}

/** \brief Take away the triangles in the slabs, and most of their points. */
void
cut(pcl::PolygonMesh& mesh, Points& points, std::size_t keep_every)
{
  const std::vector<bool> inside = pointsInSlabs(points);
  const auto isInside = [&](pcl::index_t i) {
    return inside[static_cast<std::size_t>(i)];
  };
  mesh.polygons.erase(std::remove_if(mesh.polygons.begin(),
                                     mesh.polygons.end(),
                                     [&](const pcl::Vertices& polygon) {
                                       return std::any_of(polygon.vertices.begin(),
                                                          polygon.vertices.end(),
                                                          isInside);
                                     }),
                      mesh.polygons.end());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (inside[i] && i % keep_every != 0)
      points[i].x = std::numeric_limits<float>::quiet_NaN();
  points.is_dense = false;
  pcl::toPCLPointCloud2(points, mesh.cloud);
}

SourceSet
sourcesOf(const IncompleteModel& model)
{
  BoundaryLoops loops = extractBoundaries(model);
  loops.erase(std::remove_if(loops.begin(),
                             loops.end(),
                             [](const BoundaryLoop& loop) {
                               return loop.curve.size() < FEWEST_EDGES;
                             }),
              loops.end());
  std::vector<SourceCurve> curves;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    curves.push_back(sampleSources(loops[k].curve));
    curves.back().island = loops[k].island;
    curves.back().loop = k;
  }
  return gatherSources(std::move(curves));
}

} // namespace

FieldCase
facingRings()
{
  FieldCase rings;
  rings.name = "two rings";
  std::vector<SourceCurve> curves = {sampleSources(ring(0.1, 1.0)),
                                     sampleSources(ring(-0.1, -1.0))};
  curves[0].island = 0;
  curves[1].island = 1;
  rings.sources = gatherSources(std::move(curves));
  rings.gap = 0.2;
  rings.reach = DEFAULT_ROOM * rings.gap;
  return rings;
}

FieldCase
slabbedMesh(const std::string& path, std::size_t keep_every)
{
  FieldCase slabbed;
  slabbed.name = path.substr(path.find_last_of('/') + 1) + " in slabs";
  const pcl::PolygonMesh::Ptr mesh(new pcl::PolygonMesh);
  if (pcl::PLYReader().read(path, *mesh) != 0)
    return slabbed;
  Points points;
  pcl::fromPCLPointCloud2(mesh->cloud, points);
  cut(*mesh, points, keep_every);
  slabbed.model = readModel(mesh, nullptr, {}).model;
  slabbed.sources = sourcesOf(slabbed.model);
  Eigen::AlignedBox3d box;
  for (const Position& position : slabbed.model.positions)
    box.extend(position);
  slabbed.gap = box.isEmpty() ? 0.0 : (SLABS[0][1] - SLABS[0][0]) * box.sizes().y();
  slabbed.reach = DEFAULT_ROOM * slabbed.gap;
  return slabbed;
}

} // namespace bench
