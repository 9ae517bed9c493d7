// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: from any polygon mesh to an incomplete model.
#include "icadm/model_reading.h"

#include <pcl/surface_ccaa/global_shift.h>

#include "icadm/manifold_reading.h"
#include "icadm/model_assembly.h"
#include "mesh/cloud_access.h"
#include "mesh/corners.h"
#include "mesh/polygon_access.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl::repair {
namespace {

constexpr const char* CANCELLED = "the run was cancelled";
/** The adjacency counts edge ends, three to a triangle, in 32 bits. */
constexpr std::size_t MAXIMUM_TRIANGLES = std::numeric_limits<std::uint32_t>::max() / 3;

/** \brief Why nothing can be read; empty: something can. */
std::string
problemOf(const pcl::PCLPointCloud2* cloud, const pcl::PCLPointCloud2* free_points)
{
  if (cloud == nullptr)
    return "there is no mesh";
  if (ccaa::pointCount(*cloud) == 0)
    return "the cloud of the mesh has no points";
  const auto problem = ccaa::checkCloud(*cloud);
  if (problem != ccaa::CloudProblem::NONE)
    return ccaa::describe(problem);
  if (free_points == nullptr || ccaa::pointCount(*free_points) == 0)
    return {};
  const auto free_problem = ccaa::checkCloud(*free_points);
  if (free_problem != ccaa::CloudProblem::NONE)
    return std::string("free points: ") + ccaa::describe(free_problem);
  return {};
}

bool
isBefore(const Position& a, const Position& b)
{
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/** \brief For each point whether one of the places is the same. */
std::vector<bool>
areAt(const Positions& places, const Positions& points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return isBefore(points[a], points[b]);
  });
  std::vector<bool> found(points.size(), false);
  for (const Position& place : places) {
    auto at = std::lower_bound(
        order.begin(), order.end(), place, [&](std::size_t i, const Position& p) {
          return isBefore(points[i], p);
        });
    for (; at != order.end() && points[*at] == place; ++at)
      found[*at] = true;
  }
  return found;
}

/** \brief A surface that a place sees edge-on all over was not measured from there. */
bool
isSeenEdgeOn(const IncompleteModel& model, const Position& place)
{
  double shown = 0.0, all = 0.0;
  for (const Triangle& triangle : model.triangles) {
    const ccaa::Corners corners = ccaa::cornersOf(triangle, model.positions);
    const Eigen::Vector3d area = ccaa::areaNormal(corners);
    shown += std::abs(area.dot((corners[0] - place).normalized()));
    all += area.norm();
  }
  return !(shown >= ccaa::LEAST_MEAN_COSINE * all);
}

/** \brief The viewpoint that is told, or, where vertices have none of their own, that
 * of the whole or the origin. */
void
placeViewpoints(ccaa::SideHints sides, IncompleteModel& model)
{
  using ccaa::OutwardRule;
  const auto place = [&](const Position& viewpoint, OutwardRule rule) {
    model.viewpoints.assign(model.positions.size(), viewpoint);
    model.viewpoints_by = rule;
  };
  if (sides.told_viewpoint)
    place(*sides.told_viewpoint, OutwardRule::TOLD_VIEWPOINT);
  if (!model.viewpoints.empty())
    return;
  ccaa::takeOrigin(sides, model.positions);
  if (!sides.viewpoint)
    return;
  if (!sides.viewpoint_is_origin)
    place(*sides.viewpoint, OutwardRule::VIEWPOINT);
  else if (!isSeenEdgeOn(model, *sides.viewpoint))
    place(*sides.viewpoint, OutwardRule::ORIGIN);
}

/** \brief One run of readModel(). */
class Reading {
public:
  Reading(const ccaa::MeshView& mesh,
          const ccaa::SideHints& sides,
          const ccaa::LoopContext& context)
  : mesh_(mesh)
  , shift_(GlobalShift::of(*mesh.cloud).offset())
  , points_(ccaa::positionView(*mesh.cloud).relativeTo(shift_))
  , sides_(ccaa::relativeTo(shift_, sides))
  , context_(context)
  {
    result_.report.global_shift = shift_;
  }

  ReadModel
  run(const pcl::PCLPointCloud2* free_points)
  {
    readTriangles();
    if (result_.report.problem.empty())
      bringToManifold();
    if (result_.report.problem.empty())
      assemble();
    if (context_.cancelled())
      result_.report.problem = CANCELLED;
    if (!result_.report.problem.empty()) {
      result_.model = IncompleteModel();
      return std::move(result_);
    }
    listUnusedPoints();
    if (free_points != nullptr)
      listSeparatePoints(*free_points);
    leaveOutPointsOnVertices();
    return std::move(result_);
  }

private:
  void
  readTriangles()
  {
    result_.report.input_polygons = mesh_.polygons.size();
    input_ = ccaa::readPolygons(mesh_.polygons, points_, context_);
    result_.report.invalid_polygons = input_.invalid_polygons;
    if (mesh_.polygons.empty())
      result_.report.problem = "the mesh has no polygons";
    else if (input_.triangles.empty())
      result_.report.problem = "the mesh has no valid polygon";
    else if (input_.triangles.size() > MAXIMUM_TRIANGLES)
      result_.report.problem = "the mesh has more triangles than can be numbered";
  }

  void
  bringToManifold()
  {
    adjacency_.build(input_.triangles,
                     input_.point_of_vertex.size(),
                     context_.threads,
                     context_.control);
    if (!context_.cancelled())
      repair::bringToManifold(
          input_, adjacency_, *mesh_.cloud, context_, result_.report);
  }

  void
  assemble()
  {
    IncompleteModel& model = result_.model;
    model = assembleModel(std::move(input_.triangles),
                          entriesOf(points_, input_.point_of_vertex),
                          std::move(adjacency_),
                          context_);
    model.point_of_vertex = std::move(input_.point_of_vertex);
    model.given_normals =
        entriesOf(ccaa::normalView(*mesh_.cloud), model.point_of_vertex);
    model.viewpoints = entriesOf(ccaa::viewpointView(*mesh_.cloud).relativeTo(shift_),
                                 model.point_of_vertex);
    placeViewpoints(sides_, model);
  }

  /** \brief Points of the mesh's cloud that carry no triangle. */
  void
  listUnusedPoints()
  {
    std::vector<std::uint8_t> used(points_.size(), 0);
    for (const pcl::index_t point_index : result_.model.point_of_vertex)
      used[static_cast<std::size_t>(point_index)] = 1;
    for (std::size_t i = 0; i < points_.size(); ++i)
      if (used[i] == 0)
        addFreePoint(points_[i], static_cast<pcl::index_t>(i));
  }

  void
  listSeparatePoints(const pcl::PCLPointCloud2& free_points)
  {
    const ccaa::PointView view = ccaa::positionView(free_points).relativeTo(shift_);
    for (std::size_t i = 0; i < view.size(); ++i)
      addFreePoint(view[i], pcl::UNAVAILABLE);
  }

  void
  addFreePoint(const Position& position, pcl::index_t point_index)
  {
    if (!position.allFinite()) {
      ++result_.report.non_finite_points;
      return;
    }
    result_.model.free_points.push_back(position);
    result_.model.point_of_free_point.push_back(point_index);
  }

  /** \brief A point where a vertex is says nothing that the surface does not say, and
   * would only hold on to it: the whole cloud may be given as free points. */
  void
  leaveOutPointsOnVertices()
  {
    IncompleteModel& model = result_.model;
    if (model.free_points.empty())
      return;
    const std::vector<bool> on_vertex = areAt(model.positions, model.free_points);
    std::size_t left = 0;
    for (std::size_t i = 0; i < on_vertex.size(); ++i) {
      if (on_vertex[i])
        continue;
      model.free_points[left] = Position(model.free_points[i]);
      model.point_of_free_point[left++] = model.point_of_free_point[i];
    }
    result_.report.points_on_vertices = model.free_points.size() - left;
    model.free_points.resize(left);
    model.point_of_free_point.resize(left);
  }

  const ccaa::MeshView& mesh_;
  Eigen::Vector3d shift_;
  ccaa::PointView points_;
  ccaa::SideHints sides_;
  const ccaa::LoopContext& context_;
  ccaa::PolygonTriangles input_;
  ccaa::TriangleAdjacency adjacency_; /**< of the input */
  ReadModel result_;
};

} // namespace

ReadModel
readModel(const ccaa::MeshView& mesh,
          const pcl::PCLPointCloud2* free_points,
          const ccaa::LoopContext& context,
          const ccaa::SideHints& sides)
{
  const std::string problem = problemOf(mesh.cloud, free_points);
  if (problem.empty())
    return Reading(mesh, sides, context).run(free_points);
  ReadModel nothing;
  nothing.report.problem = problem;
  return nothing;
}

} // namespace pcl::repair
