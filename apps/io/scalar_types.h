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
  switch (type) {
  case Field::INT8:
    visitor(TypeTag<std::int8_t>{});
    return true;
  case Field::BOOL:
  case Field::UINT8:
    visitor(TypeTag<std::uint8_t>{});
    return true;
  case Field::INT16:
    visitor(TypeTag<std::int16_t>{});
    return true;
  case Field::UINT16:
    visitor(TypeTag<std::uint16_t>{});
    return true;
  case Field::INT32:
    visitor(TypeTag<std::int32_t>{});
    return true;
  case Field::UINT32:
    visitor(TypeTag<std::uint32_t>{});
    return true;
  case Field::INT64:
    visitor(TypeTag<std::int64_t>{});
    return true;
  case Field::UINT64:
    visitor(TypeTag<std::uint64_t>{});
    return true;
  case Field::FLOAT32:
    visitor(TypeTag<float>{});
    return true;
  case Field::FLOAT64:
    visitor(TypeTag<double>{});
    return true;
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
