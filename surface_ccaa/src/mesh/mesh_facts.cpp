// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: everything that can be counted and measured about a mesh.
#include "mesh/mesh_facts.h"

#include <Eigen/Geometry>

#include "mesh/corners.h"
#include "mesh/intersection.h"
#include "mesh/mesh_topology.h"
#include "mesh/triangle_checks.h"

#include <algorithm>
#include <cmath>

namespace pcl::ccaa {
namespace {

/** \brief The three angles in degrees. */
std::array<double, 3>
anglesOf(const Corners& corners)
{
  std::array<double, 3> angles{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d u = corners[(k + 1) % 3] - corners[k];
    const Eigen::Vector3d v = corners[(k + 2) % 3] - corners[k];
    angles[k] = angleBetween(u, v) * 180.0 / M_PI;
  }
  return angles;
}

template <std::size_t BINS>
void
count(double angle, double bin_width, std::array<std::size_t, BINS>& bins)
{
  const auto bin = static_cast<std::size_t>(std::max(0.0, angle / bin_width));
  ++bins[std::min(bin, BINS - 1)];
}

void
countAngles(const Corners& corners, MeshFacts& facts)
{
  const std::array<double, 3> angles = anglesOf(corners);
  const double smallest = *std::min_element(angles.begin(), angles.end());
  facts.smallest_angle = std::min(facts.smallest_angle, smallest);
  count(smallest, 5.0, facts.minimum_angles);
  for (const double angle : angles)
    count(angle, 10.0, facts.angles);
}

void
measureShape(const Triangles& triangles, const PointView& positions, MeshFacts& facts)
{
  if (triangles.empty())
    return;
  const Position origin = positions[triangles.front()[0]];
  double six_volumes = 0.0;
  facts.smallest_angle = 180.0;
  for (const Triangle& triangle : triangles) {
    const Corners corners = cornersOf(triangle, positions);
    const Eigen::Vector3d area = areaNormal(corners);
    if (!area.allFinite()) {
      ++facts.non_finite_triangles;
      continue;
    }
    facts.area += area.norm() / 2.0;
    six_volumes += area.dot(corners[0] - origin);
    facts.degenerate_triangles += isCollinear(corners) ? 1u : 0u;
    countAngles(corners, facts);
  }
  if (facts.non_finite_triangles == triangles.size())
    facts.smallest_angle = 0.0;
  if (facts.boundary_edges == 0 && facts.non_manifold_edges == 0 &&
      facts.misoriented_edges == 0 && facts.non_finite_triangles == 0)
    facts.volume = six_volumes / 6.0;
}

MeshFacts
cancelledFacts()
{
  MeshFacts facts;
  facts.cancelled = true;
  return facts;
}

} // namespace

MeshFacts
measureMesh(const Triangles& triangles,
            const PointView& positions,
            const MeshFactsOptions& options,
            RunControl& control)
{
  MeshFacts facts;
  Triangles valid;
  valid.reserve(triangles.size());
  for (const Triangle& triangle : triangles)
    if (hasValidIndices(triangle, positions.size()))
      valid.push_back(triangle);
  facts.vertices = positions.size();
  facts.triangles = valid.size();
  facts.invalid_triangles = triangles.size() - valid.size();
  if (!control.report("topology", 0.0))
    return cancelledFacts();
  measureTopology(valid, positions, facts);
  if (!control.report("shape", 0.0))
    return cancelledFacts();
  measureShape(valid, positions, facts);
  if (options.self_intersections) {
    const SelfIntersections found =
        findSelfIntersections(valid, positions, options.threads, control);
    facts.self_intersections = found.pairs.size();
  }
  return control.report("shape", 1.0) ? facts : cancelledFacts();
}

} // namespace pcl::ccaa
