// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pictures of what a survey found.
#include "render/inspection_pictures.h"

#include <Eigen/Geometry>

#include <vtkProperty.h>

#include "io/point_columns.h"
#include "render/camera.h"
#include "render/drawing.h"
#include "render/legend.h"
#include "render/mesh_parts.h"
#include "render/stage_builder.h"

#include <algorithm>
#include <map>

namespace app {
namespace {

/** \brief Width of lines that are not to be looked at, as in stage_builder.h. */
constexpr double THINNEST = 1.0;

/** \brief What a picture has to hold, and the directions it is seen from. */
struct Cameras {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> views;
  Eigen::Vector3d up;
};

/** \brief All there is to draw from: the layers by their names. */
struct Studio {
  std::map<std::string, const InspectionLayer*> layers;
  InspectionView settings;

  const InspectionLayer&
  operator[](const std::string& name) const
  {
    return *layers.at(name);
  }
};

StageBuilder
beginPicture(const std::string& name, const InspectionLayer& layer)
{
  return {name, layer.title, ""};
}

void
addThinBoundary(const Studio& studio, StageBuilder& stage)
{
  stage.addMarks(
      Layer::LINES, makePart(studio["loops.vtk"]), BOUNDARY_GREY, THINNEST, "");
}

Stage
loopPicture(const Studio& studio)
{
  StageBuilder stage = beginPicture("loops.png", studio["loops.vtk"]);
  stage.addSurface(makePart(studio["islands.vtk"]), OUTER_SIDE_PALE, INNER_SIDE_PALE);
  stage.addLayer(Layer::LINES, studio["loops.vtk"], THICK);
  stage.addLegend(Layer::SURFACE, INNER_SIDE_PALE, "inner side of the surface");
  return stage.finish();
}

Stage
islandPicture(const Studio& studio)
{
  const InspectionLayer& islands = studio["islands.vtk"];
  StageBuilder stage = beginPicture("islands.png", islands);
  const auto part = makePart(islands);
  // Colours of points are those of both sides: each side is drawn by itself.
  const auto add_side = [&](const Rgb& color) {
    const auto side = makeFaces(part, toColor(color), toColor(color));
    brighten(*side);
    stage.addActor(Layer::SURFACE, side);
    return side;
  };
  const auto front = add_side(OUTER_SIDE_PALE);
  showColors(part, *front);
  front->GetProperty()->BackfaceCullingOn();
  add_side(INNER_SIDE_DARK)->GetProperty()->FrontfaceCullingOn();
  addThinBoundary(studio, stage);
  for (const LegendEntry& entry : islands.legend)
    stage.addLegend(Layer::SURFACE, entry.color, entry.meaning);
  stage.addLegend(Layer::SURFACE, INNER_SIDE_DARK, "inner side of the surface");
  return stage.finish();
}

Stage
linePicture(const Studio& studio)
{
  StageBuilder stage = beginPicture("lines.png", studio["lines.vtk"]);
  stage.addSurface(makePart(studio["islands.vtk"]), OUTER_SIDE_PALE, INNER_SIDE_PALE);
  addThinBoundary(studio, stage);
  stage.addLayer(Layer::LINES, studio["lines.vtk"], MEDIUM);
  stage.addLayer(Layer::NORMALS, studio["line_normals.vtk"], THINNEST);
  stage.addLayer(Layer::POINTS, studio["free_points.pcd"], MEDIUM);
  stage.addLegend(Layer::LINES, BOUNDARY_GREY, "boundary");
  return stage.finish();
}

/** \brief The slice and the section are moved behind the model, so that the boundaries
 * before and behind the plane are seen as well. \a towards is the direction to the
 * camera. */
Stage
slicePicture(const Eigen::Vector3d& towards, const Studio& studio)
{
  Eigen::AlignedBox3d box;
  for (const auto& position : positionsOf(studio["islands.vtk"]))
    box.extend(position);
  StageBuilder builder = beginPicture("slice.png", studio["slice.vtk"]);
  builder.addLayer(Layer::SURFACE, studio["slice.vtk"], THINNEST);
  builder.addLayer(Layer::LINES, studio["section.vtk"], THICK);
  addThinBoundary(studio, builder);
  builder.addLegend(Layer::LINES, BOUNDARY_GREY, "boundary, seen through the plane");
  Stage stage = builder.finish();
  const bool has_section = pointCount(studio["section.vtk"].cloud) > 0;
  for (std::size_t i = 0; i < (has_section ? 2U : 1U); ++i) {
    const double times = i == 0 ? 1.1 : 1.0;
    const Eigen::Vector3d shift = -times * box.sizes().norm() * towards.normalized();
    stage.parts[i].actor->SetPosition(shift.x(), shift.y(), shift.z());
  }
  return stage;
}

/** \brief The legend at the left, the views side by side at its right. */
InspectionPicture
draw(const Stage& stage, const Cameras& cameras, const Studio& studio)
{
  const int width = studio.settings.width;
  const int height = studio.settings.height;
  Legend legend;
  legend.title = stage.title;
  for (const StageColor& color : stage.legend)
    legend.entries.push_back(color.entry);
  std::vector<vtkSmartPointer<vtkRenderer>> renderers{
      makeLegend(legend, width, height)};
  const double first = static_cast<double>(legendWidth(height)) / width;
  const double share = (1.0 - first) / static_cast<double>(cameras.views.size());
  double left = first;
  for (const auto& view : cameras.views) {
    const auto renderer = makeRenderer();
    renderer->SetViewport(left, 0.0, left + share, 1.0);
    for (const StagePart& part : stage.parts) {
      const auto size = static_cast<float>(part.size * height / 900.0);
      if (part.size > 0.0)
        part.actor->GetProperty()->SetLineWidth(size);
      if (part.size > 0.0)
        part.actor->GetProperty()->SetPointSize(size);
      renderer->AddActor(part.actor);
    }
    RenderSettings camera;
    camera.width = std::max(1, static_cast<int>(share * width));
    camera.height = height;
    camera.view = view;
    camera.up = cameras.up;
    aimCamera(cameras.positions, camera, *renderer->GetActiveCamera());
    renderers.push_back(renderer);
    left += share;
  }
  return {stage.name, drawPng(renderers, width, height)};
}

/** \brief The whole model, from where the user says or from where most is seen. */
Cameras
aimAtModel(const pcl::repair::ModelSurvey& survey, const Studio& studio)
{
  const auto& settings = studio.settings;
  Cameras cameras;
  cameras.positions = positionsOf(studio["islands.vtk"]);
  cameras.views = settings.view ? std::vector<Eigen::Vector3d>{*settings.view}
                                : chooseViews(survey);
  cameras.up = settings.up.value_or(chooseUp(survey, cameras.views.front()));
  return cameras;
}

/** \brief The slice, from the side that the model is seen from. */
Cameras
aimAtSlice(const pcl::repair::ModelSurvey& survey,
           const pcl::repair::FieldSlice& slice,
           const Cameras& at_model,
           const Studio& studio)
{
  Eigen::Vector3d normal = slice.across.cross(slice.up).normalized();
  if (normal.dot(at_model.views.front()) < 0.0)
    normal = -normal;
  const auto up = studio.settings.up.value_or(chooseUp(survey, normal));
  return {positionsOf(studio["slice.vtk"]), {normal}, up};
}

} // namespace

std::vector<InspectionPicture>
drawInspection(const pcl::repair::ModelSurvey& survey,
               const pcl::repair::FieldSlice& slice,
               const std::vector<InspectionLayer>& layers,
               const InspectionView& view)
{
  Studio studio;
  studio.settings = view;
  for (const InspectionLayer& layer : layers)
    studio.layers[layer.name] = &layer;
  const auto holds = [&](const char* name) {
    return pointCount(studio[name].cloud) > 0;
  };
  const Cameras at_model = aimAtModel(survey, studio);
  std::vector<InspectionPicture> pictures;
  pictures.push_back(draw(islandPicture(studio), at_model, studio));
  if (holds("loops.vtk"))
    pictures.push_back(draw(loopPicture(studio), at_model, studio));
  if (holds("lines.vtk"))
    pictures.push_back(draw(linePicture(studio), at_model, studio));
  if (holds("slice.vtk")) {
    const Cameras at_slice = aimAtSlice(survey, slice, at_model, studio);
    pictures.push_back(
        draw(slicePicture(at_slice.views.front(), studio), at_slice, studio));
  }
  return pictures;
}

} // namespace app
