// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a reader for each format; each throws a Failure for a file
// that it cannot understand.
#pragma once

#include "input_file.h"
#include "model.h"
#include "point_table.h"

namespace app {

/** \brief What of a file is wanted. */
enum class Contents { POINTS, POINTS_AND_POLYGONS };

/** \brief PLY: all vertex properties become fields (red, green, blue become rgb, nx
 * becomes normal_x); faces of any number of corners and triangle strips become
 * polygons.
 */
void
readPly(const InputFile& file, Contents contents, Model& model);

/** \brief PCL's own format. All fields keep their names and types; width and height of
 * an organised cloud stay. The viewpoint counts as known when it is not the origin,
 * which PCL writes when it knows no better. */
void
readPcd(const InputFile& file, Model& model);

/** \brief Where the points of a PLY or PCD file lie, for who reads them in portions.
 * \param[out] head all but the points: fields, viewpoint, remarks, warnings
 * \return false where they cannot be: compressed PCD, vertices with lists of numbers */
bool
findPlyRecords(const InputFile& file, PointRecords& records, Model& head);
bool
findPcdRecords(const InputFile& file, PointRecords& records, Model& head);

/** \brief OBJ: vertices (with colours, if each has one), normals (if each vertex gets
 * one) and faces. Texture coordinates, materials, groups and lines are not taken over.
 */
void
readObj(const InputFile& file, Model& model);

/** \brief ASCII OFF, with normals (NOFF) and vertex colours (COFF, also CNOFF). Colours
 * of faces are not taken over. */
void
readOff(const InputFile& file, Model& model);

/** \brief ASCII or binary STL. The format repeats the position of each corner; corners
 * at the same position become one vertex, in order of first appearance. */
void
readStl(const InputFile& file, Model& model);

/** \brief A legacy .vtk file with DATASET POLYDATA, ASCII or binary, as VTK 3 to 9
 * writes it: points, polygons, triangle strips and all point data; of an
 * UNSTRUCTURED_GRID the flat cells. Lines, single vertices and cell data are not taken
 * over. */
void
readVtk(const InputFile& file, Model& model);

/** \brief .xyz, .txt, .pts and .csv: numbers between spaces, tabs, commas or
 * semicolons, at least three on a line; lines that begin with # or // are comments.
 *
 * A heading (the first line, with or without #) that has a name for each column, the
 * first three being x, y and z, names the fields. Without one, a fourth number is an
 * intensity; the last three of 6 or 7 numbers are a colour if all are whole and 0 to
 * 255, else those of 6 are a normal; others are called field_4, field_5, ... A single
 * number on the first line (.pts) is the number of points and passed over. */
void
readXyz(const InputFile& file, Model& model);

} // namespace app
