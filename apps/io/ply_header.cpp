// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a PLY file says it holds.
#include "ply_header.h"

#include "remarks.h"
#include "wording.h"

#include <algorithm>
#include <array>
#include <utility>

namespace app {
namespace {

using Field = pcl::PCLPointField;

ScalarType
plyType(std::string_view name)
{
  static const std::array<std::pair<std::string_view, ScalarType>, 16> names{
      {{"char", Field::INT8},
       {"int8", Field::INT8},
       {"uchar", Field::UINT8},
       {"uint8", Field::UINT8},
       {"short", Field::INT16},
       {"int16", Field::INT16},
       {"ushort", Field::UINT16},
       {"uint16", Field::UINT16},
       {"int", Field::INT32},
       {"int32", Field::INT32},
       {"uint", Field::UINT32},
       {"uint32", Field::UINT32},
       {"float", Field::FLOAT32},
       {"float32", Field::FLOAT32},
       {"double", Field::FLOAT64},
       {"float64", Field::FLOAT64}}};
  for (const auto& [spelling, type] : names)
    if (spelling == name)
      return type;
  return 0;
}

bool
isFloating(ScalarType type)
{
  return type == Field::FLOAT32 || type == Field::FLOAT64;
}

[[noreturn]] void
failAt(std::string_view line)
{
  throw Failure("its header has the line '" + std::string(line.substr(0, 40)) +
                "', which is not PLY");
}

PlyFormat
formatNamed(std::string_view name)
{
  if (name == "ascii")
    return PlyFormat::ASCII;
  if (name == "binary_little_endian")
    return PlyFormat::BINARY_LITTLE;
  if (name == "binary_big_endian")
    return PlyFormat::BINARY_BIG;
  failAt("format " + std::string(name));
}

PlyProperty
propertyOf(TextScanner& words)
{
  PlyProperty property;
  std::string_view type = words.word();
  const bool is_list = type == "list";
  if (is_list) {
    property.count_type = plyType(words.word());
    type = words.word();
  }
  property.type = plyType(type);
  property.name = words.word();
  const bool bad_count =
      is_list && (property.count_type == 0 || isFloating(property.count_type));
  if (property.type == 0 || property.name.empty() || bad_count)
    failAt("property " + std::string(type) + " " + property.name);
  return property;
}

/** \return whether the line names the format */
bool
addLine(std::string_view line, PlyHeader& header)
{
  TextScanner words(line);
  const std::string_view keyword = words.word();
  const std::string_view rest(words.position(), words.remaining());
  if (keyword == "comment")
    addComment(rest, header.remarks.comments);
  else if (keyword == "obj_info")
    addComment(rest, header.remarks.infos);
  else if (keyword == "format")
    header.format = formatNamed(words.word());
  else if (keyword == "element") {
    PlyElement& element = header.elements.emplace_back();
    element.name = words.word();
    if (!nextNumber(words, element.rows))
      failAt(line);
  }
  else if (keyword == "property" && !header.elements.empty())
    header.elements.back().properties.push_back(propertyOf(words));
  else if (!keyword.empty())
    failAt(line);
  return keyword == "format";
}

void
checkRowCounts(const PlyHeader& header, std::size_t bytes_left)
{
  for (const PlyElement& element : header.elements) {
    const std::size_t row = element.minimumRowBytes(header.format);
    // The last number of an ASCII file needs no space behind it.
    const std::size_t slack = header.format == PlyFormat::ASCII ? 1 : 0;
    if (row > 0 && element.rows > (bytes_left + slack) / row)
      throw Failure("it is too short for the " + plural(element.rows, "row") + " of '" +
                    element.name + "' its header announces (truncated?)");
    bytes_left -= std::min(row * element.rows, bytes_left);
  }
}

} // namespace

std::size_t
PlyElement::minimumRowBytes(PlyFormat format) const
{
  if (format == PlyFormat::ASCII)
    return 2 * properties.size();
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties)
    bytes += scalarSize(property.isList() ? property.count_type : property.type);
  return bytes;
}

PlyHeader
readPlyHeader(TextScanner& scanner)
{
  std::string_view line;
  if (!scanner.nextLine(line) || line.substr(0, 3) != "ply")
    throw Failure("it does not begin with 'ply'");
  PlyHeader header;
  bool has_format = false;
  while (scanner.nextLine(line) && line.substr(0, 10) != "end_header")
    has_format = addLine(line, header) || has_format;
  if (line.substr(0, 10) != "end_header")
    throw Failure("its PLY header has no end");
  if (!has_format)
    throw Failure("its PLY header names no format");
  checkRowCounts(header, scanner.remaining());
  return header;
}

} // namespace app
