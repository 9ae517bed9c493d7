// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: columns of numbers in a file become the fields of a cloud.
#include "point_table.h"

#include "wording.h"

#include <algorithm>
#include <limits>

namespace app {
namespace {

using Field = pcl::PCLPointField;

/** A number of a colour: its byte within PCL's packed 0xAARRGGBB; -1 for none. */
int
colourByte(const std::string& name)
{
  if (name == "blue")
    return 0;
  if (name == "green")
    return 1;
  if (name == "red")
    return 2;
  return name == "alpha" ? 3 : -1;
}

bool
hasByteColumn(const std::vector<SourceColumn>& columns, const std::string& name)
{
  return std::any_of(columns.begin(), columns.end(), [&](const SourceColumn& column) {
    return column.name == name && column.type == Field::UINT8 && column.count == 1;
  });
}

bool
isPosition(const std::string& name)
{
  return name == "x" || name == "y" || name == "z";
}

/** All three of one type, as PCL and all our rooms want them. */
ScalarType
positionType(const std::vector<SourceColumn>& columns)
{
  const bool all_fit =
      std::all_of(columns.begin(), columns.end(), [](const SourceColumn& column) {
        return !isPosition(column.name) || column.type == Field::FLOAT32 ||
               scalarSize(column.type) < sizeof(float);
      });
  return all_fit ? Field::FLOAT32 : Field::FLOAT64;
}

std::string
pclName(const std::string& name)
{
  if (name == "nx" || name == "ny" || name == "nz")
    return "normal_" + name.substr(1);
  return name;
}

/** Builds a plan column by column. */
class Planner {
public:
  Planner(const std::vector<SourceColumn>& columns, Naming naming, TablePlan& plan)
  : naming_(naming)
  , plan_(plan)
  , packed_colour_(naming == Naming::PLY && hasByteColumn(columns, "red") &&
                   hasByteColumn(columns, "green") && hasByteColumn(columns, "blue"))
  , packed_alpha_(packed_colour_ && hasByteColumn(columns, "alpha"))
  , position_type_(positionType(columns))
  {}

  void
  add(const SourceColumn& column)
  {
    const bool is_ply = naming_ == Naming::PLY;
    const int byte = packed_colour_ ? colourByte(column.name) : -1;
    if (column.name == "_")
      addSlots(column, 0, 0);
    else if (byte >= 0 && (byte < 3 || packed_alpha_))
      addSlots(column, colourOffset() + static_cast<std::size_t>(byte), Field::UINT8);
    else {
      const ScalarType type = isPosition(column.name) ? position_type_ : column.type;
      const std::string name = is_ply ? pclName(column.name) : column.name;
      addSlots(column, addField(name, type, column.count), type);
    }
  }

  void
  finish()
  {
    plan_.point_step = (size_ + alignment_ - 1) / alignment_ * alignment_;
  }

private:
  std::size_t
  addField(const std::string& name, ScalarType type, std::size_t count)
  {
    const std::size_t bytes = scalarSize(type);
    size_ = (size_ + bytes - 1) / bytes * bytes;
    alignment_ = std::max(alignment_, bytes);
    Field field;
    field.name = name;
    field.offset = static_cast<pcl::uindex_t>(size_);
    field.datatype = type;
    field.count = static_cast<pcl::uindex_t>(count);
    plan_.fields.push_back(field);
    size_ += bytes * count;
    return field.offset;
  }

  /** Offset of the packed colour, whose field is made at its first part. */
  std::size_t
  colourOffset()
  {
    if (!has_colour_)
      colour_offset_ = packed_alpha_ ? addField("rgba", Field::UINT32, 1)
                                     : addField("rgb", Field::FLOAT32, 1);
    has_colour_ = true;
    return colour_offset_;
  }

  void
  addSlots(const SourceColumn& column, std::size_t target_offset, ScalarType target)
  {
    for (std::size_t i = 0; i < column.count; ++i) {
      plan_.slots.push_back({plan_.source_stride, column.type, target_offset, target});
      plan_.source_stride += scalarSize(column.type);
      target_offset += scalarSize(target);
    }
  }

  Naming naming_;
  TablePlan& plan_;
  bool packed_colour_;
  bool packed_alpha_;
  ScalarType position_type_;
  bool has_colour_ = false;
  std::size_t colour_offset_ = 0;
  std::size_t size_ = 0;
  std::size_t alignment_ = 4;
};

void
checkColumns(const std::vector<SourceColumn>& columns)
{
  std::size_t numbers = 0;
  for (const SourceColumn& column : columns)
    numbers += column.count;
  // More than any known descriptor has: a damaged file.
  if (numbers > most_numbers)
    throw Failure("its points have " + std::to_string(numbers) +
                  " numbers each, which is too many");
  for (const char* axis : {"x", "y", "z"})
    if (std::none_of(columns.begin(), columns.end(), [&](const SourceColumn& column) {
          return column.name == axis && column.count == 1;
        }))
      throw Failure(std::string("its points have no coordinate ") + axis);
}

/** The first name that occurs twice; empty if none does. */
template <typename Named>
std::string
nameTakenTwice(const std::vector<Named>& all)
{
  std::vector<std::string> names;
  for (const Named& named : all)
    if (named.name != "_")
      names.push_back(named.name);
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  return twice == names.end() ? "" : *twice;
}

/** A block of bytes copied as it is from record to point. */
struct CopyRun {
  std::size_t source_offset = 0;
  std::size_t target_offset = 0;
  std::size_t bytes = 0;
};

/** Joins neighbouring slots that need no conversion, so that a usual point is one copy;
 * the others are left in \a converted. */
std::vector<CopyRun>
planCopies(const TablePlan& plan, bool swapped, std::vector<Slot>& converted)
{
  std::vector<CopyRun> runs;
  for (const Slot& slot : plan.slots) {
    const std::size_t bytes = scalarSize(slot.source_type);
    if (slot.target_type == 0)
      continue;
    if (slot.source_type != slot.target_type || (swapped && bytes > 1)) {
      converted.push_back(slot);
      continue;
    }
    const bool joins =
        !runs.empty() &&
        runs.back().source_offset + runs.back().bytes == slot.source_offset &&
        runs.back().target_offset + runs.back().bytes == slot.target_offset;
    if (!joins)
      runs.push_back({slot.source_offset, slot.target_offset, 0});
    runs.back().bytes += bytes;
  }
  return runs;
}

/** Same type: swap only. Otherwise the target is a position, and float or double. */
void
convertSlot(const Slot& slot, const char* record, bool swapped, std::uint8_t* point)
{
  visitScalar(slot.source_type, [&](auto tag) {
    using T = typename decltype(tag)::type;
    const T value = loadScalar<T>(record + slot.source_offset, swapped);
    if (slot.source_type == slot.target_type) {
      std::memcpy(point + slot.target_offset, &value, sizeof(T));
      return;
    }
    const auto single = static_cast<float>(value);
    const auto real = static_cast<double>(value);
    if (slot.target_type == Field::FLOAT64)
      std::memcpy(point + slot.target_offset, &real, sizeof(real));
    else
      std::memcpy(point + slot.target_offset, &single, sizeof(single));
  });
}

} // namespace

TablePlan
planTable(const std::vector<SourceColumn>& columns, Naming naming)
{
  checkColumns(columns);
  const std::string twice = nameTakenTwice(columns);
  if (!twice.empty())
    throw Failure("its points have two columns named '" + twice + "'");
  TablePlan plan;
  Planner planner(columns, naming, plan);
  for (const SourceColumn& column : columns)
    planner.add(column);
  planner.finish();
  if (!nameTakenTwice(plan.fields).empty())
    throw Failure("two of its columns stand for the same field");
  return plan;
}

void
widenForText(TextScanner scanner,
             std::size_t points,
             std::vector<SourceColumn>& columns)
{
  std::string_view word;
  double value = 0;
  bool is_wide = positionType(columns) == Field::FLOAT64;
  for (std::size_t i = 0; i < points && !is_wide && scanner.remaining() > 0; ++i)
    for (const SourceColumn& column : columns)
      for (std::size_t k = 0; k < column.count && scanner.nextWord(word); ++k)
        is_wide = is_wide || (isPosition(column.name) && parseNumber(word, value) &&
                              needsDouble(word, value));
  for (SourceColumn& column : columns)
    if (is_wide && isPosition(column.name))
      column.type = Field::FLOAT64;
}

void
allocateCloud(const TablePlan& plan, std::size_t points, pcl::PCLPointCloud2& cloud)
{
  const auto most = static_cast<std::size_t>(std::numeric_limits<pcl::index_t>::max());
  if (points > most ||
      points * plan.point_step > std::numeric_limits<pcl::uindex_t>::max())
    throw Failure("it holds more points than PCL can index");
  cloud.fields = plan.fields;
  cloud.width = static_cast<pcl::uindex_t>(points);
  cloud.height = 1;
  cloud.point_step = static_cast<pcl::uindex_t>(plan.point_step);
  cloud.row_step = static_cast<pcl::uindex_t>(points * plan.point_step);
  cloud.is_bigendian = false;
  cloud.is_dense = true;
  cloud.data.assign(points * plan.point_step, 0);
}

void
decodeBinary(const TablePlan& plan,
             const char* records,
             bool swapped,
             pcl::PCLPointCloud2& cloud)
{
  std::vector<Slot> converted;
  const std::vector<CopyRun> runs = planCopies(plan, swapped, converted);
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  std::uint8_t* point = cloud.data.data();
  const char* record = records;
  for (std::size_t i = 0; i < points; ++i) {
    for (const CopyRun& run : runs)
      std::memcpy(point + run.target_offset, record + run.source_offset, run.bytes);
    for (const Slot& slot : converted)
      convertSlot(slot, record, swapped, point);
    record += plan.source_stride;
    point += plan.point_step;
  }
}

bool
decodeWord(std::string_view word, ScalarType type, std::uint8_t* target)
{
  bool good = false;
  if (type == 0) {
    double ignored = 0;
    return parseNumber(word, ignored);
  }
  visitScalar(type, [&](auto tag) {
    typename decltype(tag)::type value{};
    good = parseNumber(word, value);
    std::memcpy(target, &value, sizeof(value));
  });
  return good;
}

void
decodeText(const TablePlan& plan, TextScanner& scanner, pcl::PCLPointCloud2& cloud)
{
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  std::uint8_t* point = cloud.data.data();
  std::string_view word;
  for (std::size_t i = 0; i < points; ++i, point += plan.point_step)
    for (const Slot& slot : plan.slots) {
      if (!scanner.nextWord(word))
        throw Failure("it ends after " + std::to_string(i) + " of " +
                      plural(points, "point"));
      if (!decodeWord(word, slot.target_type, point + slot.target_offset))
        throw Failure("'" + std::string(word.substr(0, 40)) + "' in point " +
                      std::to_string(i) + " is not the number it should be");
    }
}

void
PointRecords::decode(std::size_t points, pcl::PCLPointCloud2& cloud)
{
  points = std::min(points, left);
  allocateCloud(plan, points, cloud);
  left -= points;
  if (is_text)
    return decodeText(plan, rows, cloud);
  decodeBinary(plan, rows.position(), swapped, cloud);
  rows.skip(points * plan.source_stride);
}

} // namespace app
