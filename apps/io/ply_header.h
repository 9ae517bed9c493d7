// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what a PLY file says it holds.
#pragma once

#include "model.h"
#include "scalar_types.h"
#include "text_scanner.h"

#include <string>
#include <vector>

namespace app {

enum class PlyFormat { ASCII, BINARY_LITTLE, BINARY_BIG };

/** \brief One property: a number, or a list when count_type is not 0. */
struct PlyProperty {
  std::string name;
  ScalarType type = 0;
  ScalarType count_type = 0;

  bool
  isList() const
  {
    return count_type != 0;
  }
};

/** \brief One element, such as "vertex" or "face", with its number of rows. */
struct PlyElement {
  std::string name;
  std::size_t rows = 0;
  std::vector<PlyProperty> properties;

  /** \brief Fewest bytes that one row can take up in the file. */
  std::size_t
  minimumRowBytes(PlyFormat format) const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ASCII;
  Remarks remarks;
  std::vector<PlyElement> elements;
};

/** \brief Parse the header; \a scanner then stands at the first byte of the data.
 * Throws a Failure for what is not PLY, and for row counts which the rest of the file
 * cannot hold, before anybody takes memory for them. */
PlyHeader
readPlyHeader(TextScanner& scanner);

} // namespace app
