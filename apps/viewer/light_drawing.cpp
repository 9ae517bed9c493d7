// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is drawn of large parts while something happens.
#include "viewer/light_drawing.h"

#include <vtkBinnedDecimation.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkMaskPoints.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/** Triangles or dots that a computer without a graphics card draws several times a
 * second. */
constexpr vtkIdType LIGHT_CELLS = 100000;

/** Triangles or dots that are drawn without a look at what has happened. */
constexpr vtkIdType SLICE_CELLS = 250000;

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

/** Some cells of a part that has only polygons or only dots. */
vtkSmartPointer<vtkPolyData>
sliceOf(vtkPolyData& part, vtkIdType begin, vtkIdType end)
{
  const bool is_surface = part.GetNumberOfPolys() > 0;
  vtkCellArray& all = is_surface ? *part.GetPolys() : *part.GetVerts();
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->Use32BitStorage();
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  for (vtkIdType cell = begin; cell < end; ++cell) {
    all.GetCellAtId(cell, size, corners);
    cells->InsertNextCell(size, corners);
  }
  cells->Squeeze();
  auto slice = vtkSmartPointer<vtkPolyData>::New();
  slice->SetPoints(part.GetPoints());
  slice->GetPointData()->ShallowCopy(part.GetPointData());
  is_surface ? slice->SetPolys(cells) : slice->SetVerts(cells);
  slice->GetCellData()->CopyAllocate(part.GetCellData(), end - begin);
  for (vtkIdType cell = begin; cell < end; ++cell)
    slice->GetCellData()->CopyData(part.GetCellData(), cell, cell - begin);
  return slice;
}

/** \brief Draws a part slice by slice, and stops in between when the window says so. */
class SlicedMapper : public vtkPolyDataMapper {
public:
  static SlicedMapper*
  New();

  /** \brief Draw this, as another mapper does. */
  void
  slice(vtkPolyData& part, vtkMapper& like)
  {
    SetInputData(&part);
    ScalarVisibilityOff();
    const vtkIdType count = part.GetNumberOfCells();
    for (vtkIdType begin = 0; begin < count; begin += SLICE_CELLS)
      slices_.push_back(
          mapperLike(like, sliceOf(part, begin, std::min(count, begin + SLICE_CELLS))));
  }

  void
  Render(vtkRenderer* renderer, vtkActor* actor) override
  {
    vtkRenderWindow& window = *renderer->GetRenderWindow();
    for (const auto& slice : slices_) {
      slice->Render(renderer, actor);
      window.WaitForCompletion();
      if (window.CheckAbortStatus() != 0)
        return;
    }
  }

  void
  RenderPiece(vtkRenderer* /*renderer*/, vtkActor* /*actor*/) override
  {}

  void
  ReleaseGraphicsResources(vtkWindow* window) override
  {
    for (const auto& slice : slices_)
      slice->ReleaseGraphicsResources(window);
  }

private:
  std::vector<vtkSmartPointer<vtkMapper>> slices_;
};

vtkStandardNewMacro(SlicedMapper);

} // namespace

bool
LightDrawing::lighten(vtkActor& actor)
{
  auto* const part = vtkPolyData::SafeDownCast(actor.GetMapper()->GetInput());
  if (part == nullptr || part->GetNumberOfCells() <= LIGHT_CELLS ||
      part->GetNumberOfLines() > 0)
    return false;
  Mappers& mappers = mappers_[part];
  if (!mappers.coarse) {
    mappers.coarse =
        mapperLike(*actor.GetMapper(),
                   part->GetNumberOfPolys() > 0 ? coarseFaces(*part) : someDots(*part));
    const auto sliced = vtkSmartPointer<SlicedMapper>::New();
    sliced->slice(*part, *actor.GetMapper());
    mappers.sliced = sliced;
  }
  sliced_.emplace_back(&actor, mappers.sliced);
  actor.SetMapper(mappers.coarse);
  return true;
}

void
LightDrawing::restore()
{
  for (const auto& [actor, mapper] : sliced_)
    actor->SetMapper(mapper);
  sliced_.clear();
}

} // namespace app
