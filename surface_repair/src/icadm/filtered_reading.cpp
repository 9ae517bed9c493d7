// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: brings a mesh that is no ICADM there, windings kept.
#include "filtered_reading.h"

#include <pcl/surface_ccaa/mesh/cloud_access.h>
#include <pcl/surface_ccaa/mesh/islands.h>
#include <pcl/surface_ccaa/mesh/orientation.h>
#include <pcl/surface_ccaa/mesh/triangle_adjacency.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace repair {
namespace {

using ccaa::PolygonTriangles;
using ccaa::Triangle;

Triangle
inPoints(const PolygonTriangles& mesh, std::size_t triangle)
{
  Triangle corners = mesh.triangles[triangle];
  for (pcl::index_t& corner : corners)
    corner = mesh.point_of_vertex[static_cast<std::size_t>(corner)];
  return corners;
}

/** \brief The filter reverses by exchanging the second and the third corner. */
Triangle
reversed(const Triangle& triangle)
{
  return {triangle[0], triangle[2], triangle[1]};
}

/** \brief Which triangles the filter has turned. Those it left are triangles of the
 * input in the order of the input, so one walk along both finds each. */
std::vector<std::uint8_t>
turnedTriangles(const PolygonTriangles& given, const PolygonTriangles& filtered)
{
  std::vector<std::uint8_t> turned(filtered.triangles.size(), 0);
  std::size_t place = 0;
  for (std::size_t t = 0; t < turned.size(); ++t) {
    const Triangle own = inPoints(filtered, t);
    const Triangle other = reversed(own);
    for (; place < given.triangles.size(); ++place) {
      const Triangle input = inPoints(given, place);
      if (input != own && input != other)
        continue;
      turned[t] = input == other ? 1 : 0;
      ++place;
      break;
    }
  }
  return turned;
}

/** \brief Turn islands back whose given windings mostly agree.
 * \return how many triangles differ from the input now */
std::size_t
keepGivenSides(std::vector<std::uint8_t> turned, PolygonTriangles& mesh)
{
  ccaa::TriangleAdjacency adjacency;
  adjacency.build(mesh.triangles, mesh.point_of_vertex.size());
  const ccaa::Islands islands = ccaa::labelIslands(adjacency);
  std::vector<std::size_t> sizes(islands.count, 0);
  std::vector<std::size_t> votes(islands.count, 0);
  for (std::size_t t = 0; t < turned.size(); ++t) {
    ++sizes[islands[t]];
    votes[islands[t]] += turned[t];
  }
  for (std::size_t t = 0; t < turned.size(); ++t) {
    const auto against = static_cast<double>(votes[islands[t]]);
    const auto all = static_cast<double>(sizes[islands[t]]);
    if (2.0 * against - all < ccaa::VOTE_MARGIN * all)
      continue;
    mesh.triangles[t] = reversed(mesh.triangles[t]);
    turned[t] ^= 1;
  }
  return static_cast<std::size_t>(std::count(turned.begin(), turned.end(), 1));
}

} // namespace

FilteredTriangles
filterTriangles(const PolygonTriangles& given,
                const pcl::PCLPointCloud2& cloud,
                const ccaa::LoopContext& context)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  mesh->cloud = cloud;
  ccaa::writePolygons(given.triangles, given.point_of_vertex, context, mesh->polygons);
  UmbrellaFilter filter;
  filter.setMinimumInternalPoints(0);
  filter.setNumberOfThreads(static_cast<unsigned int>(context.threads));
  if (context.control != nullptr)
    filter.setProgressCallback([&](const std::string& stage, double fraction) {
      return context.control->report(stage.c_str(), fraction);
    });
  filter.setInputMesh(mesh);
  filter.process(*mesh);
  if (context.cancelled())
    return {};
  FilteredTriangles result;
  result.report = filter.getReport();
  result.mesh =
      ccaa::readPolygons(mesh->polygons, ccaa::positionView(mesh->cloud), context);
  if (!context.cancelled())
    result.reversed_triangles =
        keepGivenSides(turnedTriangles(given, result.mesh), result.mesh);
  return result;
}

} // namespace repair
} // namespace pcl
