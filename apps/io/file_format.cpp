// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the formats of files, told by name or by content.
#include "file_format.h"

#include "text_scanner.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace app {
namespace {

constexpr std::array<std::pair<const char*, FileFormat>, 10> ENDINGS{
    {{".ply", FileFormat::PLY},
     {".pcd", FileFormat::PCD},
     {".obj", FileFormat::OBJ},
     {".off", FileFormat::OFF},
     {".stl", FileFormat::STL},
     {".vtk", FileFormat::VTK},
     {".xyz", FileFormat::XYZ},
     {".txt", FileFormat::XYZ},
     {".pts", FileFormat::XYZ},
     {".csv", FileFormat::XYZ}}};

bool
startsWith(std::string_view text, std::string_view start)
{
  return text.substr(0, start.size()) == start;
}

bool
isOneOf(std::string_view word, std::initializer_list<const char*> words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

/** First line that is neither empty nor a comment. */
std::string_view
firstDataLine(std::string_view bytes)
{
  TextScanner scanner(bytes);
  std::string_view line;
  while (scanner.nextLine(line)) {
    while (!line.empty() && TextScanner::isSpace(line.front()))
      line.remove_prefix(1);
    if (!line.empty() && line.front() != '#')
      return line;
  }
  return {};
}

/** Binary STL has no mark, but its length is told in it; the rest of the file may not
 * be there yet, so the count is only asked to be no text. */
bool
looksBinary(std::string_view bytes)
{
  const auto start = bytes.substr(0, 512);
  return start.size() > 84 && start.find('\0') != std::string_view::npos;
}

} // namespace

std::string
nameForPeople(const std::string& path, const char* stream)
{
  return isStandardStream(path) ? stream : "'" + path + "'";
}

FileFormat
formatOfPath(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending)
    c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  for (const auto& [known, format] : ENDINGS)
    if (ending == known)
      return format;
  return FileFormat::UNKNOWN;
}

FileFormat
formatOfName(std::string name)
{
  return name.find('.') == std::string::npos ? formatOfPath("a." + name)
                                             : FileFormat::UNKNOWN;
}

const char*
endingOf(FileFormat format)
{
  for (const auto& [ending, known] : ENDINGS)
    if (known == format)
      return ending;
  return "";
}

FileFormat
formatOfBytes(std::string_view bytes)
{
  if (startsWith(bytes, "\xEF\xBB\xBF"))
    bytes.remove_prefix(3);
  if (startsWith(bytes, "ply"))
    return FileFormat::PLY;
  if (startsWith(bytes, "# vtk"))
    return FileFormat::VTK;
  if (startsWith(bytes, "# .PCD"))
    return FileFormat::PCD;
  if (looksBinary(bytes) && bytes.substr(0, 80).find("VERSION") == bytes.npos)
    return FileFormat::STL;
  const std::string_view line = firstDataLine(bytes);
  TextScanner words(line);
  std::string_view word;
  words.nextWord(word);
  if (isOneOf(word, {"VERSION", "FIELDS", "COLUMNS"}))
    return FileFormat::PCD;
  if (isOneOf(word, {"OFF", "COFF", "NOFF", "CNOFF"}))
    return FileFormat::OFF;
  if (word == "solid")
    return FileFormat::STL;
  if (isOneOf(word, {"v", "vn", "vt", "o", "g", "mtllib", "usemtl", "s"}))
    return FileFormat::OBJ;
  double number = 0;
  const bool is_numbers = std::any_of(
      word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
  return is_numbers && parseNumber(word.substr(0, word.find_first_of(",;")), number)
             ? FileFormat::XYZ
             : FileFormat::UNKNOWN;
}

} // namespace app
