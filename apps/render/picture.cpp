// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: draws a mesh off-screen.
#include "render/picture.h"

#include <vtkProperty.h>

#include "render/camera.h"
#include "render/drawing.h"
#include "render/point_colors.h"

namespace app {
namespace {

constexpr Color FRONT{0.62, 0.74, 0.86};   // grey blue
constexpr Color BACK{0.95, 0.60, 0.15};    // orange: holes and flips stand out
constexpr Color BOUNDARY{0.85, 0.0, 0.05}; // red
constexpr Color OVERFULL{0.85, 0.0, 0.85}; // magenta
constexpr Color FREE{0.05, 0.15, 0.75};    // blue

vtkSmartPointer<vtkActor>
makeSurface(const MeshParts& parts, const RenderSettings& settings)
{
  auto actor = makeFaces(parts.faces, FRONT, BACK);
  if (settings.edges) {
    actor->GetProperty()->EdgeVisibilityOn();
    actor->GetProperty()->SetEdgeColor(MESH_EDGE[0], MESH_EDGE[1], MESH_EDGE[2]);
  }
  return actor;
}

void
addParts(const MeshParts& parts, const RenderSettings& settings, vtkRenderer& renderer)
{
  const auto faces = makeSurface(parts, settings);
  if (settings.coloring == Coloring::COMPONENT)
    showColors(colorComponents(parts), *faces);
  else if (settings.coloring == Coloring::RGB)
    showColors(colorAsPoints(parts, *parts.faces), *faces);
  else if (parts.earlier_faces)
    showColors(colorNewFaces(parts), *faces);
  renderer.AddActor(faces);

  const auto add_marks = [&](vtkPolyData* part, const Color& color, double size) {
    renderer.AddActor(makeMarks(part, color, size));
  };
  if (parts.faces->GetNumberOfPolys() == 0) {
    const auto dots = makeMarks(parts.free_points, FREE, settings.point_size);
    showColors(settings.coloring == Coloring::RGB
                   ? colorAsPoints(parts, *parts.free_points)
                   : colorByDepth(parts, settings.view),
               *dots);
    renderer.AddActor(dots);
    return;
  }
  if (settings.boundaries) {
    add_marks(parts.boundaries, BOUNDARY, 2.0);
    add_marks(parts.overfull, OVERFULL, 3.0);
  }
  if (settings.coloring == Coloring::ROLE) {
    add_marks(parts.free_points, FREE, settings.point_size);
    add_marks(parts.boundary_points, BOUNDARY, settings.point_size + 1.0);
  }
}

} // namespace

std::string
drawPng(const MeshParts& parts, const RenderSettings& settings)
{
  const auto renderer = makeRenderer();
  addParts(parts, settings, *renderer);
  aimCamera(parts.positions, settings, *renderer->GetActiveCamera());
  return drawPng({renderer}, settings.width, settings.height);
}

} // namespace app
