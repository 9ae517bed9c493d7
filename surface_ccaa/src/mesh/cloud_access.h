// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reading and extending raw clouds with unknown fields.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include "mesh/point_view.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::ccaa {

/** \brief Why a raw cloud cannot be used. */
enum class CloudProblem : std::uint8_t {
  NONE,
  FOREIGN_BYTE_ORDER, /**< written on a machine with the other byte order */
  NO_POSITION,        /**< one of the fields x, y, z is missing */
  POSITION_TYPE,      /**< x, y, z are not all float or all double */
  FIELD_OUTSIDE,      /**< a field ends beyond point_step */
  ROW_TOO_SHORT,      /**< row_step is less than width points */
  DATA_SIZE,          /**< data does not have row_step * height bytes */
  TOO_MANY_POINTS,    /**< more than pcl::index_t can number */
  BAD_SOURCE          /**< appendVertices(): a source index out of range */
};

/** \brief A sentence for messages, without a full stop. */
const char*
describe(CloudProblem problem);

/** \brief Whether the other functions here may be used on a cloud. An empty cloud (no
 * points) only needs its fields to be in order. */
CloudProblem
checkCloud(const pcl::PCLPointCloud2& cloud);

inline std::size_t
pointCount(const pcl::PCLPointCloud2& cloud)
{
  return static_cast<std::size_t>(cloud.width) * cloud.height;
}

/** \brief The fields x, y, z in place; the cloud must have passed checkCloud(). */
PointView
positionView(const pcl::PCLPointCloud2& cloud);

/** \brief The fields normal_x, normal_y, normal_z in place, as they are; empty when the
 * cloud does not have them as floats or doubles. */
PointView
normalView(const pcl::PCLPointCloud2& cloud);

/** \brief The sensor position of each point, fields vp_x, vp_y, vp_z; empty when the
 * cloud does not have them. */
PointView
viewpointView(const pcl::PCLPointCloud2& cloud);

/** \brief A copy of all positions. */
struct PositionList {
  Positions positions;        /**< of a point that is not finite: three NaN */
  std::size_t non_finite = 0; /**< how many of them */
};

PositionList
copyPositions(const PointView& view);

/** \brief How much an existing vertex contributes to a new one. */
struct VertexSource {
  pcl::index_t vertex = 0;
  double weight = 1.0; /**< only the proportions matter; 0 or less does not count */
};

/** \brief A vertex to be appended: where it is, and whose fields it inherits. */
struct NewVertex {
  Position position = Position::Zero();
  std::vector<VertexSource> sources; /**< without any, the other fields are zero */
};

/** \brief Append vertices to a cloud of any layout.
 *
 * Existing points keep their bytes. In a new point x, y, z are the position given;
 * every other float or double is the weighted mean of its sources (non-finite values of
 * a source do not count; NaN when none is finite), normals are brought to unit length,
 * rgb and rgba are mixed channel by channel; integers and whatever lies between the
 * fields come from the heaviest source (the first one of equals). An organised cloud
 * becomes an unorganised one (height 1) without row padding, unless there is nothing to
 * append. is_dense is cleared by a position that is not finite.
 *
 * \param[in,out] cloud unchanged when a problem is returned
 * \param[in] vertices sources refer to points already in the cloud
 * \return NONE, a problem of checkCloud(), TOO_MANY_POINTS or BAD_SOURCE */
CloudProblem
appendVertices(pcl::PCLPointCloud2& cloud, const std::vector<NewVertex>& vertices);

} // namespace pcl::ccaa
