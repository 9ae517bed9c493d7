// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: CGAL's hole filling as a rival, where CGAL is installed.
#include "rival_hole_filling.h"

#include "measuring.h"

#ifdef PSR_HAVE_CGAL
#include <Eigen/Sparse>
#define CGAL_EIGEN3_ENABLED
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/utility.h>
#endif

#include <iterator>

namespace bench {

#ifdef PSR_HAVE_CGAL

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;

Kernel::Point_3
toPoint(const pcl::ccaa::Position& position)
{
  return {position.x(), position.y(), position.z()};
}

Mesh
toMesh(const pcl::ccaa::Triangles& triangles, const pcl::ccaa::Positions& positions)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;
  for (const pcl::ccaa::Position& position : positions)
    vertices.push_back(mesh.add_vertex(toPoint(position)));
  for (const pcl::ccaa::Triangle& t : triangles)
    mesh.add_face(vertices[static_cast<std::size_t>(t[0])],
                  vertices[static_cast<std::size_t>(t[1])],
                  vertices[static_cast<std::size_t>(t[2])]);
  return mesh;
}

pcl::ccaa::Triangle
cornersOf(const Mesh& mesh, Mesh::Face_index face)
{
  pcl::ccaa::Triangle corners{};
  std::size_t corner = 0;
  for (const Mesh::Vertex_index vertex :
       CGAL::vertices_around_face(mesh.halfedge(face), mesh))
    corners[corner++] = static_cast<pcl::index_t>(vertex.idx());
  return corners;
}

} // namespace

bool
hasHoleFilling()
{
  return true;
}

HoleFilling
triangulateHole(const pcl::ccaa::Positions& positions,
                const std::vector<pcl::index_t>& loop)
{
  std::vector<Kernel::Point_3> points;
  for (const pcl::index_t vertex : loop)
    points.push_back(toPoint(positions[static_cast<std::size_t>(vertex)]));
  std::vector<CGAL::Triple<int, int, int>> triples;
  HoleFilling filling;
  filling.seconds = secondsOf([&] {
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
        points, std::back_inserter(triples));
  });
  const auto at = [&](int corner) { return loop[static_cast<std::size_t>(corner)]; };
  for (const auto& t : triples)
    filling.triangles.push_back({at(t.first), at(t.second), at(t.third)});
  return filling;
}

HoleFilling
refineAndFairHole(const pcl::ccaa::Triangles& triangles,
                  const pcl::ccaa::Positions& positions,
                  const std::vector<pcl::index_t>& loop)
{
  Mesh mesh = toMesh(triangles, positions);
  const Halfedge border =
      mesh.halfedge(Mesh::Vertex_index(static_cast<Mesh::size_type>(loop[0])),
                    Mesh::Vertex_index(static_cast<Mesh::size_type>(loop[1])));
  std::vector<Mesh::Face_index> faces;
  std::vector<Mesh::Vertex_index> vertices;
  HoleFilling filling;
  filling.seconds = secondsOf([&] {
    CGAL::Polygon_mesh_processing::triangulate_refine_and_fair_hole(
        mesh, border, std::back_inserter(faces), std::back_inserter(vertices));
  });
  for (const Mesh::Face_index face : faces)
    filling.triangles.push_back(cornersOf(mesh, face));
  for (std::size_t v = positions.size(); v < mesh.number_of_vertices(); ++v) {
    const Kernel::Point_3& p =
        mesh.point(Mesh::Vertex_index(static_cast<Mesh::size_type>(v)));
    filling.added.push_back({p.x(), p.y(), p.z()});
  }
  return filling;
}

#else

bool
hasHoleFilling()
{
  return false;
}

HoleFilling
triangulateHole(const pcl::ccaa::Positions&, const std::vector<pcl::index_t>&)
{
  return {};
}

HoleFilling
refineAndFairHole(const pcl::ccaa::Triangles&,
                  const pcl::ccaa::Positions&,
                  const std::vector<pcl::index_t>&)
{
  return {};
}

#endif

} // namespace bench
