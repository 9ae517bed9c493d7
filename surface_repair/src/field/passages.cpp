// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the way from a point to each of its sources, in full mode.
#include "field/passages.h"

#include <algorithm>
#include <cmath>

namespace pcl::repair {
namespace {

using field_kernel::LANES;

/** \brief Most sources between two that are looked at first, and so many that their
 * number alone is no reason to look closer. */
constexpr std::size_t LONGEST_SPAN = 6 * LANES;
constexpr std::size_t SHORT_SPAN = 2 * LANES;

/** \brief Longest span by its distance from the point. */
constexpr double WIDEST_SPAN = 2.0;

/** \brief Ratios that differ by more do not agree: between those that do, a straight
 * line is good enough. */
constexpr double RATIO_TOLERANCE = 0.25;

/** \brief A source with a smaller q_12 is not worth the question whether the surface is
 * in its way. */
constexpr double LEAST_WEIGHT = 0.005;

/** \brief Sources of consecutive blocks of one curve, and where their passages go. */
class Run {
public:
  struct Blocks {
    std::uint32_t first;
    std::size_t count;
  };

  Run(const SourceBlocks& blocks,
      const FieldQuery& query,
      const Surroundings& around,
      double shield_reach,
      Blocks listed)
  : blocks_(blocks)
  , x_(query.position)
  , far_(query.falloff.far)
  , shield_reach_(shield_reach)
  , around_(around)
  , first_(listed.first)
  , size_(listed.count * LANES)
  {}

  void
  fill(double* ratios, double* deltas) const
  {
    std::fill_n(ratios, size_, 1.0);
    std::fill_n(deltas, size_, 1.0);
    std::size_t begin = 0, end = size_;
    while (begin < end && !counts(begin))
      ++begin;
    while (end > begin && !counts(end - 1))
      --end;
    if (begin < end)
      fill(begin, end, ratios, deltas);
  }

private:
  struct Sample {
    std::size_t source; /**< counted from the beginning of the run */
    Position position;
    Passage passage;
  };

  const Position&
  positionOf(std::size_t source) const
  {
    return blocks_.position(first_ + source / LANES, source % LANES);
  }

  /** \brief Whether a source is within L_2. */
  bool
  counts(std::size_t source) const
  {
    return (positionOf(source) - x_).squaredNorm() < far_ * far_;
  }

  Sample
  sampleAt(std::size_t source) const
  {
    const Position& position = positionOf(source);
    return {source, position, passageOf(around_, x_, position, shield_reach_)};
  }

  /** \brief Look at the middles of equal parts of [begin, end). What is before the
   * first and behind the last of them is far away and weighs little: as its neighbour.
   */
  void
  fill(std::size_t begin, std::size_t end, double* ratios, double* deltas) const
  {
    const std::size_t count = end - begin;
    const std::size_t parts = (count + LONGEST_SPAN - 1) / LONGEST_SPAN;
    const auto middle = [&](std::size_t part) {
      return begin + (2 * part + 1) * count / (2 * parts);
    };
    Sample low = sampleAt(middle(0));
    std::fill(ratios + begin, ratios + low.source + 1, low.passage.ratio);
    std::fill(deltas + begin, deltas + low.source + 1, low.passage.delta);
    for (std::size_t part = 1; part < parts; ++part) {
      const Sample high = sampleAt(middle(part));
      between(low, high, ratios, deltas);
      put(high, ratios, deltas);
      low = high;
    }
    std::fill(ratios + low.source, ratios + end, low.passage.ratio);
    std::fill(deltas + low.source, deltas + end, low.passage.delta);
  }

  static void
  put(const Sample& sample, double* ratios, double* deltas)
  {
    ratios[sample.source] = sample.passage.ratio;
    deltas[sample.source] = sample.passage.delta;
  }

  /** \brief Whether what lies between two samples follows from them. */
  bool
  agree(const Sample& low, const Sample& high) const
  {
    if (low.passage.delta != high.passage.delta)
      return false;
    if (high.source - low.source <= SHORT_SPAN)
      return true;
    const double distance =
        std::min((low.position - x_).squaredNorm(), (high.position - x_).squaredNorm());
    return std::abs(low.passage.ratio - high.passage.ratio) <= RATIO_TOLERANCE &&
           (high.position - low.position).squaredNorm() <=
               WIDEST_SPAN * WIDEST_SPAN * distance;
  }

  /** \brief Fill in all sources between two samples; at most LONGEST_SPAN of them, so
   * this goes six deep. */
  void
  between(const Sample& low, const Sample& high, double* ratios, double* deltas) const
  {
    const std::size_t span = high.source - low.source;
    if (span < 2)
      return;
    if (!agree(low, high)) {
      const Sample middle = sampleAt(low.source + span / 2);
      put(middle, ratios, deltas);
      between(low, middle, ratios, deltas);
      between(middle, high, ratios, deltas);
      return;
    }
    const double step =
        (high.passage.ratio - low.passage.ratio) / static_cast<double>(span);
    for (std::size_t i = 1; i < span; ++i) {
      ratios[low.source + i] = low.passage.ratio + step * static_cast<double>(i);
      deltas[low.source + i] = low.passage.delta;
    }
  }

  const SourceBlocks& blocks_;
  const Position& x_;
  double far_, shield_reach_;
  const Surroundings& around_;
  std::uint32_t first_;
  std::size_t size_; /**< sources, those past the end of the curve among them */
};

} // namespace

double
ShieldReach::operator()(const Falloff& falloff)
{
  if (falloff.exponent != exponent_) {
    exponent_ = falloff.exponent;
    rest_ = std::pow(LEAST_WEIGHT, 1.0 / exponent_);
  }
  return falloff.far - rest_ * std::max(falloff.far - falloff.near, 0.0);
}

Passage
passageOf(const Surroundings& around,
          const Position& x,
          const Position& source,
          double shield_reach)
{
  Passage passage;
  if (around.free_points != nullptr)
    passage.ratio = around.free_points->lengthRatio(x, source);
  if (around.shield != nullptr && passage.ratio * (source - x).norm() <= shield_reach &&
      around.shield->crosses(x, source, around.tolerance))
    passage.delta = 0.0;
  return passage;
}

void
Passages::find(const SourceBlocks& blocks,
               const std::vector<std::uint32_t>& list,
               const FieldQuery& query,
               const Surroundings& around)
{
  ratios_.resize(list.size() * LANES);
  deltas_.resize(list.size() * LANES);
  const double reach = shield_reach_(query.falloff);
  for (std::size_t begin = 0, end = 0; begin < list.size(); begin = end) {
    do
      ++end;
    while (end < list.size() && list[end] == list[end - 1] + 1 &&
           blocks.curveOf(list[end]) == blocks.curveOf(list[begin]));
    const Run run(blocks, query, around, reach, {list[begin], end - begin});
    run.fill(ratios_.data() + begin * LANES, deltas_.data() + begin * LANES);
  }
}

} // namespace pcl::repair
