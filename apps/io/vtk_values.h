// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: arrays of numbers inside a legacy VTK file.
#pragma once

#include "polygon_builder.h"
#include "scalar_types.h"
#include "text_scanner.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace app {

/** \brief Type of VTK's name for it ("unsigned_char"); 0 if there is no such type. */
ScalarType
vtkType(std::string_view name);

/** \brief Reads runs of numbers, which are big-endian when binary. Counts that the rest
 * of the file cannot hold are refused before memory is taken. */
class VtkValues {
public:
  VtkValues(TextScanner& scanner, bool is_binary)
  : scanner_(scanner), is_binary_(is_binary)
  {}

  /** \brief Read \a count numbers into their own bytes, in the order of this machine.
   */
  bool
  readBytes(ScalarType type, std::size_t count, std::vector<std::uint8_t>& bytes);

  /** \brief Read \a count numbers as T. */
  template <typename T>
  bool
  read(ScalarType type, std::size_t count, std::vector<T>& values)
  {
    std::vector<std::uint8_t> bytes;
    if (!readBytes(type, count, bytes))
      return false;
    const std::size_t size = scalarSize(type);
    values.resize(count);
    for (std::size_t i = 0; i < count; ++i)
      values[i] = loadScalarAs<T>(bytes.data() + i * size, type, false);
    return true;
  }

private:
  TextScanner& scanner_;
  bool is_binary_;
};

/** \brief Add the polygons and strips among the cells of an unstructured grid; a note
 * tells how many others were left out.
 * \param[in] cells one after the other, each as its number of corners and the corners
 * \param[in] types one a cell
 * \return false when the numbers do not fit together */
bool
addSurfaceCells(const std::vector<std::int64_t>& cells,
                const std::vector<std::int64_t>& types,
                PolygonBuilder& builder,
                Warnings& warnings);

} // namespace app
