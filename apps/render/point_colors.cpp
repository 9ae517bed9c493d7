// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: parts of a mesh with a colour for each point.
#include "render/point_colors.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkPolyDataConnectivityFilter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <set>
#include <vector>

namespace app {
namespace {

/** \brief The colours \a color_of(0), ..., \a color_of(count - 1) as VTK wants them. */
vtkSmartPointer<vtkUnsignedCharArray>
makeColors(vtkIdType count, const std::function<Color(vtkIdType)>& color_of)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < count; ++i) {
    std::array<unsigned char, 3> bytes{};
    const Color color = color_of(i);
    for (std::size_t channel = 0; channel < 3; ++channel)
      bytes[channel] = static_cast<unsigned char>(std::lround(255.0 * color[channel]));
    colors->InsertNextTypedTuple(bytes.data());
  }
  return colors;
}

void
setPointColors(vtkPolyData& part, const std::function<Color(vtkIdType)>& color_of)
{
  part.GetPointData()->SetScalars(makeColors(part.GetNumberOfPoints(), color_of));
}

/** \brief Points that a polygon joins. */
using Corners = std::vector<vtkIdType>;

/** \brief The corners of every polygon, each in ascending order. */
std::vector<Corners>
sortedCorners(vtkCellArray& cells)
{
  std::vector<Corners> all;
  vtkIdType count = 0;
  const vtkIdType* corners = nullptr;
  for (cells.InitTraversal(); cells.GetNextCell(count, corners) != 0;) {
    all.emplace_back(corners, corners + count);
    std::sort(all.back().begin(), all.back().end());
  }
  return all;
}

/** \brief Neighbouring numbers differ well in hue. */
Color
colorOfComponent(double component)
{
  constexpr double golden_ratio = 0.618034;
  const double turns = 0.58 + golden_ratio * component;
  Color rgb{};
  vtkMath::HSVToRGB(turns - std::floor(turns), 0.5, 0.9, &rgb[0], &rgb[1], &rgb[2]);
  return rgb;
}

/** \brief The value that \a share of all values are less than. */
double
quantile(std::vector<double> values, double share)
{
  const auto rank =
      static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

} // namespace

Color
colorOfNearness(double nearness)
{
  constexpr Color far{0.74, 0.84, 0.95};
  constexpr Color near{0.03, 0.10, 0.35};
  Color color{};
  for (std::size_t i = 0; i < 3; ++i)
    color[i] = far[i] + nearness * (near[i] - far[i]);
  return color;
}

vtkSmartPointer<vtkPolyData>
colorComponents(const MeshParts& parts)
{
  const auto connectivity = vtkSmartPointer<vtkPolyDataConnectivityFilter>::New();
  connectivity->SetInputData(parts.faces);
  connectivity->SetExtractionModeToAllRegions();
  connectivity->ColorRegionsOn();
  connectivity->Update();
  vtkSmartPointer<vtkPolyData> faces = connectivity->GetOutput();
  const vtkSmartPointer<vtkDataArray> numbers =
      faces->GetPointData()->GetArray("RegionId");
  setPointColors(*faces, [&](vtkIdType point) {
    return colorOfComponent(numbers->GetComponent(point, 0));
  });
  return faces;
}

vtkSmartPointer<vtkPolyData>
colorByDepth(const MeshParts& parts, const Eigen::Vector3d& view)
{
  std::vector<double> heights;
  for (const auto& position : parts.positions)
    heights.push_back(view.dot(position));
  // A few stray points must not take all the contrast.
  const double lowest = quantile(heights, 0.02);
  const double range = std::max(quantile(heights, 0.98) - lowest, 1e-300);
  setPointColors(*parts.free_points, [&](vtkIdType point) {
    const double height = heights[static_cast<std::size_t>(point)];
    return colorOfNearness(std::clamp((height - lowest) / range, 0.0, 1.0));
  });
  return parts.free_points;
}

vtkSmartPointer<vtkPolyData>
colorAsPoints(const MeshParts& parts, vtkPolyData& part)
{
  part.GetPointData()->SetScalars(parts.colors);
  return &part;
}

vtkSmartPointer<vtkPolyData>
colorNewFaces(const MeshParts& parts)
{
  constexpr Color old_color{0.62, 0.74, 0.86}; // grey blue
  constexpr Color new_color{0.35, 0.75, 0.30}; // green
  const auto faces = sortedCorners(*parts.faces->GetPolys());
  const auto before = sortedCorners(*parts.earlier_faces->GetPolys());
  const std::set<Corners> known(before.begin(), before.end());
  const auto color_of = [&](vtkIdType face) {
    return known.count(faces[static_cast<std::size_t>(face)]) > 0 ? old_color
                                                                  : new_color;
  };
  parts.faces->GetCellData()->SetScalars(
      makeColors(static_cast<vtkIdType>(faces.size()), color_of));
  return parts.faces;
}

} // namespace app
