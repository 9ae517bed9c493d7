// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: draws a mesh off-screen.
#include "render/picture.h"

#include <vtkActor.h>
#include <vtkLightKit.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include "render/camera.h"
#include "render/point_colors.h"

#include <array>

namespace app {
namespace {

using Color = std::array<double, 3>;

constexpr Color WHITE{1.0, 1.0, 1.0};
constexpr Color FRONT{0.62, 0.74, 0.86};     // grey blue
constexpr Color BACK{0.95, 0.60, 0.15};      // orange: holes and flips stand out
constexpr Color MESH_EDGE{0.15, 0.20, 0.28}; // dark grey
constexpr Color BOUNDARY{0.85, 0.0, 0.05};   // red
constexpr Color OVERFULL{0.85, 0.0, 0.85};   // magenta
constexpr Color FREE{0.05, 0.15, 0.75};      // blue

vtkSmartPointer<vtkActor>
makeActor(vtkPolyData* part, const Color& color)
{
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(part);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  return actor;
}

/** \brief Faces, flat shaded: smoothing would hide a triangle that sticks out. */
vtkSmartPointer<vtkActor>
makeFaces(const MeshParts& parts, const RenderSettings& settings)
{
  const auto actor = makeActor(parts.faces, FRONT);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.1);
  actor->GetProperty()->SetDiffuse(0.9);
  const auto back = vtkSmartPointer<vtkProperty>::New();
  back->DeepCopy(actor->GetProperty());
  back->SetColor(BACK[0], BACK[1], BACK[2]);
  actor->SetBackfaceProperty(back);
  if (settings.edges) {
    actor->GetProperty()->EdgeVisibilityOn();
    actor->GetProperty()->SetEdgeColor(MESH_EDGE[0], MESH_EDGE[1], MESH_EDGE[2]);
  }
  return actor;
}

/** \brief Lines or dots, unlit, so that their colour is the same everywhere. */
vtkSmartPointer<vtkActor>
makeMarks(vtkPolyData* part, const Color& color, double size)
{
  auto actor = makeActor(part, color);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(size));
  actor->GetProperty()->SetPointSize(static_cast<float>(size));
  return actor;
}

/** \brief Draw \a part, which has a colour per point, in place of the actor's own. */
void
showColors(vtkPolyData* part, vtkActor& actor)
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor.GetMapper());
  mapper->SetInputData(part);
  mapper->ScalarVisibilityOn();
}

void
addParts(const MeshParts& parts, const RenderSettings& settings, vtkRenderer& renderer)
{
  // Marks lie exactly on the faces; this pulls them in front.
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  const auto faces = makeFaces(parts, settings);
  if (settings.coloring == Coloring::COMPONENT)
    showColors(colorComponents(parts), *faces);
  renderer.AddActor(faces);

  const auto add_marks = [&](vtkPolyData* part, const Color& color, double size) {
    renderer.AddActor(makeMarks(part, color, size));
  };
  if (parts.faces->GetNumberOfPolys() == 0) {
    const auto dots = makeMarks(parts.free_points, FREE, settings.point_size);
    showColors(colorByDepth(parts, settings.view), *dots);
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

/** \brief A key light from above the camera, softened from the sides and behind. */
void
addLights(vtkRenderer& renderer)
{
  const auto lights = vtkSmartPointer<vtkLightKit>::New();
  lights->SetKeyLightIntensity(0.9);
  lights->SetKeyToFillRatio(2.5);
  lights->AddLightsToRenderer(&renderer);
}

std::string
encodePng(vtkRenderWindow& window)
{
  const auto image = vtkSmartPointer<vtkWindowToImageFilter>::New();
  image->SetInput(&window);
  image->ReadFrontBufferOff();
  image->Update();
  const auto writer = vtkSmartPointer<vtkPNGWriter>::New();
  writer->SetInputConnection(image->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr)
    return {};
  const unsigned char* begin = bytes->GetPointer(0);
  return {begin, begin + bytes->GetNumberOfValues()};
}

} // namespace

std::string
drawPng(const MeshParts& parts, const RenderSettings& settings)
{
  const auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(WHITE[0], WHITE[1], WHITE[2]);
  addParts(parts, settings, *renderer);
  addLights(*renderer);
  aimCamera(parts.positions, settings, *renderer->GetActiveCamera());

  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(settings.width, settings.height);
  window->AddRenderer(renderer);
  window->Render();
  return encodePng(*window);
}

} // namespace app
