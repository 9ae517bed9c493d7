// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads and writes clouds and meshes by the ending of their
// name.
#pragma once

#include "file_format.h"
#include "model.h"
#include "output_file.h"

#include <string>
#include <utility>

namespace app {

/** \brief Endings of names, for usage texts. */
constexpr const char* cloud_endings =
    ".pcd .ply .obj .xyz (.txt .pts .csv) .vtk .stl .off";
constexpr const char* mesh_endings = ".ply .vtk .obj .stl .off";
constexpr const char* mesh_output_endings = ".ply .vtk .obj .off .stl";
constexpr const char* cloud_output_endings = ".pcd .ply .xyz";

/** \brief Read the points of a file with all their fields; a mesh gives its vertices.
 * The ending of the name tells the format; of standard input ("-") its first bytes do.
 *
 * Fails with one sentence for a file that cannot be opened, is a folder, is cut off or
 * damaged, has an unknown ending or has no x, y, z; never takes more memory than a
 * small multiple of the file's length. \a model is of no use then. */
Status
readCloud(const std::string& path, Model& model);

/** \brief Read a mesh with all fields of its vertices. Polygons are kept as they are; a
 * corner out of range fails. A file without faces gives a mesh without polygons. */
Status
readMesh(const std::string& path, Model& model);

/** \brief Read polygons, too, if the format can hold any. */
Status
readModel(const std::string& path, Model& model);

/** \brief The same for bytes in memory, with any bytes. */
Status
parseCloud(FileFormat format, const char* bytes, std::size_t size, Model& model);
Status
parseMesh(FileFormat format, const char* bytes, std::size_t size, Model& model);

/** \brief Where a model goes, and in which format. */
struct Target {
  /** \brief The ending tells the format; "-" is standard output, and PLY. */
  Target(std::string name);                               // NOLINT: a name is a target
  Target(const char* name) : Target(std::string(name)) {} // NOLINT
  Target(std::string name, FileFormat as) : path(std::move(name)), format(as) {}

  std::string path;
  FileFormat format;
};

/** \brief Fails when \a target has no format for a mesh, or cannot be written. */
Status
checkMeshOutput(const Target& target);

/** \brief Fails when \a target has no format for a cloud, or cannot be written. */
Status
checkCloudOutput(const Target& target);

/** \brief Whether the format can hold a cloud, or a mesh. */
bool
isCloudOutput(const Target& target);
bool
isMeshOutput(const Target& target);

/** \brief Fails when the coordinates of \a model are too large for the format (doubles,
 * for STL): what it would hold is of no use. */
void
checkCoordinates(const Target& target, const Model& model);

/** \brief Whether the format can hold points without a triangle (STL cannot). */
bool
holdsFreePoints(const Target& target);

/** \brief Whether the format can hold numbers of single triangles under a name of ours
 * (PLY). */
bool
holdsFaceProperties(const Target& target);

/** \brief Write \a mesh into the file opened for \a target, in its format. Nothing has
 * its name before OutputFile::commit(). \a warnings gets what the format cannot hold.
 */
void
writeMesh(const Target& target,
          const pcl::PolygonMesh& mesh,
          const FileExtras& extras,
          OutputFile& file,
          Warnings& warnings);

/** \brief The same for the points alone. */
void
writeCloud(const Target& target,
           const pcl::PCLPointCloud2& cloud,
           const FileExtras& extras,
           OutputFile& file);

} // namespace app
