// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reads PCD, ASCII, binary and compressed.
#include "point_table.h"
#include "readers.h"
#include "wording.h"

#include <algorithm>
#include <limits>
#include <map>

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

/** The lines of the header by their keyword, until DATA. */
class PcdHeader {
public:
  std::size_t width = 0;
  std::size_t height = 1;
  std::size_t points = 0;
  std::string data;

  explicit PcdHeader(TextScanner& scanner)
  {
    std::string_view line;
    while (data.empty()) {
      if (!scanner.nextLine(line))
        throw Failure("its PCD header has no DATA line");
      if (!readLine(line))
        throw Failure("its header has the line '" + std::string(line.substr(0, 40)) +
                      "', which is not PCD");
    }
    // Old files have no WIDTH.
    const bool has_points = words_.count("POINTS") != 0;
    if (words_.count("WIDTH") != 0)
      width = size("WIDTH");
    else if (has_points)
      width = size("POINTS");
    if (words_.count("HEIGHT") != 0 && words_.count("WIDTH") != 0)
      height = size("HEIGHT");
    if (width != 0 && height > std::numeric_limits<int>::max() / width)
      throw Failure("its WIDTH times HEIGHT is too large");
    points = width * height;
    if (has_points && size("POINTS") != points)
      throw Failure("its POINTS is not WIDTH times HEIGHT");
  }

  const std::vector<std::string>&
  operator[](const std::string& keyword)
  {
    return words_[keyword];
  }

  /** The numbers of a line; those that are damaged end the file. */
  template <typename T>
  std::vector<T>
  numbers(const std::string& keyword)
  {
    std::vector<T> values;
    for (const std::string& word : words_[keyword])
      if (!parseNumber(word, values.emplace_back()))
        throw Failure("its header has the line '" + keyword + " " + word.substr(0, 40) +
                      "', which is not PCD");
    return values;
  }

private:
  std::size_t
  size(const std::string& keyword)
  {
    const auto values = numbers<std::size_t>(keyword);
    if (values.empty())
      throw Failure("its header has no number for " + keyword);
    return values.front();
  }

  bool
  readLine(std::string_view line)
  {
    TextScanner scanner(line);
    std::string_view word;
    if (!scanner.nextWord(word) || word.front() == '#' || word == "VERSION")
      return true;
    std::string keyword(word == "COLUMNS" ? "FIELDS" : word);
    const bool is_known = keyword == "FIELDS" || keyword == "SIZE" ||
                          keyword == "TYPE" || keyword == "COUNT" ||
                          keyword == "WIDTH" || keyword == "HEIGHT" ||
                          keyword == "VIEWPOINT" || keyword == "POINTS";
    if (keyword == "DATA") {
      data = scanner.word();
      return true;
    }
    std::vector<std::string>& words = words_[keyword];
    words.clear();
    while (scanner.nextWord(word))
      words.emplace_back(word);
    return is_known;
  }

  std::map<std::string, std::vector<std::string>> words_;
};

std::vector<SourceColumn>
makeColumns(PcdHeader& header)
{
  const std::vector<std::string>& names = header["FIELDS"];
  const auto& kinds = header["TYPE"];
  const auto sizes = header.numbers<std::size_t>("SIZE");
  auto counts = header.numbers<std::size_t>("COUNT");
  if (counts.empty())
    counts.assign(names.size(), 1);
  if (names.empty() || sizes.size() != names.size() || kinds.size() != names.size() ||
      counts.size() != names.size())
    throw Failure("its FIELDS, SIZE, TYPE and COUNT lines do not match");
  std::vector<SourceColumn> columns;
  for (std::size_t i = 0; i < names.size(); ++i) {
    columns.push_back({names[i], pcdType(kinds[i].front(), sizes[i]), counts[i]});
    if (columns[i].type == 0 || counts[i] == 0 || counts[i] > most_numbers)
      throw Failure("its field '" + names[i] + "' has no valid type");
  }
  return columns;
}

/** Unpack LZF data: runs of bytes (control byte below 32), and copies from up to 8 KiB
 * back. Every read and write is checked against its bounds. An own decoder, because
 * liblzf and PCL's need the memory of the whole output before they can say that the
 * data is damaged, and three bytes may stand for 264. \param[out] output of \a
 * output_size bytes; null: only look whether it would fit \return false when the data
 * is damaged or of another size */
bool
unpackLzf(const char* input,
          std::size_t input_size,
          char* output,
          std::size_t output_size)
{
  const char* const end = input + input_size;
  const auto byte = [&] { return std::size_t{static_cast<unsigned char>(*input++)}; };
  const auto left = [&] { return static_cast<std::size_t>(end - input); };
  std::size_t used = 0;
  while (input != end) {
    const std::size_t control = byte();
    const bool is_copy = control >= 32;
    const bool is_long = control >> 5 == 7;
    if (is_copy && left() < (is_long ? 2U : 1U))
      return false;
    const std::size_t length =
        is_copy ? (control >> 5) + (is_long ? byte() : 0) + 2 : control + 1;
    const std::size_t distance = is_copy ? ((control & 31) << 8) + byte() + 1 : 0;
    if (length > output_size - used || distance > used || (!is_copy && length > left()))
      return false;
    if (!is_copy && output != nullptr)
      std::copy_n(input, length, output + used);
    // Byte by byte on purpose: a copy may overlap what it has just written.
    for (std::size_t i = used; is_copy && output != nullptr && i < used + length; ++i)
      output[i] = output[i - distance];
    input += is_copy ? 0 : length;
    used += length;
  }
  return used == output_size;
}

/** Compressed data, behind its two lengths. */
struct Packed {
  const char* data = nullptr;
  std::size_t packed = 0;
  std::size_t unpacked = 0;
};

/** Looks at all of the data without taking memory, since three bytes may stand for 264.
 */
Packed
checkCompressed(const TextScanner& scanner, std::size_t points, const TablePlan& plan)
{
  constexpr std::size_t length_bytes = 8;
  if (scanner.remaining() < length_bytes) {
    if (points == 0)
      return {};
    throw Failure("its compressed data is cut off");
  }
  const char* const at = scanner.position();
  const Packed lengths{at + length_bytes,
                       loadScalar<std::uint32_t>(at, false),
                       loadScalar<std::uint32_t>(at + 4, false)};
  if (lengths.unpacked != points * plan.source_stride ||
      lengths.packed > scanner.remaining() - length_bytes)
    throw Failure("its compressed data is cut off or damaged");
  if (!unpackLzf(lengths.data, lengths.packed, nullptr, lengths.unpacked))
    throw Failure("its compressed data is damaged");
  return lengths;
}

/** Compressed data holds all values of the first field, then of the second, ... */
void
decodeCompressed(const Packed& packed,
                 const std::vector<SourceColumn>& columns,
                 const TablePlan& plan,
                 pcl::PCLPointCloud2& cloud)
{
  std::vector<char> data(packed.unpacked);
  unpackLzf(packed.data, packed.packed, data.data(), data.size());
  std::vector<char> records(data.size());
  std::size_t source = 0;
  std::size_t offset = 0;
  for (const SourceColumn& column : columns) {
    const std::size_t bytes = scalarSize(column.type) * column.count;
    for (std::size_t i = 0; i < cloud.width; ++i, source += bytes)
      std::memcpy(&records[i * plan.source_stride + offset], &data[source], bytes);
    offset += bytes;
  }
  decodeBinary(plan, records.data(), false, cloud);
}

/** Refuses before any memory is taken what the rest of the file cannot hold. */
void
checkLength(const PcdHeader& header, const TablePlan& plan, const TextScanner& scanner)
{
  const bool is_ascii = header.data == "ascii";
  if (!is_ascii && header.data != "binary")
    throw Failure("its DATA is '" + header.data.substr(0, 40) +
                  "', not ascii, binary or binary_compressed");
  // The last number of an ASCII file needs no space behind it.
  const std::size_t point = is_ascii ? 2 * plan.slots.size() : plan.source_stride;
  if (header.points > (scanner.remaining() + (is_ascii ? 1 : 0)) / point)
    throw Failure("it is too short for the " + plural(header.points, "point") +
                  " its header announces (truncated?)");
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

/** All but compressed data, of which \a packed tells. */
PointRecords
findRecords(PcdHeader& header,
            TextScanner scanner,
            std::vector<SourceColumn>& columns,
            Packed& packed)
{
  PointRecords records;
  columns = makeColumns(header);
  records.is_text = header.data == "ascii";
  if (records.is_text)
    widenForText(scanner, header.points, columns);
  records.plan = planTable(columns, Naming::PCL);
  records.left = header.points;
  records.rows = scanner;
  if (header.data == "binary_compressed")
    packed = checkCompressed(scanner, header.points, records.plan);
  else
    checkLength(header, records.plan, scanner);
  return records;
}

} // namespace

void
readPcd(const InputFile& file, Model& model)
{
  TextScanner scanner(file.bytes());
  PcdHeader header(scanner);
  pcl::PCLPointCloud2& cloud = model.mesh.cloud;
  std::vector<SourceColumn> columns;
  Packed packed;
  PointRecords records = findRecords(header, scanner, columns, packed);
  if (header.data == "binary_compressed") {
    allocateCloud(records.plan, header.points, cloud);
    decodeCompressed(packed, columns, records.plan, cloud);
  }
  else
    records.decode(header.points, cloud);
  if (records.is_text && !records.rows.word().empty())
    model.warnings.push_back("there is more behind the last point (lines with more "
                             "numbers than fields?); it is left out");
  cloud.width = static_cast<pcl::uindex_t>(header.width);
  cloud.height = static_cast<pcl::uindex_t>(header.height);
  cloud.row_step = cloud.width * cloud.point_step;
  setViewpoint(header.numbers<double>("VIEWPOINT"), model.viewpoint);
}

bool
findPcdRecords(const InputFile& file, PointRecords& records, Model& head)
{
  TextScanner scanner(file.bytes());
  PcdHeader header(scanner);
  std::vector<SourceColumn> columns;
  Packed packed;
  if (header.data == "binary_compressed")
    return false;
  records = findRecords(header, scanner, columns, packed);
  allocateCloud(records.plan, 0, head.mesh.cloud);
  setViewpoint(header.numbers<double>("VIEWPOINT"), head.viewpoint);
  return true;
}

} // namespace app
