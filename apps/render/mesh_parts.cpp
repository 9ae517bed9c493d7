// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a mesh taken apart into what a picture shows of it.
#include "render/mesh_parts.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include "io/point_columns.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace app {
namespace {

vtkSmartPointer<vtkCellArray>
makeCells(const std::vector<pcl::Vertices>& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  std::vector<vtkIdType> corners;
  for (const auto& cell : cells) {
    corners.assign(cell.vertices.begin(), cell.vertices.end());
    array->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
  }
  return array;
}

vtkSmartPointer<vtkCellArray>
makeDots(std::size_t points)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t i = 0; i < points; ++i) {
    const auto index = static_cast<vtkIdType>(i);
    array->InsertNextCell(1, &index);
  }
  return array;
}

} // namespace

vtkSmartPointer<vtkUnsignedCharArray>
makeColors(const pcl::PCLPointCloud2& cloud)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
  std::size_t offset = 0;
  if (!findColour(cloud, offset))
    return colors;
  for (std::size_t i = 0; i < pointCount(cloud); ++i) {
    std::uint32_t packed = 0;
    std::memcpy(&packed, pointAt(cloud, i) + offset, sizeof(packed));
    const std::array<unsigned char, 3> bytes{static_cast<unsigned char>(packed >> 16),
                                             static_cast<unsigned char>(packed >> 8),
                                             static_cast<unsigned char>(packed)};
    colors->InsertNextTypedTuple(bytes.data());
  }
  return colors;
}

vtkSmartPointer<vtkPolyData>
makePart(const InspectionLayer& layer)
{
  const auto points = vtkSmartPointer<vtkPoints>::New();
  for (const auto& position : positionsOf(layer))
    points->InsertNextPoint(position.data());
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(points);
  part->SetLines(makeCells(layer.lines));
  part->SetPolys(makeCells(layer.faces));
  if (layer.lines.empty() && layer.faces.empty())
    part->SetVerts(makeDots(pointCount(layer.cloud)));
  part->GetPointData()->SetScalars(makeColors(layer.cloud));
  return part;
}

std::vector<Eigen::Vector3d>
positionsOf(const InspectionLayer& layer)
{
  std::vector<Eigen::Vector3d> positions;
  for (const auto& position : readPositions(layer.cloud))
    positions.push_back(position.cast<double>());
  return positions;
}

namespace {

using Edge = std::array<vtkIdType, 2>;

/** \brief VTK index of each point of the cloud, -1 where it is not finite. */
using VtkIndices = std::vector<vtkIdType>;

VtkIndices
insertFinitePoints(const pcl::PolygonMesh& mesh,
                   const pcl::GlobalShift& shift,
                   vtkPoints& points,
                   std::vector<Eigen::Vector3d>& positions)
{
  const std::vector<Eigen::Vector3f> all = readPositions(mesh.cloud, shift);
  VtkIndices indices(all.size(), -1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].allFinite()) {
      positions.push_back(all[i].cast<double>());
      indices[i] = points.InsertNextPoint(positions.back().data());
    }
  }
  return indices;
}

/** \brief Red, green and blue of each finite point; null for a cloud without them. */
vtkSmartPointer<vtkUnsignedCharArray>
colorsOfFinitePoints(const pcl::PCLPointCloud2& cloud, const VtkIndices& indices)
{
  const auto all = makeColors(cloud);
  if (all->GetNumberOfTuples() == 0)
    return nullptr;
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= 0)
      colors->InsertNextTuple(static_cast<vtkIdType>(i), all);
  return colors;
}

/** \brief The polygon in VTK's indices; empty when it cannot be drawn. */
std::vector<vtkIdType>
translate(const pcl::Vertices& polygon, const VtkIndices& indices)
{
  std::vector<vtkIdType> corners;
  for (const auto vertex : polygon.vertices) {
    const auto index = static_cast<std::size_t>(vertex);
    if (index >= indices.size() || indices[index] < 0)
      return {};
    corners.push_back(indices[index]);
  }
  return corners;
}

void
appendEdges(const std::vector<vtkIdType>& corners, std::vector<Edge>& edges)
{
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const vtkIdType from = corners[i];
    const vtkIdType to = corners[(i + 1) % corners.size()];
    edges.push_back({std::min(from, to), std::max(from, to)});
  }
}

vtkSmartPointer<vtkPolyData>
makePart(vtkPoints* points)
{
  auto part = vtkSmartPointer<vtkPolyData>::New();
  part->SetPoints(points);
  part->SetVerts(vtkSmartPointer<vtkCellArray>::New());
  part->SetLines(vtkSmartPointer<vtkCellArray>::New());
  part->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  return part;
}

/** \brief Sort \a edges and hand those that only one or more than two polygons share to
 * their parts. */
void
sortOutEdges(std::vector<Edge>& edges, MeshParts& parts)
{
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::find_if(
        edge, edges.end(), [&](const Edge& other) { return other != *edge; });
    if (next - edge == 1)
      parts.boundaries->GetLines()->InsertNextCell(2, edge->data());
    else if (next - edge > 2)
      parts.overfull->GetLines()->InsertNextCell(2, edge->data());
    edge = next;
  }
}

/** \brief For each point whether some cell of \a cells uses it. */
std::vector<bool>
findUsed(vtkCellArray& cells, std::size_t points)
{
  std::vector<bool> used(points, false);
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (cells.InitTraversal(); cells.GetNextCell(count, corners) != 0;)
    for (vtkIdType i = 0; i < count; ++i)
      used[static_cast<std::size_t>(corners[i])] = true;
  return used;
}

} // namespace

MeshParts
takeApart(const pcl::PolygonMesh& mesh, const pcl::GlobalShift& shift)
{
  MeshParts parts;
  const auto points = vtkSmartPointer<vtkPoints>::New();
  const VtkIndices indices = insertFinitePoints(mesh, shift, *points, parts.positions);
  parts.colors = colorsOfFinitePoints(mesh.cloud, indices);
  for (auto* part : {&parts.faces,
                     &parts.boundaries,
                     &parts.overfull,
                     &parts.free_points,
                     &parts.boundary_points,
                     &parts.internal_points})
    *part = makePart(points);

  std::vector<Edge> edges;
  for (const auto& polygon : mesh.polygons) {
    const auto corners = translate(polygon, indices);
    if (corners.size() < 3)
      continue;
    parts.faces->GetPolys()->InsertNextCell(static_cast<vtkIdType>(corners.size()),
                                            corners.data());
    appendEdges(corners, edges);
  }
  sortOutEdges(edges, parts);

  const std::size_t points_drawn = parts.positions.size();
  const auto used = findUsed(*parts.faces->GetPolys(), points_drawn);
  const auto on_boundary = findUsed(*parts.boundaries->GetLines(), points_drawn);
  for (std::size_t i = 0; i < points_drawn; ++i) {
    vtkPolyData& part = !used[i]         ? *parts.free_points
                        : on_boundary[i] ? *parts.boundary_points
                                         : *parts.internal_points;
    const auto index = static_cast<vtkIdType>(i);
    part.GetVerts()->InsertNextCell(1, &index);
  }
  return parts;
}

MeshParts
takeApart(const pcl::PCLPointCloud2& cloud,
          const std::vector<pcl::Vertices>& polygons,
          const pcl::GlobalShift& shift)
{
  pcl::PolygonMesh mesh;
  mesh.cloud = cloud;
  mesh.polygons = polygons;
  return takeApart(mesh, shift);
}

} // namespace app
