// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: arrays of numbers inside a legacy VTK file.
#include "vtk_values.h"

#include "point_table.h"
#include "wording.h"

#include <algorithm>
#include <array>
#include <utility>

namespace app {
namespace {

/** VTK's numbers of the kinds of cells that matter here. */
enum CellType : std::int64_t {
  EMPTY = 0,
  POLY_LINE = 4, // up to here points and lines
  TRIANGLE = 5,
  TRIANGLE_STRIP = 6,
  POLYGON = 7,
  PIXEL = 8, // a rectangle whose corners go by rows
  QUAD = 9
};

/** \return false for a cell that is no surface. */
bool
addCell(std::int64_t type, std::vector<std::int64_t>& corners, PolygonBuilder& builder)
{
  if (type == TRIANGLE_STRIP) {
    builder.addStrip(corners);
    return true;
  }
  if (type == PIXEL && corners.size() == 4)
    std::swap(corners[2], corners[3]);
  const bool is_polygon =
      type == TRIANGLE || type == POLYGON || type == QUAD || type == PIXEL;
  if (is_polygon)
    builder.addPolygon(corners);
  return is_polygon || (type >= EMPTY && type <= POLY_LINE);
}

} // namespace

ScalarType
vtkType(std::string_view name)
{
  using Kinds = pcl::ccaa::PointFieldNames;
  static const std::array<std::pair<std::string_view, ScalarType>, 14> names{
      {{"char", Kinds::INT8},
       {"unsigned_char", Kinds::UINT8},
       {"signed_char", Kinds::INT8},
       {"short", Kinds::INT16},
       {"unsigned_short", Kinds::UINT16},
       {"int", Kinds::INT32},
       {"unsigned_int", Kinds::UINT32},
       {"long", Kinds::INT64},
       {"unsigned_long", Kinds::UINT64},
       {"vtktypeint64", Kinds::INT64},
       {"vtktypeuint64", Kinds::UINT64},
       {"vtkIdType", Kinds::INT32},
       {"float", Kinds::FLOAT32},
       {"double", Kinds::FLOAT64}}};
  for (const auto& [spelling, type] : names)
    if (spelling == name)
      return type;
  return name == "vtktypeint32" ? static_cast<ScalarType>(Kinds::INT32) : ScalarType{0};
}

bool
VtkValues::readBytes(ScalarType type,
                     std::size_t count,
                     std::vector<std::uint8_t>& bytes)
{
  const std::size_t size = scalarSize(type);
  if (size == 0)
    return false;
  const std::size_t least = is_binary_ ? size : 2;
  if (count > (scanner_.remaining() + 1) / least)
    return false;
  bytes.resize(count * size);
  if (!is_binary_) {
    std::string_view word;
    for (std::size_t i = 0; i < count; ++i)
      if (!scanner_.nextWord(word) || !decodeWord(word, type, &bytes[i * size]))
        return false;
    return true;
  }
  if (bytes.size() > scanner_.remaining())
    return false;
  std::copy_n(scanner_.position(), bytes.size(), bytes.begin());
  scanner_.skip(bytes.size());
  for (std::size_t i = 0; size > 1 && i < bytes.size(); i += size)
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                 bytes.begin() + static_cast<std::ptrdiff_t>(i + size));
  return true;
}

bool
addSurfaceCells(const std::vector<std::int64_t>& cells,
                const std::vector<std::int64_t>& types,
                PolygonBuilder& builder,
                Warnings& warnings)
{
  std::size_t others = 0;
  std::size_t cell = 0;
  std::vector<std::int64_t> corners;
  for (std::size_t at = 0; at < cells.size(); ++cell) {
    const std::int64_t count = cells[at++];
    if (cell >= types.size() || count < 0 ||
        count > static_cast<std::int64_t>(cells.size() - at))
      return false;
    const auto first = cells.begin() + static_cast<std::ptrdiff_t>(at);
    corners.assign(first, first + count);
    at += static_cast<std::size_t>(count);
    others += addCell(types[cell], corners, builder) ? 0 : 1;
  }
  if (others > 0)
    warnings.push_back(plural(others, "cell") +
                       " left out: only flat polygons are read");
  return cell == types.size();
}

} // namespace app
