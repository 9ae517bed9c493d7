// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: GoogleTest predicates on meshes. They share no code with
// the library, so that they can judge it.
#pragma once

#include <pcl/PolygonMesh.h>

#include <gtest/gtest.h>

#include "shapes.h"

#include <cstddef>
#include <vector>

namespace pcl::ccaa::test {

/** \brief Triangles have three different indices below vertex_count, no edge has more
 * than two triangles, and every used vertex has exactly one fan (D1.3-1). */
::testing::AssertionResult
isIcadm(const Triangles& triangles, std::size_t vertex_count);

/** \brief No edge is run through twice in the same direction. */
::testing::AssertionResult
isConsistentlyWound(const Triangles& triangles);

/** \brief The same set of triangles with the same winding; order of triangles and
 * rotation of corners do not matter. */
::testing::AssertionResult
sameTriangles(const Triangles& expected, const Triangles& actual);

/** \brief As sameTriangles, but the winding does not matter either. */
::testing::AssertionResult
sameUnorientedTriangles(const Triangles& expected, const Triangles& actual);

/** \brief Every triangle of `part` is one of `whole`, whatever its winding. */
::testing::AssertionResult
isSubsetOf(const Triangles& part, const Triangles& whole);

/** \brief The same bytes, layout and flags. */
::testing::AssertionResult
sameCloud(const pcl::PCLPointCloud2& expected, const pcl::PCLPointCloud2& actual);

/** \brief Number of connected components (over shared edges) of the triangles. */
std::size_t
countComponents(const Triangles& triangles);

/** \brief Number of edges with exactly one triangle. */
std::size_t
countBoundaryEdges(const Triangles& triangles);

/** \brief Polygons of a PCL mesh as triangles; polygons of another size fail the test.
 */
Triangles
toTriangles(const std::vector<pcl::Vertices>& polygons);

std::vector<pcl::Vertices>
toPolygons(const Triangles& triangles);

/** \brief The shape as a PCL mesh with an xyz cloud. */
pcl::PolygonMesh
toPolygonMesh(const Shape& shape);

} // namespace pcl::ccaa::test
