// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: makes a cloud out of one array per field.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "scalar_types.h"
#include "status.h"

#include <string>
#include <vector>

namespace app {

/** \brief All values of one field, point after point. */
struct FieldArray {
  std::string name;
  ScalarType type = 0;
  std::size_t count = 1; /**< numbers per point */
  std::vector<std::uint8_t> bytes;

  template <typename T>
  void
  append(T value)
  {
    const auto* first = reinterpret_cast<const std::uint8_t*>(&value);
    bytes.insert(bytes.end(), first, first + sizeof(T));
  }
};

/** \brief Append a colour as one packed PCL value; parts from 0 to 255. */
void
appendColour(FieldArray& colours, unsigned red, unsigned green, unsigned blue);

/** \brief Make \a cloud from \a positions (x, y, z one after the other, floats or
 * doubles, as the fields will be) and fields that have as many values as there are
 * points; a field with three numbers called "normal" becomes normal_x, normal_y,
 * normal_z. Fields of another length are left out. */
template <typename Real>
Status
assembleCloud(const std::vector<Real>& positions,
              const std::vector<FieldArray>& arrays,
              pcl::PCLPointCloud2& cloud);

/** \brief The same for text, read as doubles: floats unless \a is_wide. */
Status
assembleCloud(const std::vector<double>& positions,
              bool is_wide,
              const std::vector<FieldArray>& arrays,
              pcl::PCLPointCloud2& cloud);

} // namespace app
