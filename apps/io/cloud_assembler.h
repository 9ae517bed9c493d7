// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: makes a cloud out of one array per field.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "scalar_types.h"
#include "text_scanner.h"

#include <algorithm>
#include <cmath>
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

/** \brief An empty array of packed colours. */
inline FieldArray
colourArray()
{
  return {"rgb", pcl::PCLPointField::FLOAT32, 1, {}};
}

/** \brief Normals, three numbers each. */
FieldArray
normalArray(const std::vector<float>& normals);

/** \brief Append a colour as one packed PCL value; parts from 0 to 255. */
inline void
appendColour(FieldArray& colours, unsigned red, unsigned green, unsigned blue)
{
  colours.append(static_cast<std::uint32_t>(red << 16 | green << 8 | blue));
}

/** \brief Append three parts, which are brought to 0 to 255 and rounded. */
template <typename Part>
void
appendColour(FieldArray& colours, const Part* parts, double factor)
{
  unsigned bytes[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = static_cast<double>(parts[i]) * factor;
    bytes[i] = part > 0 ? static_cast<unsigned>(std::lround(std::min(part, 255.0))) : 0;
  }
  appendColour(colours, bytes[0], bytes[1], bytes[2]);
}

/** \brief Make \a cloud from \a positions (x, y, z one after the other, floats or
 * doubles, as the fields will be) and fields that have as many values as there are
 * points; a field with three numbers called "normal" becomes normal_x, normal_y,
 * normal_z. Fields of another length are left out. Throws a Failure for more points
 * than PCL can index. */
template <typename Real>
void
assembleCloud(const std::vector<Real>& positions,
              const std::vector<FieldArray>& arrays,
              pcl::PCLPointCloud2& cloud);

/** \brief The same for what was read as doubles: floats unless \a is_wide. */
void
assembleCloud(const std::vector<double>& positions,
              bool is_wide,
              const std::vector<FieldArray>& arrays,
              pcl::PCLPointCloud2& cloud);

/** \brief Positions that are read as text: floats, unless one has more digits. */
class TextPositions {
public:
  /** \brief Add the next coordinate. \return false for a word that is no number */
  bool
  add(std::string_view word)
  {
    double& value = values_.emplace_back();
    const bool is_number = parseNumber(word, value);
    is_wide_ = is_wide_ || (is_number && needsDouble(word, value));
    return is_number;
  }

  bool
  empty() const
  {
    return values_.empty();
  }
  std::size_t
  points() const
  {
    return values_.size() / 3;
  }

  /** \brief As assembleCloud(). */
  void
  assemble(const std::vector<FieldArray>& arrays, pcl::PCLPointCloud2& cloud) const
  {
    assembleCloud(values_, is_wide_, arrays, cloud);
  }

private:
  std::vector<double> values_;
  bool is_wide_ = false;
};

} // namespace app
