// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a writer for each format.
#pragma once

#include "model.h"
#include "output_file.h"
#include "point_columns.h"

#include <vector>

namespace app {

/** \brief Binary little-endian PLY with all fields; colours as red, green, blue bytes
 * and normals as nx, ny, nz, as PCL and MeshLab expect. A mesh without polygons and a
 * cloud differ in nothing but an empty face element, left out for \a with_faces false.
 * A viewpoint becomes the element "camera" that PCL reads and writes. 64-bit whole
 * numbers, which PLY does not know, become doubles (exact up to 2^53). */
void
writePly(const pcl::PolygonMesh& mesh,
         const FileExtras& extras,
         bool with_faces,
         OutputFile& file);

/** \brief How much a PLY file holds. */
struct PlyCounts {
  std::size_t vertices = 0;
  std::size_t faces = 0;
  bool has_faces = true;
  bool wide = false; /**< a face has more than 255 corners */
};

/** \brief Writes a PLY file from parts that need not be in memory together: the head at
 * once, then all points, the camera if there is one, then all faces. */
class PlyParts {
public:
  /** \param[in] layout a cloud with the fields of all points; its points do not matter
   */
  PlyParts(const pcl::PCLPointCloud2& layout,
           const PlyCounts& counts,
           const FileExtras& extras,
           OutputFile& file);

  void
  points(const pcl::PCLPointCloud2& cloud);

  /** \brief A face of numbers of 32 bits; its properties follow, each an int. */
  void
  faceBytes(const void* corners, std::size_t count);

private:
  std::vector<PointColumn> columns_;
  bool wide_count_;
  OutputFile& file_;
};

/** \brief Legacy VTK, binary, with all fields; colours as COLOR_SCALARS "RGB". Points
 * of no polygon are cells of their own, with -1 for a property of faces. */
void
writeVtk(const pcl::PolygonMesh& mesh, const FileExtras& extras, OutputFile& file);

/** \brief The same for lines along the points of a cloud. */
void
writeVtkLines(const pcl::PCLPointCloud2& cloud,
              const std::vector<pcl::Vertices>& lines,
              OutputFile& file);

/** \brief Wavefront OBJ with colours and normals; other fields have no place there. */
void
writeObj(const pcl::PolygonMesh& mesh, const Remarks& remarks, OutputFile& file);

/** \brief ASCII OFF, COFF, NOFF or CNOFF: positions, normals and colours. */
void
writeOff(const pcl::PolygonMesh& mesh, const Remarks& remarks, OutputFile& file);

/** \brief Binary STL: triangles only, no fields and no points without a triangle. */
void
writeStl(const pcl::PolygonMesh& mesh, OutputFile& file);

/** \brief Binary PCD with all fields, sizes, the viewpoint and the remarks. */
void
writePcd(const pcl::PCLPointCloud2& cloud, const FileExtras& extras, OutputFile& file);

/** \brief One line of numbers per point, under a comment line with their names, by
 * which readXyz() knows them again. */
void
writeXyz(const pcl::PCLPointCloud2& cloud, const Remarks& remarks, OutputFile& file);

} // namespace app
