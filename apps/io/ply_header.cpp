// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a PLY file says it holds.
#include "ply_header.h"

#include "remarks.h"
#include "wording.h"

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

/** Reads the lines of a header one after the other. */
class HeaderParser {
public:
  explicit HeaderParser(PlyHeader& header) : header_(header) {}

  Status
  addLine(std::string_view line)
  {
    TextScanner words(line.data(), line.data() + line.size());
    std::string_view keyword;
    if (!words.nextWord(keyword))
      return {};
    const std::string_view rest(words.position(), words.remaining());
    if (keyword == "comment")
      addComment(rest, header_.remarks);
    if (keyword == "obj_info")
      addInfo(rest);
    if (keyword == "comment" || keyword == "obj_info")
      return {};
    if (keyword == "format")
      return addFormat(words);
    if (keyword == "element")
      return addElement(words);
    if (keyword == "property")
      return addProperty(words);
    return bad(line);
  }

  bool
  hasFormat() const
  {
    return has_format_;
  }

private:
  static Status
  bad(std::string_view line)
  {
    return Status::error("its header has the line '" + std::string(line.substr(0, 40)) +
                         "', which is not PLY");
  }

  void
  addInfo(std::string_view text)
  {
    Remarks info;
    addComment(text, info);
    for (const std::string& line : info.comments)
      header_.remarks.infos.push_back(line);
  }

  Status
  addFormat(TextScanner& words)
  {
    std::string_view name;
    words.nextWord(name);
    has_format_ = true;
    if (name == "ascii")
      header_.format = PlyFormat::ASCII;
    else if (name == "binary_little_endian")
      header_.format = PlyFormat::BINARY_LITTLE;
    else if (name == "binary_big_endian")
      header_.format = PlyFormat::BINARY_BIG;
    else
      return bad("format " + std::string(name));
    return {};
  }

  Status
  addElement(TextScanner& words)
  {
    std::string_view name;
    std::string_view count;
    PlyElement element;
    std::uint64_t rows = 0;
    if (!words.nextWord(name) || !words.nextWord(count) || !parseNumber(count, rows))
      return bad("element " + std::string(name) + " " + std::string(count));
    element.name = name;
    element.rows = static_cast<std::size_t>(rows);
    header_.elements.push_back(element);
    return {};
  }

  Status
  addProperty(TextScanner& words)
  {
    std::string_view type;
    std::string_view count_type;
    std::string_view name;
    words.nextWord(type);
    PlyProperty property;
    const bool is_list = type == "list";
    if (is_list) {
      words.nextWord(count_type);
      property.count_type = plyType(count_type);
      words.nextWord(type);
    }
    words.nextWord(name);
    property.type = plyType(type);
    property.name = name;
    const bool bad_count =
        is_list && (property.count_type == 0 || isFloating(property.count_type));
    if (header_.elements.empty() || property.type == 0 || name.empty() || bad_count)
      return bad("property " + std::string(type) + " " + std::string(name));
    header_.elements.back().properties.push_back(property);
    return {};
  }

  PlyHeader& header_;
  bool has_format_ = false;
};

Status
checkRowCounts(const PlyHeader& header, std::size_t bytes_left)
{
  for (const PlyElement& element : header.elements) {
    const std::size_t row = element.minimumRowBytes(header.format);
    // The last number of an ASCII file needs no space behind it.
    const std::size_t slack = header.format == PlyFormat::ASCII ? 1 : 0;
    if (row > 0 && element.rows > (bytes_left + slack) / row)
      return Status::error("it is too short for the " + plural(element.rows, "row") +
                           " of '" + element.name +
                           "' its header announces (truncated?)");
    bytes_left -= row * element.rows < bytes_left ? row * element.rows : bytes_left;
  }
  return {};
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

Status
readPlyHeader(TextScanner& scanner, PlyHeader& header)
{
  std::string_view line;
  if (!scanner.nextLine(line) || line.substr(0, 3) != "ply")
    return Status::error("it does not begin with 'ply'");
  HeaderParser parser(header);
  for (;;) {
    if (!scanner.nextLine(line))
      return Status::error("its PLY header has no end");
    if (line.substr(0, 10) == "end_header")
      break;
    const Status status = parser.addLine(line);
    if (!status.ok())
      return status;
  }
  if (!parser.hasFormat())
    return Status::error("its PLY header names no format");
  return checkRowCounts(header, scanner.remaining());
}

} // namespace app
