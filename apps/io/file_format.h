// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the formats of files, told by name or by content.
#pragma once

#include <string>
#include <string_view>

namespace app {

/** \brief Formats of clouds and meshes; XYZ stands for all kinds of plain text. */
enum class FileFormat { UNKNOWN, PLY, PCD, OBJ, OFF, STL, VTK, XYZ };

/** \brief Stands for standard input or output in the place of a file name. */
constexpr const char* standard_stream = "-";

inline bool
isStandardStream(const std::string& path)
{
  return path == standard_stream;
}

/** \brief A file's name in quotes, or what "-" stands for, as messages have it. */
std::string
nameForPeople(const std::string& path, const char* stream = "standard input");

/** \brief Of the ending of a name, in any case; UNKNOWN for others. */
FileFormat
formatOfPath(const std::string& path);

/** \brief Of a name without a dot, such as "ply"; UNKNOWN for others. */
FileFormat
formatOfName(std::string name);

/** \brief The usual ending with its dot, such as ".ply". */
const char*
endingOf(FileFormat format);

/** \brief Of a file by its first bytes. PLY, PCD, VTK and OFF say what they are; of the
 * others only what begins as nearly all files of the format do is known. */
FileFormat
formatOfBytes(std::string_view bytes);

} // namespace app
