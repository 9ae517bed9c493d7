// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: reading triples of coordinates wherever they lie.
#pragma once

#include <pcl/surface_ccaa/impl/point_array.h>

#include "mesh/triangle.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl::ccaa {

/** \brief Where three numbers lie in each record of a block of bytes. */
struct TripleLayout {
  std::size_t record_bytes = 0;         /**< from one record to the next */
  std::array<std::size_t, 3> offsets{}; /**< of the three numbers in a record */
  bool is_double = false;               /**< double, else float */
  std::size_t records_per_row = 0;      /**< only looked at when rows are padded */
  std::size_t row_padding_bytes = 0;    /**< unused bytes after each row */
};

/** \brief Read-only view of a list of 3-vectors (positions, normals, viewpoints), so
 * that the rooms work on a raw cloud, on floats or on doubles without a copy.
 *
 * The view owns nothing: what it looks at must outlive it and stay where it is. Numbers
 * are returned as they are, also when not finite, unless an origin is taken off. Const
 * methods may be called from several threads.
 */
class PointView {
public:
  /** \brief A view of nothing; tells that something optional is not there. */
  PointView() = default;

  PointView(const Positions& positions)
  : PointView(positions.data(),
              positions.size(),
              {sizeof(Position), {0, sizeof(double), 2 * sizeof(double)}, true, 0, 0})
  {}

  PointView(const std::vector<Eigen::Vector3f>& points)
  : PointView(
        points.data(),
        points.size(),
        {sizeof(Eigen::Vector3f), {0, sizeof(float), 2 * sizeof(float)}, false, 0, 0})
  {}

  /** \brief View of `size` records that begin at `data`. */
  PointView(const void* data, std::size_t size, const TripleLayout& layout)
  : data_(static_cast<const std::uint8_t*>(data)), size_(size), layout_(layout)
  {}

  std::size_t
  size() const
  {
    return size_;
  }
  bool
  empty() const
  {
    return size_ == 0;
  }

  /** \brief The same triples less an origin. */
  PointView
  relativeTo(const Position& origin) const
  {
    PointView moved = *this;
    moved.origin_ = origin;
    return moved;
  }

  /** \brief The triple of a record; the index must be below size(). */
  Position
  operator[](std::size_t index) const
  {
    const std::uint8_t* record = data_ + index * layout_.record_bytes;
    if (layout_.row_padding_bytes != 0)
      record += index / layout_.records_per_row * layout_.row_padding_bytes;
    return tripleAt(record) - origin_;
  }

  /** \brief The triple of a record of the same layout that lies elsewhere, as it is. */
  Position
  tripleAt(const std::uint8_t* record) const
  {
    return layout_.is_double ? read<double>(record) : read<float>(record);
  }

  Position
  operator[](pcl::index_t index) const
  {
    return (*this)[static_cast<std::size_t>(index)];
  }

private:
  template <typename Number>
  Position
  read(const std::uint8_t* record) const
  {
    Number x, y, z;
    std::memcpy(&x, record + layout_.offsets[0], sizeof(Number));
    std::memcpy(&y, record + layout_.offsets[1], sizeof(Number));
    std::memcpy(&z, record + layout_.offsets[2], sizeof(Number));
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }

  const std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
  TripleLayout layout_;
  Position origin_ = Position::Zero();
};

/** \brief An array of points as a view. */
inline PointView
viewOf(const PointArray& array)
{
  if (array.size == 0)
    return {};
  return {array.xyz,
          array.size,
          {array.stride * sizeof(float), {0, sizeof(float), 2 * sizeof(float)}}};
}

} // namespace pcl::ccaa
