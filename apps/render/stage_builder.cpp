// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what is drawn of one step of the method.
#include "render/stage_builder.h"

#include <vtkProperty.h>

#include "io/point_columns.h"
#include "render/drawing.h"
#include "render/mesh_parts.h"

#include <utility>

namespace app {
namespace {

std::string
withCount(const std::string& meaning, vtkIdType count)
{
  return meaning + " (" + std::to_string(count) + ")";
}

} // namespace

StageBuilder::StageBuilder(std::string name, std::string title, std::string text)
{
  stage_.name = std::move(name);
  stage_.title = std::move(title);
  stage_.text = std::move(text);
}

void
StageBuilder::addSurface(vtkPolyData* faces, const Rgb& outer, const Rgb& inner)
{
  if (faces->GetNumberOfPolys() == 0)
    return;
  auto actor = makeFaces(faces, toColor(outer), toColor(inner));
  brighten(*actor);
  actor->GetProperty()->SetEdgeColor(MESH_EDGE[0], MESH_EDGE[1], MESH_EDGE[2]);
  actor->GetBackfaceProperty()->SetEdgeColor(MESH_EDGE[0], MESH_EDGE[1], MESH_EDGE[2]);
  stage_.parts.push_back({Layer::SURFACE, actor, 0.0});
}

void
StageBuilder::addSurface(vtkPolyData* faces,
                         const Rgb& outer,
                         const std::string& meaning)
{
  addSurface(faces, outer, INNER_SIDE_PALE);
  if (faces->GetNumberOfPolys() > 0)
    addLegend(Layer::SURFACE, outer, withCount(meaning, faces->GetNumberOfPolys()));
}

void
StageBuilder::addMarks(Layer layer,
                       vtkPolyData* marks,
                       const Rgb& color,
                       double size,
                       const std::string& meaning)
{
  if (marks->GetNumberOfCells() == 0)
    return;
  const vtkIdType count = marks->GetNumberOfLines() + marks->GetNumberOfVerts();
  stage_.parts.push_back({layer, makeMarks(marks, toColor(color), size), size});
  if (!meaning.empty())
    addLegend(layer, color, withCount(meaning, count));
}

void
StageBuilder::addColored(Layer layer, vtkPolyData* marks, double size)
{
  auto actor = makeMarks(marks, toColor(BOUNDARY_GREY), size);
  showColors(marks, *actor);
  stage_.parts.push_back({layer, actor, size});
}

void
StageBuilder::addLayer(Layer layer, const InspectionLayer& content, double size)
{
  if (pointCount(content.cloud) == 0)
    return;
  addColored(layer, makePart(content), size);
  for (const LegendEntry& entry : content.legend)
    stage_.legend.push_back({layer, entry});
}

void
StageBuilder::addLegend(Layer layer, const Rgb& color, const std::string& meaning)
{
  stage_.legend.push_back({layer, {color, meaning}});
}

void
StageBuilder::setText(const std::string& text)
{
  stage_.text = text;
}

Stage
StageBuilder::finish()
{
  return std::move(stage_);
}

} // namespace app
