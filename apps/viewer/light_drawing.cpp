// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is drawn of large parts while something happens.
#include "viewer/light_drawing.h"

#include <vtkBinnedDecimation.h>
#include <vtkMaskPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <cmath>

namespace app {
namespace {

/** Triangles or dots that a computer without a graphics card draws several times a
 * second. */
constexpr vtkIdType LIGHT_CELLS = 100000;

vtkSmartPointer<vtkPolyData>
coarseFaces(vtkPolyData& part)
{
  const auto bins = vtkSmartPointer<vtkBinnedDecimation>::New();
  // A surface passes about three times as many bins as a face of the box has, with two
  // triangles each.
  const auto divisions = static_cast<int>(std::sqrt(LIGHT_CELLS / 6.0));
  bins->SetInputData(&part);
  bins->SetNumberOfDivisions(divisions, divisions, divisions);
  bins->SetPointGenerationModeToBinPoints();
  bins->ProducePointDataOff();
  bins->Update();
  return bins->GetOutput();
}

vtkSmartPointer<vtkPolyData>
someDots(vtkPolyData& part)
{
  const auto mask = vtkSmartPointer<vtkMaskPoints>::New();
  mask->SetInputData(&part);
  mask->SetOnRatio(static_cast<int>(part.GetNumberOfVerts() / LIGHT_CELLS) + 1);
  mask->SetMaximumNumberOfPoints(part.GetNumberOfPoints());
  mask->GenerateVerticesOn();
  mask->SingleVertexPerCellOn();
  mask->Update();
  return mask->GetOutput();
}

/** Something else in the same colours. */
vtkSmartPointer<vtkMapper>
mapperLike(vtkMapper& mapper, vtkPolyData* part)
{
  auto light = vtkSmartPointer<vtkPolyDataMapper>::New();
  light->SetScalarVisibility(mapper.GetScalarVisibility());
  light->SetInputData(part);
  return light;
}

} // namespace

bool
LightDrawing::lighten(vtkActor& actor)
{
  auto* const part = vtkPolyData::SafeDownCast(actor.GetMapper()->GetInput());
  if (part == nullptr || part->GetNumberOfCells() <= LIGHT_CELLS ||
      part->GetNumberOfLines() > 0)
    return false;
  MapperPtr& coarse = coarse_[part];
  if (!coarse)
    coarse =
        mapperLike(*actor.GetMapper(),
                   part->GetNumberOfPolys() > 0 ? coarseFaces(*part) : someDots(*part));
  full_.emplace_back(&actor, actor.GetMapper());
  actor.SetMapper(coarse);
  return true;
}

void
LightDrawing::restore()
{
  for (const auto& [actor, mapper] : full_)
    actor->SetMapper(mapper);
  full_.clear();
}

} // namespace app
