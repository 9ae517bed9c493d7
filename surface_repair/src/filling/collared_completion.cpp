// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the base algorithm within a hole of which only the rim is
// known.

#include "filling/collared_completion.h"

#include <pcl/surface_ccaa/impl/cloud_runs.h>

#include "filling/local_floats.h"
#include "run/run_control.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace pcl::repair {

namespace {

/** Width of the collar by the length of its edge: that of an equilateral triangle. */
constexpr double COLLAR_WIDTH = 0.8660254037844386;
/** Operations of one of its stages for each point. */
constexpr double STAGE_WORK = 300.0;

/** The rim of the surface around the hole, made up from its normals: on each edge of
 * the polygon a triangle, and one between two of these at each of its points. */
class Collar {
public:
  explicit Collar(const BoundaryCurve& polygon) : polygon_(polygon) {}

  Positions
  outerPoints() const
  {
    Positions points;
    for (std::size_t k = 0; k < polygon_.size(); ++k) {
      const Eigen::Vector3d edge = polygon_.edge(k);
      Direction normal = polygon_.normals[k];
      if (!normal.allFinite())
        normal = edge.unitOrthogonal();
      // Away from the missing area: against the conormal m = tau x n.
      const Direction outward = normal.cross(edge).normalized();
      points.push_back(polygon_.points[k] + 0.5 * edge +
                       COLLAR_WIDTH * edge.norm() * outward);
    }
    return points;
  }

  Triangles
  triangles() const
  {
    Triangles triangles;
    const auto n = static_cast<pcl::index_t>(polygon_.size());
    for (pcl::index_t k = 0; k < n; ++k) {
      const auto next =
          static_cast<pcl::index_t>(polygon_.next(static_cast<std::size_t>(k)));
      triangles.push_back({k, next, n + k});
      triangles.push_back({n + k, next, n + next});
    }
    return triangles;
  }

private:
  const BoundaryCurve& polygon_;
};

std::vector<pcl::Vertices>
toPolygons(const Triangles& triangles)
{
  std::vector<pcl::Vertices> polygons(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    polygons[i].vertices.assign(triangles[i].begin(), triangles[i].end());
  return polygons;
}

/** Whether the first triangle of the collar, which runs from point 0 to point 1, has
 * been turned. */
bool
isTurned(const pcl::Vertices& first)
{
  for (std::size_t i = 0; i < 3; ++i)
    if (first.vertices[i] == 1 && first.vertices[(i + 1) % 3] == 0)
      return true;
  return false;
}

/** The new triangles of the output without those that touch the collar's outer points.
 */
Triangles
insideOf(const std::vector<pcl::Vertices>& polygons, pcl::index_t points_of_polygon)
{
  Triangles inside;
  const pcl::index_t collar_end = 2 * points_of_polygon;
  const auto collar_size = static_cast<std::size_t>(collar_end);
  for (std::size_t i = collar_size; i < polygons.size(); ++i) {
    Triangle triangle{};
    std::copy_n(polygons[i].vertices.begin(), 3, triangle.begin());
    if (std::any_of(triangle.begin(), triangle.end(), [&](pcl::index_t corner) {
          return corner >= points_of_polygon && corner < collar_end;
        }))
      continue;
    for (pcl::index_t& corner : triangle)
      corner -= corner >= collar_end ? points_of_polygon : 0;
    if (isTurned(polygons.front()))
      std::swap(triangle[0], triangle[1]);
    inside.push_back(triangle);
  }
  return inside;
}

/** Tells the work of a completion of so many points while that goes on. */
ccaa::ProgressCallback
spendingFor(std::size_t points, ccaa::RunControl& control)
{
  const double work = STAGE_WORK * static_cast<double>(points);
  return [work, &control, last = 0.0](const std::string&, double done) mutable {
    const double more = std::max(0.0, done - std::exchange(last, done));
    return control.spend(static_cast<std::uint64_t>(work * more));
  };
}

} // namespace

Triangles
completeWithin(const FillingTask& task, const std::vector<std::size_t>& samples)
{
  const Collar collar(task.polygon);
  const std::size_t n = task.polygon.size();
  Positions points = task.polygon.points;
  const Positions outer = collar.outerPoints();
  points.insert(points.end(), outer.begin(), outer.end());
  for (const std::size_t i : samples)
    points.push_back(task.free_points[i]);
  const auto floats = localFloats(points);
  pcl::PolygonMesh given;
  given.polygons = toPolygons(collar.triangles());
  const auto all = std::make_shared<pcl::Indices>(points.size());
  std::iota(all->begin(), all->end(), 0);
  ccaa::CompletionInput input;
  input.points = {floats.front().data(), 3, floats.size()};
  input.selection = all;
  input.threads = 1;
  input.partial_mesh = &given;
  if (task.control != nullptr)
    input.progress = spendingFor(points.size(), *task.control);
  ccaa::CompletionReport report;
  const ccaa::CompletionOutput output = ccaa::runCompletion(input, {}, report);
  if (output.polygons.size() < given.polygons.size())
    return {};
  return insideOf(output.polygons, static_cast<pcl::index_t>(n));
}

} // namespace pcl::repair
