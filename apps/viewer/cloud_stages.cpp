// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the viewer's stages from a cloud to a mesh.
#include "inspect/inspection_colors.h"
#include "inspect/layer_builder.h"
#include "io/point_columns.h"
#include "render/drawing.h"
#include "render/mesh_parts.h"
#include "render/point_colors.h"
#include "render/stage_builder.h"
#include "viewer/stages.h"
#include "viewer/viewer_run.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace app {
namespace {

/** \brief The points of a model with some polygons. */
MeshParts
partsOf(const Model& model, const std::vector<pcl::Vertices>& polygons)
{
  return takeApart(model.mesh.cloud, polygons, model.shift);
}

/** \brief The finite points in the colours that they have. */
vtkSmartPointer<vtkPolyData>
coloredPoints(const Model& model, std::size_t color_offset)
{
  LayerBuilder points("cloud.pcd", "Points in their own colours");
  const pcl::PCLPointCloud2& cloud = model.mesh.cloud;
  const std::vector<Eigen::Vector3f> positions = readPositions(cloud, model.shift);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!positions[i].allFinite())
      continue;
    std::uint32_t packed = 0;
    std::memcpy(&packed, pointAt(cloud, i) + color_offset, sizeof(packed));
    points.addPoint(positions[i].cast<double>(),
                    {static_cast<std::uint8_t>(packed >> 16),
                     static_cast<std::uint8_t>(packed >> 8),
                     static_cast<std::uint8_t>(packed)});
  }
  return makePart(points.finish(""));
}

Stage
cloudStage(const ViewerRun& run, const Eigen::Vector3d& view)
{
  StageBuilder stage("cloud", "Cloud", "The points as they were read.");
  const MeshParts parts = partsOf(run.input, {});
  const std::string count = " (" + std::to_string(parts.positions.size()) + ")";
  std::size_t offset = 0;
  if (findColour(run.input.mesh.cloud, offset)) {
    stage.addColored(Layer::POINTS, coloredPoints(run.input, offset), MEDIUM);
    stage.addLegend(
        Layer::POINTS, ROLE_INTERNAL, "points in their own colours" + count);
    return stage.finish();
  }
  stage.addColored(Layer::POINTS, colorByDepth(parts, view), MEDIUM);
  stage.addLegend(
      Layer::POINTS, toRgb(colorOfNearness(1.0)), "near points; in all" + count);
  stage.addLegend(Layer::POINTS, toRgb(colorOfNearness(0.0)), "far points");
  return stage.finish();
}

/** \brief The corners, each once and in an order that does not depend on the winding.
 */
std::vector<pcl::index_t>
cornersOf(const pcl::Vertices& polygon)
{
  std::vector<pcl::index_t> corners(polygon.vertices.begin(), polygon.vertices.end());
  std::sort(corners.begin(), corners.end());
  return corners;
}

/** \brief The polygons of \a all that are among \a kept, and the others. */
std::pair<std::vector<pcl::Vertices>, std::vector<pcl::Vertices>>
sortOut(const std::vector<pcl::Vertices>& all, const std::vector<pcl::Vertices>& kept)
{
  std::vector<std::vector<pcl::index_t>> known;
  for (const pcl::Vertices& polygon : kept)
    known.push_back(cornersOf(polygon));
  std::sort(known.begin(), known.end());
  std::pair<std::vector<pcl::Vertices>, std::vector<pcl::Vertices>> parts;
  for (const pcl::Vertices& polygon : all)
    (std::binary_search(known.begin(), known.end(), cornersOf(polygon)) ? parts.first
                                                                        : parts.second)
        .push_back(polygon);
  return parts;
}

Stage
startStage(const ViewerRun& run)
{
  StageBuilder stage("start",
                     "Start: raw triangles",
                     "GreedyStart joins the points fast. Some triangles are wrong, and "
                     "they are wound in any way.");
  const auto [kept, removed] = sortOut(run.start, run.filtered);
  const auto kept_faces = partsOf(run.input, kept).faces;
  stage.addSurface(kept_faces, OUTER_SIDE_PALE, RAW_BACK);
  if (!kept.empty())
    stage.addLegend(Layer::SURFACE,
                    OUTER_SIDE_PALE,
                    "triangles (" + std::to_string(run.start.size()) + ")");
  if (!run.start.empty())
    stage.addLegend(Layer::INNER_SIDE, RAW_BACK, "seen from their back");
  const auto removed_faces = partsOf(run.input, removed).faces;
  stage.addSurface(removed_faces, REMOVED_CORAL, REMOVED_CORAL);
  if (!removed.empty())
    stage.addLegend(Layer::SURFACE,
                    REMOVED_CORAL,
                    "not kept by the filter (" + std::to_string(removed.size()) + ")");
  const MeshParts parts = partsOf(run.input, run.start);
  stage.addMarks(
      Layer::LINES, parts.overfull, OVERFULL_MAGENTA, MEDIUM, "edges of three or more");
  stage.addMarks(
      Layer::LINES, parts.boundaries, BOUNDARY_GREY, THIN, "edges of one triangle");
  return stage.finish();
}

Stage
filterStage(const ViewerRun& run)
{
  StageBuilder stage("filter",
                     "Filter: correct triangles",
                     "UmbrellaFilter keeps what is a correct surface. Around an "
                     "internal point its triangles close like an umbrella.");
  const MeshParts parts = partsOf(run.input, run.filtered);
  stage.addSurface(parts.faces, OUTER_SIDE_PALE, "triangles kept");
  stage.addMarks(Layer::POINTS,
                 parts.internal_points,
                 ROLE_INTERNAL,
                 SMALL_DOT,
                 "internal points");
  stage.addMarks(
      Layer::POINTS, parts.boundary_points, ROLE_BOUNDARY, THICK, "boundary points");
  stage.addMarks(
      Layer::POINTS, parts.free_points, FREE_POINT_VIOLET, THICK, "free points");
  return stage.finish();
}

/** \brief A mesh before it is repaired; \a added are triangles told from the others. */
void
addMesh(const Model& model,
        const std::vector<pcl::Vertices>& given,
        const std::vector<pcl::Vertices>& added,
        StageBuilder& stage)
{
  std::vector<pcl::Vertices> all = given;
  all.insert(all.end(), added.begin(), added.end());
  const MeshParts parts = partsOf(model, all);
  const auto given_faces = added.empty() ? parts.faces : partsOf(model, given).faces;
  stage.addSurface(given_faces, OUTER_SIDE_PALE, "triangles");
  if (!added.empty())
    stage.addSurface(partsOf(model, added).faces, ADDED_TEAL, "triangles added");
  if (parts.faces->GetNumberOfPolys() > 0)
    stage.addLegend(Layer::INNER_SIDE, INNER_SIDE_PALE, "inner side");
  stage.addMarks(
      Layer::LINES, parts.boundaries, BOUNDARY_GREY, MEDIUM, "boundary edges");
  stage.addMarks(
      Layer::LINES, parts.overfull, OVERFULL_MAGENTA, THICK, "edges of three or more");
  stage.addMarks(
      Layer::POINTS, parts.free_points, FREE_POINT_VIOLET, DOT, "free points");
}

Stage
baseStage(const ViewerRun& run)
{
  StageBuilder stage("base",
                     "Base: completed surface",
                     "The base algorithm keeps these triangles and adds what is "
                     "missing as far as there are points.");
  addMesh(run.input, run.filtered, run.added, stage);
  return stage.finish();
}

} // namespace

std::vector<Stage>
cloudStages(const ViewerRun& run, const Eigen::Vector3d& view)
{
  return {cloudStage(run, view), startStage(run), filterStage(run), baseStage(run)};
}

Stage
meshStage(const ViewerRun& run)
{
  StageBuilder stage("mesh", "Mesh", "The mesh as it was read.");
  addMesh(run.input, run.input.mesh.polygons, {}, stage);
  return stage.finish();
}

} // namespace app
