// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: writes inspection layers for other programs to open.
#include "inspection_files.h"

#include "io/point_columns.h"
#include "io/position_check.h"
#include "io/wording.h"
#include "io/writers.h"

#include <set>

namespace app {
namespace {

void
writeLayer(const InspectionLayer& layer, OutputFile& file)
{
  if (layer.name.substr(layer.name.size() - 4) == ".pcd")
    return writePcd(layer.cloud, {}, file);
  if (layer.faces.empty())
    return writeVtkLines(layer.cloud, layer.lines, file);
  pcl::PolygonMesh mesh;
  mesh.cloud = layer.cloud;
  mesh.polygons = layer.faces;
  writeVtk(mesh, {}, file);
}

void
explain(const InspectionLayer& layer, OutputFile& file)
{
  file.text("\n" + layer.name + ": " + layer.title + "\n");
  for (const auto& [color, meaning] : layer.legend)
    file.text(formatted("  #%02x%02x%02x  ", color[0], color[1], color[2]) + meaning +
              "\n");
  if (!layer.columns.empty())
    file.text("  fields: " + layer.columns + "\n");
}

} // namespace

const std::vector<std::string>&
inspectionNames()
{
  static const std::vector<std::string> names{"loops.vtk",
                                              "islands.vtk",
                                              "lines.vtk",
                                              "line_normals.vtk",
                                              "line_points.pcd",
                                              "origins.pcd",
                                              "free_points.pcd",
                                              "slice.vtk",
                                              "section.vtk",
                                              "loops.png",
                                              "islands.png",
                                              "lines.png",
                                              "slice.png",
                                              "legend.txt"};
  return names;
}

void
writeInspection(const std::vector<InspectionLayer>& layers,
                const std::vector<InspectionPicture>& pictures,
                const pcl::GlobalShift& shift,
                OutputFolder& folder)
{
  std::set<std::string> written{"legend.txt"};
  OutputFile& legend = folder.add("legend.txt");
  legend.text(
      "What pcl_repair_holes --inspect found. Open the files together, such as\n"
      "  pcl_viewer origins.pcd islands.vtk loops.vtk lines.vtk\n"
      "  pcl_viewer line_points.pcd -normals 1\n"
      "pcl_viewer turns to a cloud by itself; for .vtk files alone press r.\n"
      "A file is left out when there is nothing to put in it.\n");
  if (!shift.isNone())
    legend.text("All is drawn near the origin; the global shift to be added is " +
                placeText(shift.offset()) + ".\n");
  for (const InspectionLayer& layer : layers) {
    if (pointCount(layer.cloud) == 0)
      continue;
    writeLayer(layer, folder.add(layer.name));
    explain(layer, legend);
    written.insert(layer.name);
  }
  for (const InspectionPicture& picture : pictures) {
    folder.add(picture.name).text(picture.bytes);
    written.insert(picture.name);
  }
  for (const std::string& name : inspectionNames())
    if (written.count(name) == 0)
      folder.drop(name);
}

} // namespace app
