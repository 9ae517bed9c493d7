// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: appending vertices with all their fields to a raw cloud.
#include "mesh/cloud_access.h"
#include "mesh/cloud_fields.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::ccaa {
namespace {

/** \brief A point's record and the share it has in a new one. */
struct Share {
  const std::uint8_t* record;
  double weight;
};

/** \brief Positive weights only; none when there is no such source. */
std::vector<Share>
sharesOf(const NewVertex& vertex,
         const std::vector<std::uint8_t>& data,
         std::size_t step)
{
  std::vector<Share> shares;
  for (const VertexSource& source : vertex.sources)
    if (source.weight > 0.0 && std::isfinite(source.weight))
      shares.push_back({data.data() + static_cast<std::size_t>(source.vertex) * step,
                        source.weight});
  return shares;
}

const std::uint8_t*
heaviest(const std::vector<Share>& shares)
{
  return std::max_element(
             shares.begin(),
             shares.end(),
             [](const Share& a, const Share& b) { return a.weight < b.weight; })
      ->record;
}

template <typename Number>
Number
readNumber(const std::uint8_t* bytes)
{
  Number value;
  std::memcpy(&value, bytes, sizeof(Number));
  return value;
}

/** \brief Weighted mean of the finite values at an offset; NaN when there is none. */
template <typename Number>
double
mean(const std::vector<Share>& shares, std::size_t offset)
{
  double sum = 0.0, weights = 0.0;
  for (const Share& share : shares) {
    const auto value = static_cast<double>(readNumber<Number>(share.record + offset));
    if (!std::isfinite(value))
      continue;
    sum += share.weight * value;
    weights += share.weight;
  }
  return weights > 0.0 ? sum / weights : std::numeric_limits<double>::quiet_NaN();
}

template <typename Number>
void
writeNumber(double value, std::uint8_t* bytes)
{
  const auto number = static_cast<Number>(value);
  std::memcpy(bytes, &number, sizeof(Number));
}

void
writeFloating(const pcl::PCLPointField& field, double value, std::uint8_t* bytes)
{
  if (field.datatype == pcl::PCLPointField::FLOAT64)
    writeNumber<double>(value, bytes);
  else
    writeNumber<float>(value, bytes);
}

/** \brief Mean of each value of a floating field. */
void
mixFloating(const pcl::PCLPointField& field,
            const std::vector<Share>& shares,
            std::uint8_t* record)
{
  const std::size_t bytes = fieldBytes(field) / valueCount(field);
  for (std::size_t i = 0; i < valueCount(field); ++i) {
    const std::size_t offset = field.offset + i * bytes;
    writeFloating(field,
                  field.datatype == pcl::PCLPointField::FLOAT64
                      ? mean<double>(shares, offset)
                      : mean<float>(shares, offset),
                  record + offset);
  }
}

/** \brief Mean of each of the four bytes of a packed colour. */
void
mixColour(const pcl::PCLPointField& field,
          const std::vector<Share>& shares,
          std::uint8_t* record)
{
  for (std::size_t channel = field.offset; channel < field.offset + 4u; ++channel)
    record[channel] =
        static_cast<std::uint8_t>(std::lround(mean<std::uint8_t>(shares, channel)));
}

bool
isPackedColour(const pcl::PCLPointField& field)
{
  return (field.name == "rgb" || field.name == "rgba") && fieldBytes(field) == 4;
}

/** \brief Bring normal_x, normal_y, normal_z to unit length; a mean of opposite normals
 * has no direction, the heaviest source's is taken then. */
void
normalise(const pcl::PCLPointCloud2& cloud,
          const std::vector<Share>& shares,
          std::uint8_t* record)
{
  const PointView any = normalView(cloud);
  if (any.empty())
    return;
  const pcl::PCLPointField* fields[3] = {findField(cloud, "normal_x"),
                                         findField(cloud, "normal_y"),
                                         findField(cloud, "normal_z")};
  Eigen::Vector3d normal = any.tripleAt(record);
  constexpr double NO_DIRECTION = 1e-6;
  if (!(normal.norm() > NO_DIRECTION))
    normal = any.tripleAt(heaviest(shares));
  const double length = normal.norm();
  if (!(length > 0.0) || !std::isfinite(length))
    return;
  for (Eigen::Index i = 0; i < 3; ++i)
    writeFloating(*fields[i], normal[i] / length, record + fields[i]->offset);
}

void
writePosition(const pcl::PCLPointCloud2& cloud,
              const Position& position,
              std::uint8_t* record)
{
  const char* names[3] = {"x", "y", "z"};
  for (Eigen::Index i = 0; i < 3; ++i) {
    const pcl::PCLPointField* field = findField(cloud, names[i]);
    writeFloating(*field, position[i], record + field->offset);
  }
}

/** \brief Fill the record of a new vertex, which is all zero. */
void
fillRecord(const pcl::PCLPointCloud2& cloud,
           const NewVertex& vertex,
           const std::vector<Share>& shares,
           std::uint8_t* record)
{
  if (!shares.empty()) {
    std::memcpy(record, heaviest(shares), cloud.point_step);
    for (const pcl::PCLPointField& field : cloud.fields) {
      if (isPackedColour(field))
        mixColour(field, shares, record);
      else if (isFloating(field))
        mixFloating(field, shares, record);
    }
    normalise(cloud, shares, record);
  }
  writePosition(cloud, vertex.position, record);
}

/** \brief All rows one after the other, without padding. */
std::vector<std::uint8_t>
withoutPadding(const pcl::PCLPointCloud2& cloud, std::size_t capacity)
{
  const std::size_t row_bytes =
      static_cast<std::size_t>(cloud.width) * cloud.point_step;
  std::vector<std::uint8_t> data;
  data.reserve(capacity);
  for (std::size_t row = 0; row < cloud.height && row_bytes > 0; ++row) {
    const auto begin =
        cloud.data.begin() + static_cast<std::ptrdiff_t>(row * cloud.row_step);
    data.insert(data.end(), begin, begin + static_cast<std::ptrdiff_t>(row_bytes));
  }
  return data;
}

CloudProblem
checkRequest(const pcl::PCLPointCloud2& cloud, const std::vector<NewVertex>& vertices)
{
  const CloudProblem problem = checkCloud(cloud);
  if (problem != CloudProblem::NONE)
    return problem;
  const std::size_t count = pointCount(cloud), total = count + vertices.size();
  if (total > static_cast<std::size_t>(std::numeric_limits<index_t>::max()) ||
      total > std::numeric_limits<uindex_t>::max() /
                  std::max<uindex_t>(1, cloud.point_step))
    return CloudProblem::TOO_MANY_POINTS;
  for (const NewVertex& vertex : vertices)
    for (const VertexSource& source : vertex.sources)
      if (source.vertex < 0 || static_cast<std::size_t>(source.vertex) >= count)
        return CloudProblem::BAD_SOURCE;
  return CloudProblem::NONE;
}

} // namespace

CloudProblem
appendVertices(pcl::PCLPointCloud2& cloud, const std::vector<NewVertex>& vertices)
{
  const CloudProblem problem = checkRequest(cloud, vertices);
  if (problem != CloudProblem::NONE || vertices.empty())
    return problem;
  const std::size_t step = cloud.point_step, count = pointCount(cloud);
  const std::size_t total = count + vertices.size();
  std::vector<std::uint8_t> data = withoutPadding(cloud, total * step);
  data.resize(total * step, 0);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    fillRecord(cloud,
               vertices[i],
               sharesOf(vertices[i], data, step),
               data.data() + (count + i) * step);
    if (!vertices[i].position.allFinite())
      cloud.is_dense = 0;
  }
  cloud.data = std::move(data);
  cloud.width = static_cast<uindex_t>(total);
  cloud.height = 1;
  cloud.row_step = static_cast<uindex_t>(total * step);
  return CloudProblem::NONE;
}

} // namespace pcl::ccaa
