// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: pictures of what a survey found.
#include "render/inspection_pictures.h"

#include <Eigen/Geometry>

#include <vtkProperty.h>

#include "io/point_columns.h"
#include "render/camera.h"
#include "render/drawing.h"
#include "render/layer_parts.h"
#include "render/legend.h"
#include "render/surface_colors.h"
#include "render/view_choice.h"

#include <algorithm>
#include <functional>
#include <map>

namespace app {
namespace {

using Parts = std::map<std::string, vtkSmartPointer<vtkPolyData>>;

constexpr Color PALE = toColor(OUTER_SIDE_PALE);
constexpr Color PALE_BACK = toColor(INNER_SIDE_PALE);
constexpr Color INNER_SIDE = toColor(INNER_SIDE_DARK);

/** \brief Widths of lines and dots, in pixels of a picture 900 high. */
constexpr double THICK = 4.0;
constexpr double MEDIUM = 2.5;
constexpr double THIN = 1.0;

/** \brief What a picture has to hold, and the directions it is seen from. */
struct Cameras {
  std::vector<Eigen::Vector3d> positions;
  std::vector<Eigen::Vector3d> views;
  Eigen::Vector3d up;
};

/** \brief All there is to draw from. */
struct Studio {
  std::map<std::string, const InspectionLayer*> layers;
  Parts parts;
  InspectionView settings;

  double
  scaled(double pixels) const
  {
    return pixels * settings.height / 900.0;
  }
};

/** \brief What one picture shows: actors are made anew for each view of it. */
struct Scene {
  std::string name;
  std::vector<std::string> legend_layers;
  std::vector<LegendEntry> more_legend;
  std::function<void(vtkRenderer&)> fill;
};

vtkSmartPointer<vtkActor>
makeSurface(vtkPolyData* part, const Color& front, const Color& back)
{
  auto actor = makeFaces(part, front, back);
  brighten(*actor);
  return actor;
}

vtkSmartPointer<vtkActor>
makeColored(vtkPolyData* part, double size)
{
  auto actor = makeMarks(part, PALE, size);
  showColors(part, *actor);
  return actor;
}

vtkSmartPointer<vtkActor>
makeThinBoundary(const Studio& studio)
{
  return makeMarks(
      studio.parts.at("loops.vtk"), toColor(BOUNDARY_GREY), studio.scaled(THIN));
}

double
diagonalOf(const InspectionLayer& layer)
{
  Eigen::AlignedBox3d box;
  for (const auto& position : positionsOf(layer))
    box.extend(position);
  return box.sizes().norm();
}

Scene
loopScene(const Studio& studio)
{
  return {"loops.png",
          {"loops.vtk"},
          {{INNER_SIDE_PALE, "inner side of the surface"}},
          [&studio](vtkRenderer& renderer) {
            renderer.AddActor(
                makeSurface(studio.parts.at("islands.vtk"), PALE, PALE_BACK));
            renderer.AddActor(
                makeColored(studio.parts.at("loops.vtk"), studio.scaled(THICK)));
          }};
}

Scene
islandScene(const Studio& studio)
{
  return {"islands.png",
          {"islands.vtk"},
          {{INNER_SIDE_DARK, "inner side of the surface"}},
          [&studio](vtkRenderer& renderer) {
            const auto& part = studio.parts.at("islands.vtk");
            // Colours of points are those of both sides: each side is drawn by itself.
            const auto front = makeSurface(part, PALE, PALE);
            showColors(part, *front);
            front->GetProperty()->BackfaceCullingOn();
            const auto back = makeSurface(part, INNER_SIDE, INNER_SIDE);
            back->GetProperty()->FrontfaceCullingOn();
            renderer.AddActor(front);
            renderer.AddActor(back);
            renderer.AddActor(makeThinBoundary(studio));
          }};
}

Scene
lineScene(const Studio& studio)
{
  return {"lines.png",
          {"lines.vtk", "line_normals.vtk", "free_points.pcd"},
          {{BOUNDARY_GREY, "boundary"}},
          [&studio](vtkRenderer& renderer) {
            renderer.AddActor(
                makeSurface(studio.parts.at("islands.vtk"), PALE, PALE_BACK));
            renderer.AddActor(makeThinBoundary(studio));
            renderer.AddActor(
                makeColored(studio.parts.at("lines.vtk"), studio.scaled(MEDIUM)));
            renderer.AddActor(
                makeColored(studio.parts.at("line_normals.vtk"), studio.scaled(THIN)));
            renderer.AddActor(
                makeColored(studio.parts.at("free_points.pcd"), studio.scaled(MEDIUM)));
          }};
}

/** \brief The slice and the section are moved behind the model, so that the boundaries
 * before and behind the plane are seen as well. \a towards is the direction to the
 * camera.
 */
Scene
sliceScene(const Eigen::Vector3d& towards, const Studio& studio)
{
  const Eigen::Vector3d back =
      -towards.normalized() * diagonalOf(*studio.layers.at("islands.vtk"));
  const auto add_behind = [back](vtkRenderer& renderer, vtkActor* actor, double times) {
    const Eigen::Vector3d shift = times * back;
    actor->SetPosition(shift.x(), shift.y(), shift.z());
    renderer.AddActor(actor);
  };
  return {"slice.png",
          {"slice.vtk", "section.vtk"},
          {{BOUNDARY_GREY, "boundary, seen through the plane"}},
          [&studio, add_behind](vtkRenderer& renderer) {
            add_behind(renderer, makeColored(studio.parts.at("slice.vtk"), THIN), 1.1);
            add_behind(
                renderer,
                makeColored(studio.parts.at("section.vtk"), studio.scaled(THICK)),
                1.0);
            renderer.AddActor(makeThinBoundary(studio));
          }};
}

Legend
legendOf(const Scene& scene, const Studio& studio)
{
  Legend legend;
  for (const std::string& name : scene.legend_layers) {
    const InspectionLayer& layer = *studio.layers.at(name);
    if (legend.title.empty())
      legend.title = layer.title;
    if (pointCount(layer.cloud) > 0)
      legend.entries.insert(
          legend.entries.end(), layer.legend.begin(), layer.legend.end());
  }
  legend.entries.insert(
      legend.entries.end(), scene.more_legend.begin(), scene.more_legend.end());
  return legend;
}

/** \brief The legend at the left, the views side by side at its right. */
InspectionPicture
draw(const Scene& scene, const Cameras& cameras, const Studio& studio)
{
  const int width = studio.settings.width;
  const int height = studio.settings.height;
  std::vector<vtkSmartPointer<vtkRenderer>> renderers{
      makeLegend(legendOf(scene, studio), width, height)};
  const double first = static_cast<double>(legendWidth(height)) / width;
  const double share = (1.0 - first) / static_cast<double>(cameras.views.size());
  double left = first;
  for (const auto& view : cameras.views) {
    const auto renderer = makeRenderer();
    renderer->SetViewport(left, 0.0, left + share, 1.0);
    scene.fill(*renderer);
    RenderSettings camera;
    camera.width = std::max(1, static_cast<int>(share * width));
    camera.height = height;
    camera.view = view;
    camera.up = cameras.up;
    aimCamera(cameras.positions, camera, *renderer->GetActiveCamera());
    renderers.push_back(renderer);
    left += share;
  }
  return {scene.name, drawPng(renderers, width, height)};
}

/** \brief The whole model, from where the user says or from where most is seen. */
Cameras
aimAtModel(const pcl::repair::ModelSurvey& survey, const Studio& studio)
{
  const auto& settings = studio.settings;
  Cameras cameras;
  cameras.positions = positionsOf(*studio.layers.at("islands.vtk"));
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
  return {positionsOf(*studio.layers.at("slice.vtk")), {normal}, up};
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
  for (const InspectionLayer& layer : layers) {
    studio.layers[layer.name] = &layer;
    studio.parts[layer.name] = makePart(layer);
  }
  const auto holds = [&](const char* name) {
    return pointCount(studio.layers.at(name)->cloud) > 0;
  };
  const Cameras at_model = aimAtModel(survey, studio);
  std::vector<InspectionPicture> pictures;
  pictures.push_back(draw(islandScene(studio), at_model, studio));
  if (holds("loops.vtk"))
    pictures.push_back(draw(loopScene(studio), at_model, studio));
  if (holds("lines.vtk"))
    pictures.push_back(draw(lineScene(studio), at_model, studio));
  if (holds("slice.vtk")) {
    const Cameras at_slice = aimAtSlice(survey, slice, at_model, studio);
    pictures.push_back(
        draw(sliceScene(at_slice.views.front(), studio), at_slice, studio));
  }
  return pictures;
}

} // namespace app
