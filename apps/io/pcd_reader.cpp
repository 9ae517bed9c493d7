// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads PCD, ASCII, binary and compressed.
#include "pcd_reader.h"

#include "lzf.h"
#include "point_table.h"
#include "wording.h"

#include <limits>

namespace app {
namespace {

using Field = pcl::ccaa::PointFieldNames;

ScalarType
pcdType(char kind, std::size_t size)
{
  const bool is_signed = kind == 'I';
  if (kind == 'F')
    return size == 4 ? Field::FLOAT32 : size == 8 ? Field::FLOAT64 : 0;
  if (kind != 'I' && kind != 'U')
    return 0;
  switch (size) {
  case 1:
    return is_signed ? Field::INT8 : Field::UINT8;
  case 2:
    return is_signed ? Field::INT16 : Field::UINT16;
  case 4:
    return is_signed ? Field::INT32 : Field::UINT32;
  case 8:
    return is_signed ? Field::INT64 : Field::UINT64;
  default:
    return 0;
  }
}

/** The header, line by line, until DATA. */
struct PcdHeader {
  std::vector<std::string> names;
  std::vector<std::size_t> sizes;
  std::vector<std::string> kinds;
  std::vector<std::size_t> counts;
  std::vector<double> viewpoint;
  std::size_t width = 0;
  std::size_t height = 1;
  std::size_t points = 0;
  bool has_points = false;
  bool has_width = false;
  std::string data;
};

template <typename T>
bool
readNumbers(TextScanner& words, std::vector<T>& numbers)
{
  std::string_view word;
  numbers.clear();
  while (words.nextWord(word)) {
    T value{};
    if (!parseNumber(word, value))
      return false;
    numbers.push_back(value);
  }
  return true;
}

void
readWords(TextScanner& words, std::vector<std::string>& texts)
{
  std::string_view word;
  texts.clear();
  while (words.nextWord(word))
    texts.emplace_back(word);
}

bool
readSize(TextScanner& words, std::size_t& value)
{
  std::string_view word;
  return words.nextWord(word) && parseNumber(word, value);
}

bool
readHeaderLine(std::string_view line, PcdHeader& header)
{
  TextScanner words(line.data(), line.data() + line.size());
  std::string_view keyword;
  if (!words.nextWord(keyword) || keyword.front() == '#' || keyword == "VERSION")
    return true;
  if (keyword == "FIELDS" || keyword == "COLUMNS")
    readWords(words, header.names);
  else if (keyword == "SIZE")
    return readNumbers(words, header.sizes);
  else if (keyword == "TYPE")
    readWords(words, header.kinds);
  else if (keyword == "COUNT")
    return readNumbers(words, header.counts);
  else if (keyword == "WIDTH")
    return header.has_width = readSize(words, header.width);
  else if (keyword == "HEIGHT")
    return readSize(words, header.height);
  else if (keyword == "VIEWPOINT")
    return readNumbers(words, header.viewpoint);
  else if (keyword == "POINTS")
    return header.has_points = readSize(words, header.points);
  else if (keyword == "DATA") {
    std::string_view kind;
    words.nextWord(kind);
    header.data = kind;
  }
  else
    return false;
  return true;
}

Status
readHeader(TextScanner& scanner, PcdHeader& header)
{
  std::string_view line;
  while (header.data.empty()) {
    if (!scanner.nextLine(line))
      return Status::error("its PCD header has no DATA line");
    if (!readHeaderLine(line, header))
      return Status::error("its header has the line '" +
                           std::string(line.substr(0, 40)) + "', which is not PCD");
  }
  // Old files have no WIDTH.
  if (header.has_points && !header.has_width) {
    header.width = header.points;
    header.height = 1;
  }
  if (header.width != 0 &&
      header.height > std::numeric_limits<int>::max() / header.width)
    return Status::error("its WIDTH times HEIGHT is too large");
  const std::size_t product = header.width * header.height;
  if (header.has_points && header.points != product)
    return Status::error("its POINTS is not WIDTH times HEIGHT");
  header.points = product;
  return {};
}

Status
makeColumns(const PcdHeader& header, std::vector<SourceColumn>& columns)
{
  const std::size_t fields = header.names.size();
  const bool has_counts = !header.counts.empty();
  if (fields == 0 || header.sizes.size() != fields || header.kinds.size() != fields ||
      (has_counts && header.counts.size() != fields))
    return Status::error("its FIELDS, SIZE, TYPE and COUNT lines do not match");
  for (std::size_t i = 0; i < fields; ++i) {
    const ScalarType type = pcdType(header.kinds[i].front(), header.sizes[i]);
    const std::size_t count = has_counts ? header.counts[i] : 1;
    if (type == 0 || count == 0 || count > most_numbers)
      return Status::error("its field '" + header.names[i] + "' has no valid type");
    columns.push_back({header.names[i], type, count});
  }
  return {};
}

Status
tooShort(const PcdHeader& header)
{
  return Status::error("it is too short for the " + plural(header.points, "point") +
                       " its header announces (truncated?)");
}

/** Lengths of compressed data, which stand before it. */
constexpr std::size_t length_bytes = 8;

/** Whether the compressed data unpacks to what the header announces. Looks at all of it
 * without taking memory, since three bytes may stand for 264. */
Status
checkCompressed(const TextScanner& scanner, std::size_t points, const TablePlan& plan)
{
  if (scanner.remaining() < length_bytes)
    return points == 0 ? Status() : Status::error("its compressed data is cut off");
  const char* const data = scanner.position() + length_bytes;
  const auto packed = loadScalar<std::uint32_t>(scanner.position(), false);
  const auto unpacked = loadScalar<std::uint32_t>(scanner.position() + 4, false);
  if (unpacked != points * plan.source_stride ||
      packed > scanner.remaining() - length_bytes)
    return Status::error("its compressed data is cut off or damaged");
  std::size_t length = 0;
  return measureLzf(data, packed, length) && length == unpacked
             ? Status()
             : Status::error("its compressed data is damaged");
}

/** Compressed data holds all values of the first field, then of the second, ... */
Status
readCompressed(const TextScanner& scanner,
               const std::vector<SourceColumn>& columns,
               const TablePlan& plan,
               pcl::PCLPointCloud2& cloud)
{
  const std::size_t points = cloud.width;
  if (points == 0)
    return {};
  const auto packed = loadScalar<std::uint32_t>(scanner.position(), false);
  std::vector<char> data(points * plan.source_stride);
  if (!unpackLzf(scanner.position() + length_bytes, packed, data))
    return Status::error("its compressed data is damaged");
  std::vector<char> records(data.size());
  std::size_t source = 0;
  std::size_t offset = 0;
  for (const SourceColumn& column : columns) {
    const std::size_t bytes = scalarSize(column.type) * column.count;
    for (std::size_t i = 0; i < points; ++i, source += bytes)
      std::memcpy(&records[i * plan.source_stride + offset], &data[source], bytes);
    offset += bytes;
  }
  decodeBinary(plan, records.data(), false, cloud);
  return {};
}

/** Refuses before any memory is taken what the rest of the file cannot hold. */
Status
checkLength(const PcdHeader& header, const TablePlan& plan, const TextScanner& scanner)
{
  if (header.data == "binary_compressed")
    return checkCompressed(scanner, header.points, plan);
  const bool is_ascii = header.data == "ascii";
  if (!is_ascii && header.data != "binary")
    return Status::error("its DATA is '" + header.data.substr(0, 40) +
                         "', not ascii, binary or binary_compressed");
  // The last number of an ASCII file needs no space behind it.
  const std::size_t point = is_ascii ? 2 * plan.slots.size() : plan.source_stride;
  const std::size_t bytes_left = scanner.remaining() + (is_ascii ? 1 : 0);
  return header.points > bytes_left / point ? tooShort(header) : Status();
}

void
setViewpoint(const std::vector<double>& numbers, Viewpoint& viewpoint)
{
  if (numbers.size() != 7)
    return;
  viewpoint.position = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  viewpoint.orientation =
      Eigen::Quaterniond(numbers[3], numbers[4], numbers[5], numbers[6]).cast<float>();
  viewpoint.may_be_origin = viewpoint.position.isZero(0);
  viewpoint.known = viewpoint.position.allFinite() && !viewpoint.may_be_origin;
}

} // namespace

Status
readPcd(const InputFile& file, Model& model)
{
  TextScanner scanner(file.begin(), file.end());
  PcdHeader header;
  std::vector<SourceColumn> columns;
  TablePlan plan;
  pcl::PCLPointCloud2& cloud = model.mesh.cloud;
  Status status = readHeader(scanner, header);
  if (status.ok())
    status = makeColumns(header, columns);
  if (status.ok() && header.data == "ascii")
    widenForText(scanner, header.points, columns);
  if (status.ok())
    status = planTable(columns, Naming::PCL, plan);
  if (status.ok())
    status = checkLength(header, plan, scanner);
  if (status.ok())
    status = allocateCloud(plan, header.points, cloud);
  if (!status.ok())
    return status;
  if (header.data == "ascii") {
    status = decodeText(plan, scanner, cloud);
    std::string_view word;
    if (status.ok() && scanner.nextWord(word))
      model.warnings.push_back("there is more behind the last point (lines with more "
                               "numbers than fields?); it is left out");
  }
  else if (header.data == "binary")
    decodeBinary(plan, scanner.position(), false, cloud);
  else
    status = readCompressed(scanner, columns, plan, cloud);
  cloud.width = static_cast<pcl::uindex_t>(header.width);
  cloud.height = static_cast<pcl::uindex_t>(header.height);
  cloud.row_step = cloud.width * cloud.point_step;
  setViewpoint(header.viewpoint, model.viewpoint);
  return status;
}

} // namespace app
