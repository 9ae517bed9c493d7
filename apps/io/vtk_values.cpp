// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: arrays of numbers inside a legacy VTK file.
#include "vtk_values.h"

#include "point_table.h"

#include <algorithm>
#include <array>
#include <utility>

namespace app {

ScalarType
vtkType(std::string_view name)
{
  using Field = pcl::ccaa::PointFieldNames;
  static const std::array<std::pair<std::string_view, ScalarType>, 14> names{
      {{"char", Field::INT8},
       {"unsigned_char", Field::UINT8},
       {"signed_char", Field::INT8},
       {"short", Field::INT16},
       {"unsigned_short", Field::UINT16},
       {"int", Field::INT32},
       {"unsigned_int", Field::UINT32},
       {"long", Field::INT64},
       {"unsigned_long", Field::UINT64},
       {"vtktypeint64", Field::INT64},
       {"vtktypeuint64", Field::UINT64},
       {"vtkIdType", Field::INT32},
       {"float", Field::FLOAT32},
       {"double", Field::FLOAT64}}};
  for (const auto& [spelling, type] : names)
    if (spelling == name)
      return type;
  return name == "vtktypeint32" ? static_cast<ScalarType>(Field::INT32) : ScalarType{0};
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

} // namespace app
