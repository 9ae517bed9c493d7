// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the fields of a cloud as single columns for writing.
#pragma once

#include <pcl/surface_ccaa/global_shift.h>
#include <pcl/PCLPointCloud2.h>

#include <Eigen/Core>

#include "output_file.h"
#include "scalar_types.h"

#include <string>
#include <vector>

namespace app {

/** \brief One number of each point. */
struct PointColumn {
  std::string name;
  ScalarType type = 0;
  std::size_t offset = 0; /**< bytes into the point */
};

/** \brief The field called \a name with one number of \a type (0: any), or null. */
const pcl::PCLPointField*
findField(const pcl::PCLPointCloud2& cloud,
          const std::string& name,
          ScalarType type = 0);

/** \brief Whether it is a packed colour, "rgb" or "rgba". */
bool
isColour(const pcl::PCLPointField& field);

/** \brief Offset in the point of the packed colour "rgb" or "rgba".
 * \return false when the cloud has none. */
bool
findColour(const pcl::PCLPointCloud2& cloud, std::size_t& offset);

/** \brief Offset of normal_x, normal_y, normal_z if these are three floats in a row. */
bool
findNormal(const pcl::PCLPointCloud2& cloud, std::size_t& offset);

/** \brief All fields under the names other programs expect: red, green, blue (and
 * alpha) for a packed colour, nx for normal_x, name_0, name_1, ... for a field of
 * several numbers. Padding is left out; x, y and z come first; names are unique words.
 */
std::vector<PointColumn>
listColumns(const pcl::PCLPointCloud2& cloud);

/** \brief x, y and z of all points less the shift, 0 where the cloud has no such field.
 */
std::vector<Eigen::Vector3f>
readPositions(const pcl::PCLPointCloud2& cloud, const pcl::GlobalShift& shift = {});

/** \brief Whether x, y and z are doubles. */
bool
hasDoublePositions(const pcl::PCLPointCloud2& cloud);

/** \brief Append one number of \a point as text. */
void
writeAsText(const std::uint8_t* point, const PointColumn& column, OutputFile& file);

/** \brief Append three floats in a row as text, a space before each. */
void
writeFloats(const std::uint8_t* first, OutputFile& file);

/** \brief Numbers of a field; PCL lets 0 stand for one. */
inline std::size_t
countOf(const pcl::PCLPointField& field)
{
  return field.count == 0 ? 1 : field.count;
}

inline std::size_t
pointCount(const pcl::PCLPointCloud2& cloud)
{
  return std::size_t{cloud.width} * cloud.height;
}

inline const std::uint8_t*
pointAt(const pcl::PCLPointCloud2& cloud, std::size_t point_index)
{
  return cloud.data.data() + point_index * cloud.point_step;
}

} // namespace app
