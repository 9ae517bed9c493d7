// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a damaged model, its repair and how good it is.
#pragma once

#include <pcl/surface_repair/repair_parameters.h>
#include <pcl/surface_repair/repair_report.h>
#include <pcl/PolygonMesh.h>

#include "support/repair_shapes.h"

#include <cstddef>
#include <string>

namespace bench {

using pcl::ccaa::Positions;
using pcl::ccaa::Triangles;
using pcl::ccaa::test::Shape;

/** \brief A repair that was run. */
struct RepairTrial {
  Shape result; /**< in the numbers of the cloud, input points first */
  pcl::RepairReport report;
  double seconds = 0; /**< median of the runs, one thread */
};

struct TrialSettings {
  pcl::repair::RepairParameters parameters;
  Positions free_points;   /**< a cloud of its own */
  std::size_t repeats = 1; /**< at least 1 */
};

/** \brief The shape as a mesh with float positions. */
pcl::PolygonMesh::Ptr
meshOf(const Shape& shape);

RepairTrial
runTrial(const Shape& damaged, const TrialSettings& settings);

/** \brief The triangles of a file; throws std::runtime_error when it cannot be read. */
Shape
readShape(const std::string& file);

/** \brief Those of a file of the shared data. */
Shape
readShared(const std::string& name);

/** \brief Pairs of triangles that meet where they should not. */
std::size_t
countIntersections(const Shape& shape);

/** \brief Length of the diagonal of the box around all vertices. */
double
diagonalOf(const Shape& shape);

/** \brief The triangles of a surface without those of a part of it; vertices of both
 * are the same. */
Shape
lostPart(const Shape& whole, const Triangles& kept);

/** \brief Mean distance from the triangles of `from`, by area, to the surface `to`, in
 * percent of a length. */
double
meanDistance(const Shape& from, const Shape& to, double length);

} // namespace bench
