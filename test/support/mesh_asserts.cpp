// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: GoogleTest predicates on meshes.
#include "mesh_asserts.h"

#include "clouds.h"
#include "edge_sets.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace pcl::ccaa::test {

namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

/** \brief Number of fans at each vertex: corners joined over the shared edges. */
std::map<index_t, int>
countFans(const Triangles& triangles)
{
  Sets corners(3 * triangles.size());
  std::map<std::pair<Edge, index_t>, std::size_t> first_corner;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t other = 1; other < 3; ++other) {
        const index_t vertex = triangles[i][k];
        const Edge edge = std::minmax(vertex, triangles[i][(k + other) % 3]);
        const std::size_t corner = 3 * i + k;
        corners.join(
            corner,
            first_corner.emplace(std::make_pair(edge, vertex), corner).first->second);
      }
  std::map<index_t, int> fans;
  for (std::size_t corner = 0; corner < 3 * triangles.size(); ++corner)
    if (corners.find(corner) == corner)
      ++fans[triangles[corner / 3][corner % 3]];
  return fans;
}

/** \brief Corners rotated so that the smallest index comes first. */
Triangle
canonical(Triangle t, bool oriented)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  if (!oriented && t[1] > t[2])
    std::swap(t[1], t[2]);
  return t;
}

std::vector<Triangle>
canonicalList(const Triangles& triangles, bool oriented)
{
  std::vector<Triangle> list;
  for (const Triangle& t : triangles)
    list.push_back(canonical(t, oriented));
  std::sort(list.begin(), list.end());
  return list;
}

std::string
show(const Triangle& t)
{
  std::ostringstream text;
  text << '(' << t[0] << ' ' << t[1] << ' ' << t[2] << ')';
  return text.str();
}

AssertionResult
compare(const Triangles& expected, const Triangles& actual, bool oriented)
{
  const auto want = canonicalList(expected, oriented);
  const auto have = canonicalList(actual, oriented);
  std::vector<Triangle> missing, extra;
  std::set_difference(
      want.begin(), want.end(), have.begin(), have.end(), std::back_inserter(missing));
  std::set_difference(
      have.begin(), have.end(), want.begin(), want.end(), std::back_inserter(extra));
  if (missing.empty() && extra.empty())
    return AssertionSuccess();
  AssertionResult result = AssertionFailure();
  result << missing.size() << " triangles missing, " << extra.size() << " too many";
  if (!missing.empty())
    result << "; first missing " << show(missing.front());
  if (!extra.empty())
    result << "; first extra " << show(extra.front());
  return result;
}

AssertionResult
indicesAreValid(const Triangles& triangles, std::size_t vertex_count)
{
  for (const Triangle& t : triangles) {
    for (const index_t v : t)
      if (v < 0 || static_cast<std::size_t>(v) >= vertex_count)
        return AssertionFailure() << "index out of range in triangle " << show(t);
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      return AssertionFailure() << "repeated corner in triangle " << show(t);
  }
  return AssertionSuccess();
}

} // namespace

AssertionResult
isIcadm(const Triangles& triangles, std::size_t vertex_count)
{
  if (const AssertionResult valid = indicesAreValid(triangles, vertex_count); !valid)
    return valid;
  for (const auto& edge : trianglesOfEdges(triangles))
    if (edge.second.size() > 2)
      return AssertionFailure() << edge.second.size() << " triangles on edge "
                                << edge.first.first << '-' << edge.first.second;
  for (const auto& vertex : countFans(triangles))
    if (vertex.second != 1)
      return AssertionFailure() << vertex.second << " fans at vertex " << vertex.first;
  return AssertionSuccess();
}

AssertionResult
isConsistentlyWound(const Triangles& triangles)
{
  std::set<Edge> directed;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (!directed.emplace(t[k], t[(k + 1) % 3]).second)
        return AssertionFailure()
               << "two triangles run from " << t[k] << " to " << t[(k + 1) % 3];
  return AssertionSuccess();
}

AssertionResult
sameTriangles(const Triangles& expected, const Triangles& actual)
{
  return compare(expected, actual, true);
}

AssertionResult
sameUnorientedTriangles(const Triangles& expected, const Triangles& actual)
{
  return compare(expected, actual, false);
}

AssertionResult
isSubsetOf(const Triangles& part, const Triangles& whole)
{
  const auto inner = canonicalList(part, false), outer = canonicalList(whole, false);
  for (const Triangle& t : inner)
    if (!std::binary_search(outer.begin(), outer.end(), t))
      return AssertionFailure() << "triangle " << show(t) << " is new";
  return AssertionSuccess();
}

AssertionResult
sameCloud(const pcl::PCLPointCloud2& expected, const pcl::PCLPointCloud2& actual)
{
  if (expected.width != actual.width || expected.height != actual.height)
    return AssertionFailure() << "size " << actual.width << " x " << actual.height
                              << " instead of " << expected.width << " x "
                              << expected.height;
  if (expected.point_step != actual.point_step ||
      expected.row_step != actual.row_step ||
      expected.fields.size() != actual.fields.size())
    return AssertionFailure() << "another layout";
  for (std::size_t i = 0; i < expected.fields.size(); ++i)
    if (expected.fields[i].name != actual.fields[i].name ||
        expected.fields[i].offset != actual.fields[i].offset ||
        expected.fields[i].datatype != actual.fields[i].datatype ||
        expected.fields[i].count != actual.fields[i].count)
      return AssertionFailure() << "field " << expected.fields[i].name << " differs";
  if (expected.is_dense != actual.is_dense || expected.data != actual.data)
    return AssertionFailure() << "other bytes";
  return AssertionSuccess();
}

std::size_t
countComponents(const Triangles& triangles)
{
  Sets sets(triangles.size());
  for (const auto& edge : trianglesOfEdges(triangles))
    for (const std::size_t triangle : edge.second)
      sets.join(triangle, edge.second.front());
  std::size_t components = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    components += sets.find(i) == i ? 1u : 0u;
  return components;
}

std::size_t
countBoundaryEdges(const Triangles& triangles)
{
  const auto edges = trianglesOfEdges(triangles);
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [](const auto& edge) {
        return edge.second.size() == 1;
      }));
}

Triangles
toTriangles(const std::vector<pcl::Vertices>& polygons)
{
  Triangles triangles;
  for (const pcl::Vertices& polygon : polygons) {
    if (polygon.vertices.size() == 3)
      triangles.push_back(
          {polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]});
    else
      ADD_FAILURE() << "a polygon of " << polygon.vertices.size() << " corners";
  }
  return triangles;
}

std::vector<pcl::Vertices>
toPolygons(const Triangles& triangles)
{
  std::vector<pcl::Vertices> polygons(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    polygons[i].vertices.assign(triangles[i].begin(), triangles[i].end());
  return polygons;
}

pcl::PolygonMesh
toPolygonMesh(const Shape& shape)
{
  pcl::PolygonMesh mesh;
  mesh.cloud = toRawCloud(shape.vertices);
  mesh.polygons = toPolygons(shape.triangles);
  return mesh;
}

} // namespace pcl::ccaa::test
