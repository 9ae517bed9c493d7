// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: stable sort of points by their code along a curve.
#include "mesh/radix_sort.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl::ccaa {

namespace {

/** Widest digit. Wider ones need fewer passes over memory, until the places written to,
 * one per value, no longer fit the second cache. */
constexpr unsigned int MAX_DIGIT_BITS = 12;

/** One pass: where the digit is, and how many points each slice has of each value. */
class Pass {
public:
  Pass(const CodedPoint* points,
       std::size_t size,
       unsigned int shift,
       unsigned int digit_bits,
       int slices)
  : points_(points)
  , size_(size)
  , shift_(shift)
  , values_(std::size_t(1) << digit_bits)
  , slices_(slices)
  , counts_(values_ * static_cast<std::size_t>(slices), 0)
  {}

  /** Count, and tell whether there is anything to do. */
  bool
  count()
  {
#pragma omp parallel for num_threads(slices_) schedule(static, 1)
    for (int slice = 0; slice < slices_; ++slice)
      for (std::size_t i = begin(slice); i < begin(slice + 1); ++i)
        ++counts(slice)[digit(points_[i])];
    return size_ > 0 && countOf(digit(points_[0])) < size_;
  }

  void
  scatterTo(CodedPoint* target)
  {
    countsToStarts();
#pragma omp parallel for num_threads(slices_) schedule(static, 1)
    for (int slice = 0; slice < slices_; ++slice) {
      std::size_t* const next = counts(slice);
      for (std::size_t i = begin(slice); i < begin(slice + 1); ++i)
        target[next[digit(points_[i])]++] = points_[i];
    }
  }

private:
  std::size_t
  begin(int slice) const
  {
    return size_ * static_cast<std::size_t>(slice) / static_cast<std::size_t>(slices_);
  }

  std::size_t
  digit(const CodedPoint& point) const
  {
    return static_cast<std::size_t>(point.code >> shift_) & (values_ - 1);
  }

  std::size_t*
  counts(int slice)
  {
    return &counts_[values_ * static_cast<std::size_t>(slice)];
  }

  std::size_t
  countOf(std::size_t value)
  {
    std::size_t sum = 0;
    for (int slice = 0; slice < slices_; ++slice)
      sum += counts(slice)[value];
    return sum;
  }

  /** Value by value, and within a value slice by slice: that keeps the sort stable. */
  void
  countsToStarts()
  {
    std::size_t start = 0;
    for (std::size_t value = 0; value < values_; ++value)
      for (int slice = 0; slice < slices_; ++slice)
        start += std::exchange(counts(slice)[value], start);
  }

  const CodedPoint* points_;
  std::size_t size_;
  unsigned int shift_;
  std::size_t values_;
  int slices_;
  std::vector<std::size_t> counts_;
};

} // namespace

void
radixSort(CodedPoint* points,
          CodedPoint* spare,
          std::size_t size,
          unsigned int bits,
          int threads)
{
  const unsigned int passes = (bits + MAX_DIGIT_BITS - 1) / MAX_DIGIT_BITS;
  const unsigned int digit_bits = passes == 0 ? 0 : (bits + passes - 1) / passes;
  CodedPoint* source = points;
  CodedPoint* target = spare;
  for (unsigned int i = 0; i < passes; ++i) {
    Pass pass(source, size, i * digit_bits, digit_bits, threads);
    if (!pass.count())
      continue;
    pass.scatterTo(target);
    std::swap(source, target);
  }
  if (source != points)
    std::copy(source, source + size, points);
}

} // namespace pcl::ccaa
