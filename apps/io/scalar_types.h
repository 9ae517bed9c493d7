// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the number types a point field can have.
#pragma once

#include <pcl/surface_ccaa/impl/compat.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace app {

/** \brief Type of a number in a file or a point: a pcl::PCLPointField::PointFieldTypes;
 * 0 stands for none. */
using ScalarType = std::uint8_t;

/** \brief Stands for a C++ type in calls of visitScalar. */
template <typename T>
struct TypeTag {
  using type = T;
};

/** \brief Call \a visitor with the TypeTag of \a type.
 * \return false when there is no such type. */
template <typename Visitor>
bool
visitScalar(ScalarType type, Visitor&& visitor)
{
  using Field = pcl::ccaa::PointFieldNames;
  const auto visit = [&](auto tag) {
    visitor(tag);
    return true;
  };
  switch (type) {
  case Field::INT8:
    return visit(TypeTag<std::int8_t>{});
  case Field::BOOL:
  case Field::UINT8:
    return visit(TypeTag<std::uint8_t>{});
  case Field::INT16:
    return visit(TypeTag<std::int16_t>{});
  case Field::UINT16:
    return visit(TypeTag<std::uint16_t>{});
  case Field::INT32:
    return visit(TypeTag<std::int32_t>{});
  case Field::UINT32:
    return visit(TypeTag<std::uint32_t>{});
  case Field::INT64:
    return visit(TypeTag<std::int64_t>{});
  case Field::UINT64:
    return visit(TypeTag<std::uint64_t>{});
  case Field::FLOAT32:
    return visit(TypeTag<float>{});
  case Field::FLOAT64:
    return visit(TypeTag<double>{});
  default:
    return false;
  }
}

/** \brief Bytes of one number; 0 for an unknown type. */
inline std::size_t
scalarSize(ScalarType type)
{
  std::size_t size = 0;
  visitScalar(type, [&](auto tag) { size = sizeof(typename decltype(tag)::type); });
  return size;
}

/** \brief Read a number of type T at any address, its bytes reversed if \a swapped. */
template <typename T>
T
loadScalar(const void* address, bool swapped)
{
  unsigned char bytes[sizeof(T)];
  std::memcpy(bytes, address, sizeof(T));
  if (swapped)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
      std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/** \brief Read a number of a type known at run time as T; 0 for an unknown type. */
template <typename T>
T
loadScalarAs(const void* address, ScalarType type, bool swapped)
{
  T value{};
  visitScalar(type, [&](auto tag) {
    value = static_cast<T>(loadScalar<typename decltype(tag)::type>(address, swapped));
  });
  return value;
}

} // namespace app
