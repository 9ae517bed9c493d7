// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads and writes clouds and meshes by the ending of their
// name.
#include "model_io.h"

#include "cloud_writers.h"
#include "mesh_writers.h"
#include "obj_reader.h"
#include "off_reader.h"
#include "pcd_reader.h"
#include "ply_reader.h"
#include "point_columns.h"
#include "polygon_builder.h"
#include "position_check.h"
#include "stl_reader.h"
#include "vtk_reader.h"
#include "xyz_reader.h"

#include <algorithm>
#include <filesystem>

namespace app {
namespace {

std::string
endingOf(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending)
    c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return ending;
}

bool
isOneOf(const std::string& ending, std::initializer_list<const char*> endings)
{
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

Status
unknownEnding(const std::string& path, const char* known)
{
  return Status::error("'" + path + "' has no ending known here: " + known);
}

bool
isText(const std::string& ending)
{
  return isOneOf(ending, {".xyz", ".txt", ".pts", ".csv"});
}

Status
parse(const std::string& ending, Contents contents, const InputFile& file, Model& model)
{
  if (ending == ".ply")
    return readPly(file, contents, model);
  if (ending == ".pcd")
    return readPcd(file, model);
  if (ending == ".obj")
    return readObj(file, model);
  if (ending == ".off")
    return readOff(file, model);
  if (ending == ".stl")
    return readStl(file, model);
  if (ending == ".vtk")
    return readVtk(file, model);
  return readXyz(file, model);
}

Status
read(const std::string& path, Contents contents, Model& model)
{
  InputFile file;
  Status status = file.open(path);
  if (!status.ok())
    return status;
  status = parse(endingOf(path), contents, file, model);
  const std::size_t points = pointCount(model.mesh.cloud);
  if (status.ok() && contents == Contents::POINTS_AND_POLYGONS)
    status = checkPolygonIndices(model.mesh.polygons, points);
  if (!status.ok())
    return Status::error("cannot read '" + path + "': " + status.message());
  checkPositions(model);
  return {};
}

/** Names of the fields which a format that knows only \a kept cannot hold. */
void
warnAboutLostFields(const pcl::PCLPointCloud2& cloud,
                    std::initializer_list<const char*> kept,
                    const std::string& format,
                    Warnings& warnings)
{
  std::string lost;
  for (const pcl::PCLPointField& field : cloud.fields)
    if (field.name != "_" && !isOneOf(field.name, kept))
      lost += (lost.empty() ? "" : ", ") + field.name;
  if (!lost.empty())
    warnings.push_back(format + " cannot hold the fields " + lost);
}

} // namespace

bool
isMeshInput(const std::string& path)
{
  return isOneOf(endingOf(path), {".ply", ".vtk", ".obj", ".stl", ".off"});
}

bool
isCloudOutput(const std::string& path)
{
  return isOneOf(endingOf(path), {".pcd", ".ply", ".xyz"});
}

bool
isMeshOutput(const std::string& path)
{
  return isOneOf(endingOf(path), {".ply", ".vtk", ".obj", ".stl"});
}

bool
holdsFreePoints(const std::string& path)
{
  return endingOf(path) != ".stl";
}

bool
holdsFaceProperties(const std::string& path)
{
  return endingOf(path) == ".ply";
}

Status
readCloud(const std::string& path, Model& model)
{
  const std::string ending = endingOf(path);
  if (!isText(ending) && !isOneOf(ending, {".pcd", ".ply", ".obj"}))
    return unknownEnding(path, cloud_endings);
  const Status status = read(path, Contents::POINTS, model);
  model.mesh.polygons.clear();
  return status;
}

Status
readMesh(const std::string& path, Model& model)
{
  if (!isMeshInput(path))
    return unknownEnding(path, mesh_endings);
  return read(path, Contents::POINTS_AND_POLYGONS, model);
}

Status
checkMeshOutput(const std::string& path)
{
  return isMeshOutput(path) ? OutputFile::check(path)
                            : unknownEnding(path, mesh_output_endings);
}

Status
checkCloudOutput(const std::string& path)
{
  return isCloudOutput(path) ? OutputFile::check(path)
                             : unknownEnding(path, cloud_output_endings);
}

void
writeMesh(const std::string& path,
          const pcl::PolygonMesh& mesh,
          const std::vector<FaceProperty>& properties,
          OutputFile& file,
          Warnings& warnings)
{
  const std::string ending = endingOf(path);
  if (ending == ".ply")
    writePly(mesh, properties, true, file);
  if (ending == ".vtk")
    writeVtk(mesh, properties, file);
  if (ending == ".obj") {
    writeObj(mesh, file);
    warnAboutLostFields(
        mesh.cloud,
        {"x", "y", "z", "rgb", "rgba", "normal_x", "normal_y", "normal_z"},
        "OBJ",
        warnings);
  }
  if (ending == ".stl") {
    writeStl(mesh, file);
    warnings.push_back(
        "STL holds triangles only: no points without a triangle, no order "
        "of points");
    warnAboutLostFields(mesh.cloud, {"x", "y", "z"}, "STL", warnings);
  }
}

void
writeCloud(const std::string& path,
           const pcl::PCLPointCloud2& cloud,
           const Viewpoint& viewpoint,
           OutputFile& file)
{
  const std::string ending = endingOf(path);
  if (ending == ".pcd")
    writePcd(cloud, viewpoint, file);
  else if (ending == ".xyz")
    writeXyz(cloud, file);
  else {
    pcl::PolygonMesh mesh;
    mesh.cloud = cloud;
    writePly(mesh, {}, false, file);
  }
}

} // namespace app
