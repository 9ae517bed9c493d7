// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: between the clouds and polygons of PCL and the base
// algorithm.
#include <pcl/surface_ccaa/impl/cloud_runs.h>
#include <pcl/surface_ccaa/impl/point_blocks.h>

#include "advancing_front/surface_completion.h"
#include "mesh/cloud_access.h"
#include "mesh/curve_order.h"
#include "mesh/polygon_access.h"
#include "mesh/vertex_adjacency.h"
#include "run/stage_clock.h"
#include "search/tree_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

namespace pcl::ccaa {
namespace {

std::vector<Eigen::Vector3f>
gather(const PointArray& array, const std::vector<index_t>& indices)
{
  std::vector<Eigen::Vector3f> gathered(array.size == 0 ? 0 : indices.size());
  for (std::size_t i = 0; i < gathered.size(); ++i)
    gathered[i] = Eigen::Vector3f(array[indices[i]]);
  return gathered;
}

bool
hasDirection(const std::vector<Eigen::Vector3f>& normals)
{
  return std::any_of(normals.begin(), normals.end(), [](const auto& normal) {
    return normal.allFinite() && !normal.isZero();
  });
}

const char*
describe(PartialMeshFault fault)
{
  switch (fault) {
  case PartialMeshFault::NON_MANIFOLD_EDGE:
    return "the partial mesh has an edge with more than two triangles, or a triangle "
           "twice";
  case PartialMeshFault::NON_MANIFOLD_VERTEX:
    return "the partial mesh has a point with more than one fan of triangles";
  case PartialMeshFault::BADLY_ORIENTED:
    return "the partial mesh has neighboring triangles that are wound differently";
  default:
    return "";
  }
}

/** One run: the vertices are the points of the given triangles, then the free points.
 */
class PolygonCompletion {
public:
  PolygonCompletion(const CompletionInput& input,
                    const CompletionParameters& parameters,
                    RunControl& control)
  : input_(input)
  , parameters_(parameters)
  , context_{resolveThreads(input.threads), &control, "partial mesh"}
  , control_(control)
  {}

  CompletionOutput
  run(CompletionReport& report);

private:
  bool
  readGiven(CompletionOutput& output);
  void
  addFreePoints();
  Indices
  withoutUsedPlaces(const Indices& free) const;
  std::vector<std::uint8_t>
  cutFlags() const;
  void
  tellInCloud(TopologyDoubts& doubts) const;
  PointArray
  vertexArray() const;
  bool
  searchOpen(std::vector<index_t>& open, unsigned int k, std::vector<index_t>& table);
  bool
  searchBlocks(std::vector<index_t>& open, unsigned int k, std::vector<index_t>& table);

  const CompletionInput& input_;
  const CompletionParameters& parameters_;
  LoopContext context_;
  RunControl& control_;
  PolygonTriangles given_;
  std::vector<Eigen::Vector3f> coordinates_; /**< by vertex */
};

CompletionOutput
PolygonCompletion::run(CompletionReport& report)
{
  CompletionOutput output;
  if (!readGiven(output))
    return output;
  addFreePoints();
  if (given_.point_of_vertex.size() < 3) {
    output.error = std::to_string(given_.point_of_vertex.size()) +
                   " usable points, at least 3 are needed";
    return output;
  }
  coordinates_ = gather(input_.points, given_.point_of_vertex);
  const auto normals = gather(input_.normals, given_.point_of_vertex);
  const auto viewpoints = gather(input_.viewpoints, given_.point_of_vertex);
  PartialMesh mesh;
  mesh.points = coordinates_;
  if (hasDirection(normals))
    mesh.normals = normals;
  mesh.viewpoints = viewpoints;
  mesh.sides = input_.sides;
  mesh.is_cut = cutFlags();
  mesh.given = std::move(given_.triangles);
  if (input_.handoff != nullptr && input_.handoff->adjacency != nullptr)
    mesh.adjacency =
        adjacencyFor(given_.point_of_vertex,
                     std::move(*std::exchange(input_.handoff->adjacency, {})),
                     input_.points.size,
                     context_.threads);
  CompletedMesh completed = completeSurface(
      std::move(mesh),
      [this](auto& open, auto k, auto& table) { return searchOpen(open, k, table); },
      parameters_,
      context_.threads,
      control_,
      report);
  if (completed.fault != PartialMeshFault::NONE)
    output.error = describe(completed.fault);
  if (control_.cancelled() || !output.error.empty())
    return output;
  handOut(std::move(completed.triangles),
          given_.point_of_vertex,
          LoopContext{context_.threads, &control_, "polygons"},
          input_.handoff,
          output.polygons);
  output.kept = std::move(completed.kept);
  tellInCloud(report.doubts);
  return output;
}

/** By points of the cloud and no longer by vertices. */
void
PolygonCompletion::tellInCloud(TopologyDoubts& doubts) const
{
  const auto number = [&](index_t& vertex) {
    vertex = given_.point_of_vertex[static_cast<std::size_t>(vertex)];
  };
  for (Indices* const points : {&doubts.thin_handles, &doubts.thin_necks}) {
    std::for_each(points->begin(), points->end(), number);
    std::sort(points->begin(), points->end());
  }
  for (auto& contact : doubts.touching_pieces)
    std::for_each(contact.begin(), contact.end(), number);
  std::sort(doubts.touching_pieces.begin(), doubts.touching_pieces.end());
}

bool
PolygonCompletion::readGiven(CompletionOutput& output)
{
  PolygonView given;
  if (input_.handoff != nullptr && input_.handoff->given != nullptr)
    given = viewOf(*input_.handoff->given);
  else if (input_.partial_mesh != nullptr)
    given = input_.partial_mesh->polygons;
  if (given.empty())
    return true;
  given_ = readPolygons(given, viewOf(input_.points), context_);
  if (control_.cancelled())
    return false;
  if (given_.invalid_polygons > 0)
    output.error = std::to_string(given_.invalid_polygons) +
                   " polygons of the partial mesh have a corner that is no point of "
                   "the cloud, not finite or there twice";
  return output.error.empty();
}

/** Finite points of the selection without triangles, one per place. */
void
PolygonCompletion::addFreePoints()
{
  std::vector<std::uint8_t> used(input_.points.size, 0);
  for (const index_t point : given_.point_of_vertex)
    used[static_cast<std::size_t>(point)] = 1;
  Indices free;
  for (const index_t point : *input_.selection)
    if (used[static_cast<std::size_t>(point)] == 0)
      free.push_back(point);
  const std::vector<index_t> places = removeDuplicates(
      input_.points, curveOrder(input_.points, free, context_.threads));
  const Indices remaining = withoutUsedPlaces(places);
  given_.point_of_vertex.insert(
      given_.point_of_vertex.end(), remaining.begin(), remaining.end());
}

Indices
PolygonCompletion::withoutUsedPlaces(const Indices& free) const
{
  using Place = std::array<float, 3>;
  const auto place_of = [&](index_t point) {
    const float* x = input_.points[point];
    return Place{x[0], x[1], x[2]};
  };
  if (given_.point_of_vertex.empty() || free.empty())
    return free;
  std::vector<Place> places;
  for (const index_t point : free)
    places.push_back(place_of(point));
  std::sort(places.begin(), places.end());
  std::set<Place> taken;
  for (const index_t point : given_.point_of_vertex)
    if (std::binary_search(places.begin(), places.end(), place_of(point)))
      taken.insert(place_of(point));
  Indices remaining;
  for (const index_t point : free)
    if (taken.count(place_of(point)) == 0)
      remaining.push_back(point);
  return remaining;
}

/** Of the vertices; empty where no point is cut. */
std::vector<std::uint8_t>
PolygonCompletion::cutFlags() const
{
  if (input_.cut_points == nullptr)
    return {};
  std::vector<std::uint8_t> is_cut_point(input_.points.size, 0);
  for (const index_t point : *input_.cut_points)
    is_cut_point[static_cast<std::size_t>(point)] = 1;
  std::vector<std::uint8_t> flags;
  for (const index_t point : given_.point_of_vertex)
    flags.push_back(is_cut_point[static_cast<std::size_t>(point)]);
  return flags;
}

PointArray
PolygonCompletion::vertexArray() const
{
  if (coordinates_.empty())
    return {};
  return {coordinates_.front().data(), 3, coordinates_.size()};
}

bool
PolygonCompletion::searchOpen(std::vector<index_t>& open,
                              unsigned int k,
                              std::vector<index_t>& table)
{
  if (input_.search == nullptr)
    return searchBlocks(open, k, table);
  open = curveOrder(vertexArray(), open, context_.threads);
  const auto in_cloud = std::make_shared<Indices>();
  for (const index_t vertex : open)
    in_cloud->push_back(given_.point_of_vertex[static_cast<std::size_t>(vertex)]);
  return searchRows(*input_.search, in_cloud, input_.points.size, k, context_, table);
}

bool
PolygonCompletion::searchBlocks(std::vector<index_t>& open,
                                unsigned int k,
                                std::vector<index_t>& table)
{
  PointBlocks blocks;
  blocks.build(vertexArray(), open, context_.threads);
  open = blocks.order();
  const auto found =
      blocks.allNearest(k, PointBlocks::Distances::OMIT, context_.threads, &control_);
  if (!found)
    return false;
  table.clear();
  if (found->rows() > 0)
    table.assign(found->row(0), found->row(0) + found->rows() * k);
  return true;
}

/** The name of the first parameter that is out of range, or null. */
const char*
outOfRange(const CompletionParameters& parameters)
{
  const auto between = [](double value, double low, double high) {
    return value >= low && value <= high;
  };
  if (parameters.neighbors < 6 || parameters.neighbors > 64)
    return "the number of neighbors";
  if (!between(parameters.support, 0.5, 100.0))
    return "the support";
  if (!between(parameters.smooth_fold, 0.0, M_PI))
    return "the smooth fold";
  if (!between(parameters.largest_fold, 0.0, M_PI))
    return "the largest fold";
  return nullptr;
}

std::string
faultOf(const CompletionInput& input, const CompletionParameters& parameters)
{
  if (const char* wrong = outOfRange(parameters))
    return std::string(wrong) + " is out of range";
  std::string fault = indexFault(*input.selection, input.points.size);
  if (fault.empty() && input.cut_points != nullptr)
    fault = indexFault(*input.cut_points, input.points.size);
  if (!fault.empty())
    return fault;
  const std::size_t points =
      input.partial_mesh == nullptr ? 0 : pointCount(input.partial_mesh->cloud);
  if (points != 0 && points != input.points.size)
    return "the partial mesh has " + std::to_string(points) + " points, the cloud " +
           std::to_string(input.points.size);
  return {};
}

} // namespace

CompletionOutput
runCompletion(const CompletionInput& input,
              const CompletionParameters& parameters,
              CompletionReport& report)
{
  const StageClock clock;
  report = {};
  CompletionOutput output;
  output.error = faultOf(input, parameters);
  if (!output.error.empty())
    return output;
  RunControl control(input.progress);
  output = PolygonCompletion(input, parameters, control).run(report);
  report.cancelled = control.cancelled();
  if (report.cancelled)
    output = {};
  report.seconds = clock.seconds();
  return output;
}

} // namespace pcl::ccaa
