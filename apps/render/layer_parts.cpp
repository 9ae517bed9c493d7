// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: an inspection layer as VTK draws it.
#include "render/layer_parts.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include "io/point_columns.h"

#include <array>
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

} // namespace app
