// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: makes a cloud out of one array per field.
#include "cloud_assembler.h"

#include "point_table.h"

namespace app {
namespace {

/** Spread values of \a bytes each over the points, \a offset bytes into each. */
void
interleave(const std::uint8_t* values,
           std::size_t bytes,
           std::size_t offset,
           pcl::PCLPointCloud2& cloud)
{
  if (cloud.data.empty()) // then there is nowhere to point to
    return;
  std::uint8_t* target = cloud.data.data() + offset;
  for (std::size_t i = 0; i < cloud.width; ++i) {
    std::memcpy(target, values, bytes);
    values += bytes;
    target += cloud.point_step;
  }
}

} // namespace

FieldArray
normalArray(const std::vector<float>& normals)
{
  FieldArray array{"normal", pcl::PCLPointField::FLOAT32, 3, {}};
  for (const float value : normals)
    array.append(value);
  return array;
}

template <typename Real>
void
assembleCloud(const std::vector<Real>& positions,
              const std::vector<FieldArray>& arrays,
              pcl::PCLPointCloud2& cloud)
{
  constexpr bool is_double = sizeof(Real) == sizeof(double);
  const ScalarType real =
      is_double ? pcl::PCLPointField::FLOAT64 : pcl::PCLPointField::FLOAT32;
  const std::size_t points = positions.size() / 3;
  std::vector<SourceColumn> columns{{"x", real, 1}, {"y", real, 1}, {"z", real, 1}};
  std::vector<const FieldArray*> used;
  for (const FieldArray& array : arrays) {
    const bool is_padding = array.name == "_"; // has no place in a point
    if (is_padding ||
        array.bytes.size() != points * array.count * scalarSize(array.type))
      continue;
    used.push_back(&array);
    if (array.name == "normal" && array.count == 3)
      for (const char* axis : {"normal_x", "normal_y", "normal_z"})
        columns.push_back({axis, array.type, 1});
    else
      columns.push_back({array.name, array.type, array.count});
  }
  const TablePlan plan = planTable(columns, Naming::PCL);
  allocateCloud(plan, points, cloud);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(positions.data());
  interleave(bytes, 3 * sizeof(Real), 0, cloud);
  std::size_t slot = 3;
  for (const FieldArray* array : used) {
    const std::size_t size = array->count * scalarSize(array->type);
    interleave(array->bytes.data(), size, plan.slots[slot].target_offset, cloud);
    slot += array->count;
  }
}

template void
assembleCloud(const std::vector<float>&,
              const std::vector<FieldArray>&,
              pcl::PCLPointCloud2&);
template void
assembleCloud(const std::vector<double>&,
              const std::vector<FieldArray>&,
              pcl::PCLPointCloud2&);

void
assembleCloud(const std::vector<double>& positions,
              bool is_wide,
              const std::vector<FieldArray>& arrays,
              pcl::PCLPointCloud2& cloud)
{
  if (is_wide)
    return assembleCloud(positions, arrays, cloud);
  std::vector<float> singles;
  for (const double value : positions)
    singles.push_back(static_cast<float>(value));
  assembleCloud(singles, arrays, cloud);
}

} // namespace app
