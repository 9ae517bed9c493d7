// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what new vertices inherit.

#include "repair/new_vertices.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/memory.h>
#include <pcl/point_types.h>

#include "icadm/pinched_points.h"
#include "mesh/sort_unique.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {

namespace {

/** Operations for a new vertex. */
constexpr std::uint64_t INHERITING_WORK = 300;

/** Input vertices that a new one inherits from at the most. */
constexpr std::size_t MOST_SOURCES = 12;

/** Input vertices that have new triangles, ascending. */
std::vector<pcl::index_t>
joinedVertices(const RepairedModel& repaired)
{
  std::vector<pcl::index_t> joined;
  const IncompleteModel& model = repaired.model;
  for (std::size_t t = repaired.input_triangles; t < model.triangles.size(); ++t)
    for (const pcl::index_t corner : model.triangles[t])
      if (static_cast<std::size_t>(corner) < repaired.input_vertices)
        joined.push_back(corner);
  ccaa::sortUnique(joined);
  return joined;
}

/** Shepard's weights, which fall to zero at a distance (Franke and Nielson 1980). */
double
weightAt(double distance, double zero_at)
{
  const double left = std::max(0.0, zero_at - distance) / zero_at;
  return left * left / std::max(distance * distance, 1e-12 * zero_at * zero_at);
}

class Inheritance {
public:
  explicit Inheritance(const RepairedModel& repaired)
  : repaired_(repaired)
  , vertices_(joinedVertices(repaired))
  , cloud_(pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>())
  {
    if (vertices_.empty())
      return;
    origin_ = positionOf(vertices_.front());
    for (const pcl::index_t vertex : vertices_)
      cloud_->push_back(place(positionOf(vertex)));
    tree_.setInputCloud(cloud_);
  }

  std::vector<ccaa::VertexSource>
  sourcesOf(const Position& position)
  {
    if (vertices_.empty())
      return {};
    pcl::Indices nearest;
    std::vector<float> squared;
    tree_.nearestKSearch(
        place(position), static_cast<unsigned int>(MOST_SOURCES) + 1, nearest, squared);
    const double farthest = std::sqrt(static_cast<double>(squared.back()));
    const double zero_at = std::max(farthest, 1e-30) * (1.0 + 1e-6);
    std::vector<ccaa::VertexSource> sources;
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      const pcl::index_t vertex = vertices_[static_cast<std::size_t>(nearest[i])];
      const double weight =
          weightAt(std::sqrt(static_cast<double>(squared[i])), zero_at);
      sources.push_back(
          {repaired_.model.point_of_vertex[static_cast<std::size_t>(vertex)], weight});
    }
    return sources;
  }

private:
  const Position&
  positionOf(pcl::index_t vertex) const
  {
    return repaired_.model.positions[static_cast<std::size_t>(vertex)];
  }

  /** Near the origin, where floats are fine enough. */
  pcl::PointXYZ
  place(const Position& position) const
  {
    const Eigen::Vector3f near_origin = (position - origin_).cast<float>();
    return {near_origin.x(), near_origin.y(), near_origin.z()};
  }

  const RepairedModel& repaired_;
  std::vector<pcl::index_t> vertices_;
  Position origin_ = Position::Zero();
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud_;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_;
};

} // namespace

AddedVertices
addedVertices(const RepairedModel& repaired, ccaa::RunControl* control)
{
  Inheritance inheritance(repaired);
  AddedVertices added;
  const IncompleteModel& model = repaired.model;
  const std::vector<bool> is_copy = copiesOfPoints(repaired.model.point_of_vertex);
  ccaa::spend(control, model.positions.size());
  ccaa::WorkCount work(control);
  for (std::size_t v = 0; v < model.positions.size(); ++v) {
    const pcl::index_t point = model.point_of_vertex[v];
    if (!is_copy[v] && point != pcl::UNAVAILABLE)
      continue; // a point of the input
    if (!work.add(INHERITING_WORK))
      return added;
    added.numbers.push_back(v);
    if (is_copy[v])
      added.vertices.push_back({model.positions[v], {{point, 1.0}}});
    else
      added.vertices.push_back(
          {model.positions[v], inheritance.sourcesOf(model.positions[v])});
  }
  return added;
}

} // namespace pcl::repair
