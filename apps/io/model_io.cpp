// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads and writes clouds and meshes by the ending of their
// name.
#include "model_io.h"

#include "point_columns.h"
#include "polygon_builder.h"
#include "position_check.h"
#include "readers.h"
#include "remarks.h"
#include "wording.h"
#include "writers.h"

#include <algorithm>
#include <string_view>

namespace app {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/** What a caller can make use of. */
enum class Wanted { CLOUD, MESH, EITHER };

bool
holdsPolygons(FileFormat format)
{
  return format == FileFormat::PLY || format == FileFormat::VTK ||
         format == FileFormat::OBJ || format == FileFormat::STL ||
         format == FileFormat::OFF;
}

Status
unknownEnding(const std::string& path, const char* known)
{
  return Status::error("'" + path + "' has no ending known here: " + known);
}

void
parseAs(FileFormat format, Contents contents, InputFile& file, Model& model)
{
  if (file.bytes().substr(0, 3) == byte_order_mark && format != FileFormat::STL)
    file.skip(byte_order_mark.size());
  if (format == FileFormat::OBJ || format == FileFormat::OFF ||
      format == FileFormat::PCD || format == FileFormat::XYZ)
    readUnitComments(file, format == FileFormat::OFF ? 1 : 0, model.remarks);
  switch (format) {
  case FileFormat::PLY:
    return readPly(file, contents, model);
  case FileFormat::PCD:
    return readPcd(file, model);
  case FileFormat::OBJ:
    return readObj(file, model);
  case FileFormat::OFF:
    return readOff(file, model);
  case FileFormat::STL:
    return readStl(file, model);
  case FileFormat::VTK:
    return readVtk(file, model);
  case FileFormat::XYZ:
    return readXyz(file, model);
  case FileFormat::UNKNOWN:
    break;
  }
  throw Failure("its format is not known");
}

/** \a wanted tells what to read of a format that holds polygons. */
Status
parse(FileFormat format, Wanted wanted, InputFile& file, Model& model)
{
  if (wanted == Wanted::MESH && !holdsPolygons(format))
    return Status::error("a mesh is needed, and this holds points only");
  const bool with_polygons = wanted != Wanted::CLOUD;
  const auto contents =
      with_polygons ? Contents::POINTS_AND_POLYGONS : Contents::POINTS;
  try {
    parseAs(format, contents, file, model);
    if (with_polygons)
      checkPolygonIndices(model.mesh.polygons, pointCount(model.mesh.cloud));
    else
      model.mesh.polygons.clear();
    checkPositions(model);
    return {};
  }
  catch (const Failure& failure) {
    return Status::error(failure.what());
  }
}

Status
read(const std::string& path, Wanted wanted, Model& model)
{
  FileFormat format = formatOfPath(path);
  const bool is_wanted =
      wanted == Wanted::MESH ? holdsPolygons(format) : format != FileFormat::UNKNOWN;
  if (!is_wanted && !isStandardStream(path))
    return unknownEnding(path, wanted == Wanted::MESH ? mesh_endings : cloud_endings);
  InputFile file;
  Status status = file.open(path);
  if (!status.ok())
    return status;
  if (isStandardStream(path))
    format = formatOfBytes(file.bytes());
  status = parse(format, wanted, file, model);
  return status.ok() ? status
                     : Status::error("cannot read " + nameForPeople(path) + ": " +
                                     status.message());
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
    if (field.name != "_" &&
        std::find(kept.begin(), kept.end(), field.name) == kept.end())
      addToList(lost, field.name);
  if (!lost.empty())
    warnings.push_back(format + " cannot hold the fields " + lost);
}

} // namespace

Target::Target(std::string name)
: path(std::move(name))
, format(isStandardStream(path) ? FileFormat::PLY : formatOfPath(path))
{}

bool
isCloudOutput(const Target& target)
{
  return target.format == FileFormat::PCD || target.format == FileFormat::PLY ||
         target.format == FileFormat::XYZ;
}

bool
isMeshOutput(const Target& target)
{
  return holdsPolygons(target.format);
}

void
checkCoordinates(const Target& target, const Model& model)
{
  if (target.format == FileFormat::STL && !model.shift.isNone() &&
      hasDoublePositions(model.mesh.cloud))
    throw Failure("STL holds single precision only, too coarse for coordinates as "
                  "large as these; write .ply, .vtk, .obj or .off");
}

bool
holdsFreePoints(const Target& target)
{
  return target.format != FileFormat::STL;
}

bool
holdsFaceProperties(const Target& target)
{
  return target.format == FileFormat::PLY;
}

Status
readCloud(const std::string& path, Model& model)
{
  return read(path, Wanted::CLOUD, model);
}

Status
readMesh(const std::string& path, Model& model)
{
  return read(path, Wanted::MESH, model);
}

Status
readModel(const std::string& path, Model& model)
{
  return read(path, Wanted::EITHER, model);
}

Status
parseCloud(FileFormat format, const char* bytes, std::size_t size, Model& model)
{
  InputFile file(bytes, size);
  return parse(format, Wanted::CLOUD, file, model);
}

Status
parseMesh(FileFormat format, const char* bytes, std::size_t size, Model& model)
{
  InputFile file(bytes, size);
  return parse(format, Wanted::MESH, file, model);
}

Status
checkMeshOutput(const Target& target)
{
  return isMeshOutput(target) ? OutputFile::check(target.path)
                              : unknownEnding(target.path, mesh_output_endings);
}

Status
checkCloudOutput(const Target& target)
{
  return isCloudOutput(target) ? OutputFile::check(target.path)
                               : unknownEnding(target.path, cloud_output_endings);
}

void
writeMesh(const Target& target,
          const pcl::PolygonMesh& mesh,
          const FileExtras& extras,
          OutputFile& file,
          Warnings& warnings)
{
  const bool is_obj = target.format == FileFormat::OBJ;
  if (target.format == FileFormat::PLY)
    writePly(mesh, extras, true, file);
  if (target.format == FileFormat::VTK)
    writeVtk(mesh, extras, file);
  if (is_obj)
    writeObj(mesh, extras.remarks, file);
  if (target.format == FileFormat::OFF)
    writeOff(mesh, extras.remarks, file);
  if (is_obj || target.format == FileFormat::OFF)
    warnAboutLostFields(
        mesh.cloud,
        {"x", "y", "z", "rgb", "rgba", "normal_x", "normal_y", "normal_z"},
        is_obj ? "OBJ" : "OFF",
        warnings);
  if (target.format == FileFormat::STL) {
    writeStl(mesh, file);
    warnings.push_back(
        "STL holds triangles only: no points without a triangle, no order of points");
    if (hasDoublePositions(mesh.cloud))
      warnings.push_back("STL holds single precision only: positions were rounded");
    warnAboutLostFields(mesh.cloud, {"x", "y", "z"}, "STL", warnings);
  }
}

void
writeCloud(const Target& target,
           const pcl::PCLPointCloud2& cloud,
           const FileExtras& extras,
           OutputFile& file)
{
  if (target.format == FileFormat::PCD)
    writePcd(cloud, extras, file);
  else if (target.format == FileFormat::XYZ)
    writeXyz(cloud, extras.remarks, file);
  else {
    pcl::PolygonMesh mesh;
    mesh.cloud = cloud;
    writePly(mesh, extras, false, file);
  }
}

} // namespace app
