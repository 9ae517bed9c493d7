// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: points in the order of a space-filling curve.
#include "mesh/curve_order.h"

#include "mesh/hilbert_code.h"
#include "mesh/radix_sort.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <tuple>

namespace pcl::ccaa {

namespace {

/** Up to here a plain comparison sort is faster than going digit by digit. */
constexpr std::size_t SMALL_SORT = 1024;
/** Up to here points of one cell are put by their coordinates: a curve gains nothing.
 */
constexpr std::size_t SMALL_CELL = 16;
/** Points whose box decides where the outermost curve runs. */
constexpr std::size_t SAMPLE_SIZE = 1024;

struct FloatBounds {
  std::array<float, 3> low;
  std::array<float, 3> high;

  /** In double precision, where the difference of any two floats is finite. */
  double
  extent() const
  {
    double extent = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      extent = std::max(extent, double(high[axis]) - double(low[axis]));
    return extent;
  }

  /** Twice as large around the same middle. */
  FloatBounds
  doubled() const
  {
    FloatBounds result;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double margin = (double(high[axis]) - double(low[axis])) / 2;
      result.low[axis] = toFloat(double(low[axis]) - margin);
      result.high[axis] = toFloat(double(high[axis]) + margin);
    }
    return result;
  }

  static float
  toFloat(double value)
  {
    constexpr double limit = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -limit, limit));
  }
};

class CurveSorter {
public:
  CurveSorter(const PointArray& points, std::size_t capacity, int threads)
  : points_(points)
  , threads_(threads)
  , coded_(new CodedPoint[capacity])
  , spare_(new CodedPoint[capacity])
  {}

  void
  add(index_t point_index)
  {
    const float* p = points_[point_index];
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
      coded_[size_++] = {0, point_index};
  }

  std::vector<index_t>
  sorted()
  {
    sortAll();
    std::vector<index_t> order(size_);
#pragma omp parallel for num_threads(threads_) schedule(static)
    for (std::size_t i = 0; i < size_; ++i)
      order[i] = coded_[i].point_index;
    return order;
  }

private:
  /** The outermost curve runs through the box of a sample, not of all points: a few far
   * outliers would leave hardly any cells to the rest. What is outside counts to the
   * nearest cell. */
  void
  sortAll()
  {
    const std::size_t step = size_ / SAMPLE_SIZE;
    const FloatBounds box =
        step == 0 ? FloatBounds{} : boundingBox(0, size_, step).doubled();
    if (step == 0 || !(box.extent() > 0))
      sortCell(0, size_);
    else
      sortAlongCurve(0, size_, box);
  }

  /** Sort [begin, end), which share a cell of the curve around them, along a curve of
   * their own. The curve is at least 2^10 times finer than their box, so the depth is
   * bounded by the exponents a float can have, and points that differ in the longest
   * axis part in every round. */
  void
  sortCell(std::size_t begin, std::size_t end)
  {
    if (end - begin <= SMALL_CELL) {
      sortByCoordinates(begin, end);
      return;
    }
    const FloatBounds box = boundingBox(begin, end, 1);
    if (box.extent() > 0)
      sortAlongCurve(begin, end, box);
    else
      sortByIndex(begin, end);
  }

  void
  sortAlongCurve(std::size_t begin, std::size_t end, const FloatBounds& box)
  {
    const unsigned int bits = bitsPerAxis(end - begin);
    encode(begin, end, box, bits);
    sortByCode(begin, end, bits);
    sortSharedCells(begin, end);
  }

  void
  sortSharedCells(std::size_t begin, std::size_t end)
  {
    for (std::size_t first = begin, last; first < end; first = last) {
      for (last = first + 1; last < end && coded_[last].code == coded_[first].code;)
        ++last;
      if (last - first > 1)
        sortCell(first, last);
    }
  }

  void
  sortByCoordinates(std::size_t begin, std::size_t end)
  {
    const auto key = [this](const CodedPoint& point) {
      const float* p = points_[point.point_index];
      return std::make_tuple(p[0], p[1], p[2], point.point_index);
    };
    std::sort(
        coded_.get() + begin,
        coded_.get() + end,
        [&key](const CodedPoint& a, const CodedPoint& b) { return key(a) < key(b); });
  }

  void
  sortByIndex(std::size_t begin, std::size_t end)
  {
    std::sort(coded_.get() + begin,
              coded_.get() + end,
              [](const CodedPoint& a, const CodedPoint& b) {
                return a.point_index < b.point_index;
              });
  }

  void
  sortByCode(std::size_t begin, std::size_t end, unsigned int bits)
  {
    if (end - begin > SMALL_SORT) {
      radixSort(
          coded_.get() + begin, spare_.get() + begin, end - begin, 3 * bits, threads_);
      return;
    }
    std::sort(coded_.get() + begin,
              coded_.get() + end,
              [](const CodedPoint& a, const CodedPoint& b) {
                return std::tie(a.code, a.point_index) <
                       std::tie(b.code, b.point_index);
              });
  }

  /** Cells of about a sixteenth of the spacing that the points would have on a flat
   * square: few share one, and no more digits are sorted than are needed. */
  static unsigned int
  bitsPerAxis(std::size_t size)
  {
    unsigned int bits = 4;
    for (std::size_t cells = 1; cells < size; cells *= 4)
      ++bits;
    return std::clamp((bits + 1) / 2 * 2, 10u, 20u);
  }

  FloatBounds
  boundingBox(std::size_t begin, std::size_t end, std::size_t step) const
  {
    float low_x, low_y, low_z, high_x, high_y, high_z;
    low_x = low_y = low_z = std::numeric_limits<float>::infinity();
    high_x = high_y = high_z = -low_x;
#pragma omp parallel for num_threads(threads_) if (end - begin > SMALL_SORT * step)    \
    reduction(min                                                                      \
              : low_x, low_y, low_z) reduction(max                                     \
                                               : high_x, high_y, high_z)
    for (std::size_t i = begin; i < end; i += step) {
      const float* p = points_[coded_[i].point_index];
      low_x = std::min(low_x, p[0]);
      low_y = std::min(low_y, p[1]);
      low_z = std::min(low_z, p[2]);
      high_x = std::max(high_x, p[0]);
      high_y = std::max(high_y, p[1]);
      high_z = std::max(high_z, p[2]);
    }
    return {{low_x, low_y, low_z}, {high_x, high_y, high_z}};
  }

  void
  encode(std::size_t begin, std::size_t end, const FloatBounds& box, unsigned int bits)
  {
    const double last = (1u << bits) - 1;
    const double scale = last / box.extent();
#pragma omp parallel for num_threads(threads_) if (end - begin > SMALL_SORT)
    for (std::size_t i = begin; i < end; ++i) {
      const float* p = points_[coded_[i].point_index];
      const auto cell = [&box, p, scale, last](std::size_t axis) {
        const double place = (double(p[axis]) - double(box.low[axis])) * scale;
        return static_cast<std::uint32_t>(std::clamp(place, 0.0, last));
      };
      coded_[i].code = hilbert::code(cell(0), cell(1), cell(2), bits);
    }
  }

  PointArray points_;
  int threads_;
  std::size_t size_ = 0;
  std::unique_ptr<CodedPoint[]> coded_;
  std::unique_ptr<CodedPoint[]> spare_;
};

bool
equalPoints(const float* a, const float* b)
{
  return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

} // namespace

std::vector<index_t>
curveOrder(const PointArray& points, int threads)
{
  CurveSorter sorter(points, points.size, threads);
  for (std::size_t i = 0; i < points.size; ++i)
    sorter.add(static_cast<index_t>(i));
  return sorter.sorted();
}

std::vector<index_t>
curveOrder(const PointArray& points, const Indices& selection, int threads)
{
  CurveSorter sorter(points, selection.size(), threads);
  for (const index_t point_index : selection)
    sorter.add(point_index);
  return sorter.sorted();
}

std::vector<index_t>
removeDuplicates(const PointArray& points, const std::vector<index_t>& order)
{
  std::vector<index_t> unique;
  unique.reserve(order.size());
  for (const index_t point_index : order)
    if (unique.empty() || !equalPoints(points[unique.back()], points[point_index]))
      unique.push_back(point_index);
  return unique;
}

} // namespace pcl::ccaa
