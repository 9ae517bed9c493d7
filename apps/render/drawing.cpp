// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what all pictures are put together from.
#include "render/drawing.h"

#include <vtkLightKit.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

namespace app {
namespace {

vtkSmartPointer<vtkActor>
makeActor(vtkPolyData* part, const Color& color)
{
  // Marks lie exactly on the faces; this pulls them in front.
  vtkMapper::SetResolveCoincidentTopologyToPolygonOffset();
  const auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(part);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  return actor;
}

} // namespace

vtkSmartPointer<vtkActor>
makeFaces(vtkPolyData* part, const Color& front, const Color& back)
{
  auto actor = makeActor(part, front);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.1);
  actor->GetProperty()->SetDiffuse(0.9);
  const auto back_property = vtkSmartPointer<vtkProperty>::New();
  back_property->DeepCopy(actor->GetProperty());
  back_property->SetColor(back[0], back[1], back[2]);
  actor->SetBackfaceProperty(back_property);
  return actor;
}

void
brighten(vtkActor& faces)
{
  for (vtkProperty* const side : {faces.GetProperty(), faces.GetBackfaceProperty()}) {
    side->SetAmbient(0.5);
    side->SetDiffuse(0.5);
  }
}

vtkSmartPointer<vtkActor>
makeMarks(vtkPolyData* part, const Color& color, double size)
{
  auto actor = makeActor(part, color);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(size));
  actor->GetProperty()->SetPointSize(static_cast<float>(size));
  return actor;
}

void
showColors(vtkPolyData* part, vtkActor& actor)
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor.GetMapper());
  mapper->SetInputData(part);
  mapper->ScalarVisibilityOn();
}

vtkSmartPointer<vtkRenderer>
makeRenderer()
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1.0, 1.0, 1.0);
  const auto lights = vtkSmartPointer<vtkLightKit>::New();
  lights->SetKeyLightIntensity(0.9);
  lights->SetKeyToFillRatio(2.5);
  lights->AddLightsToRenderer(renderer);
  return renderer;
}

Painter::Painter(int width, int height)
: window_(vtkSmartPointer<vtkRenderWindow>::New())
{
  window_->SetOffScreenRendering(1);
  window_->SetMultiSamples(8);
  window_->SetSize(width, height);
}

std::string
Painter::draw(const std::vector<vtkSmartPointer<vtkRenderer>>& renderers)
{
  for (const auto& renderer : renderers)
    window_->AddRenderer(renderer);
  window_->Render();
  const std::string bytes = encodePng(*window_);
  for (const auto& renderer : renderers)
    window_->RemoveRenderer(renderer);
  return bytes;
}

std::string
drawPng(const std::vector<vtkSmartPointer<vtkRenderer>>& renderers,
        int width,
        int height)
{
  return Painter(width, height).draw(renderers);
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

} // namespace app
