// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: keeps scans from being written over.
#include "overwriting.h"

#include "model_io.h"
#include "ply_header.h"
#include "remarks.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace app {
namespace {

/** As much of a file as tells what it is. */
constexpr std::size_t beginning_bytes = 4096;

bool may_lose_clouds = false;

/** Scanners' formats that only others can read: LAS and E57. */
bool
isForeignScan(std::string_view bytes)
{
  return bytes.substr(0, 4) == "LASF" || bytes.substr(0, 8) == "ASTM-E57";
}

/** Without its last line, which may be cut off, if there are several. */
std::string_view
wholeLines(std::string_view bytes)
{
  const std::size_t end = bytes.find_last_of("\r\n");
  return end == std::string_view::npos ? bytes : bytes.substr(0, end);
}

bool
isText(std::string_view beginning)
{
  const std::string_view lines = wholeLines(beginning);
  Model ignored;
  return parseCloud(FileFormat::XYZ, lines.data(), lines.size(), ignored).ok();
}

/** A header that cannot be understood tells of no triangles. */
bool
plyHasFaces(std::string_view bytes)
{
  try {
    TextScanner scanner(bytes);
    const PlyHeader header = readPlyHeader(scanner);
    return std::any_of(
        header.elements.begin(), header.elements.end(), [](const PlyElement& element) {
          return element.rows > 0 &&
                 (element.name == "face" || element.name == "tristrips");
        });
  }
  catch (const Failure&) {
    return false;
  }
}

bool
hasPolygons(FileFormat format, const InputFile& file)
{
  Model model;
  return parseMesh(format, file.begin(), file.size(), model).ok() &&
         !model.mesh.polygons.empty();
}

bool
isCloud(const InputFile& file)
{
  const std::string_view bytes = file.bytes();
  const FileFormat format = formatOfBytes(bytes);
  switch (format) {
  case FileFormat::PCD:
    return true;
  case FileFormat::PLY:
    return !plyHasFaces(bytes);
  case FileFormat::OBJ:
  case FileFormat::OFF:
  case FileFormat::VTK:
    return !hasPolygons(format, file);
  case FileFormat::STL:
    return false;
  case FileFormat::XYZ:
  case FileFormat::UNKNOWN:
    break;
  }
  return isForeignScan(bytes) || isText(bytes.substr(0, beginning_bytes));
}

} // namespace

void
allowLosingClouds(bool allowed)
{
  may_lose_clouds = allowed;
}

Status
checkReplaceable(const std::string& path)
{
  std::error_code error;
  if (may_lose_clouds || isStandardStream(path) ||
      !std::filesystem::is_regular_file(path, error))
    return {};
  InputFile file;
  if (!file.open(path).ok())
    return {};
  const std::string_view bytes = file.bytes();
  if (carriesOurMark(bytes.substr(0, beginning_bytes)) || !isCloud(file))
    return {};
  return Status::error("'" + path +
                       "' holds points without triangles that were not written by this "
                       "software, such as a scan; choose another name, or --force to "
                       "write over it");
}

} // namespace app
