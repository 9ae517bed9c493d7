// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how the surface goes on beyond a boundary vertex.

#include "junction/junction.h"
#include "mesh/corners.h"
#include "mesh/index_set.h"
#include "mesh/quantile.h"

#include <algorithm>
#include <limits>

namespace pcl::repair {

namespace {

/** Radius of the surface that is looked at, in edges. */
constexpr double REACH = 4.0;
/** Triangles whose edges tell how long edges are here. */
constexpr std::size_t FEW_TRIANGLES = 24;

/** Connected triangles around a vertex, ring by ring, each ring in ascending order. */
class Rings {
public:
  Rings(const IncompleteModel& model, pcl::index_t vertex)
  : model_(model), reached_({vertex})
  {}

  const std::vector<pcl::index_t>&
  triangles() const
  {
    return triangles_.items();
  }

  /** Add the triangles at the outermost vertices whose centres are near enough.
   * \return whether there were any */
  bool
  grow(const Position& center, double radius)
  {
    const std::size_t before = triangles_.size();
    const std::size_t rim_end = reached_.size();
    for (; rim_begin_ < rim_end; ++rim_begin_) {
      const pcl::index_t vertex = reached_.items()[rim_begin_];
      for (const pcl::index_t* t = model_.adjacency.begin(vertex);
           t != model_.adjacency.end(vertex);
           ++t)
        if ((centroidOf(*t) - center).norm() <= radius && triangles_.insert(*t))
          for (const pcl::index_t corner :
               model_.triangles[static_cast<std::size_t>(*t)])
            reached_.insert(corner);
    }
    return triangles_.size() > before;
  }

  Position
  centroidOf(pcl::index_t triangle) const
  {
    const ccaa::Corners corners = cornersOf(triangle);
    return (corners[0] + corners[1] + corners[2]) / 3.0;
  }

  ccaa::Corners
  cornersOf(pcl::index_t triangle) const
  {
    return ccaa::cornersOf(model_.triangles[static_cast<std::size_t>(triangle)],
                           model_.positions);
  }

private:
  const IncompleteModel& model_;
  ccaa::IndexSet triangles_;
  ccaa::IndexSet reached_;    /**< vertices */
  std::size_t rim_begin_ = 0; /**< the outermost of these */
};

double
medianEdge(const Rings& rings)
{
  std::vector<double> lengths;
  for (const pcl::index_t triangle : rings.triangles()) {
    const ccaa::Corners corners = rings.cornersOf(triangle);
    for (std::size_t k = 0; k < 3; ++k)
      lengths.push_back((corners[(k + 1) % 3] - corners[k]).norm());
  }
  return ccaa::medianOf(std::move(lengths));
}

} // namespace

SurfaceEnd
surfaceEndAt(const IncompleteModel& model, pcl::index_t vertex)
{
  const Position& place = model.positions[static_cast<std::size_t>(vertex)];
  Rings near_by(model, vertex);
  while (near_by.triangles().size() < FEW_TRIANGLES &&
         near_by.grow(place, std::numeric_limits<double>::infinity()))
    ;
  SurfaceEnd end;
  if (near_by.triangles().empty())
    return end;
  end.edge = medianEdge(near_by);
  Rings patch(model, vertex);
  while (patch.grow(place, REACH * end.edge))
    ;
  // A large triangle among small ones has its centre far away.
  const Rings& rings = patch.triangles().empty() ? near_by : patch;
  double area = 0.0;
  Position centroid = Position::Zero();
  for (const pcl::index_t triangle : rings.triangles()) {
    const Position normal = ccaa::areaNormal(rings.cornersOf(triangle));
    end.normal += normal;
    centroid += normal.norm() * rings.centroidOf(triangle);
    area += normal.norm();
  }
  if (!(area > 0.0))
    return end;
  end.normal.normalize(); // 0 stays 0
  const Eigen::Vector3d away = place - centroid / area;
  end.conormal = (away - end.normal * end.normal.dot(away)).normalized();
  return end;
}

} // namespace pcl::repair
