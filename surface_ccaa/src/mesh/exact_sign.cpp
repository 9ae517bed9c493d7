// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: geometric predicates that never err.
#include "mesh/exact_sign.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace pcl::ccaa {
namespace {

/** \brief Bounds of the relative rounding error of the two determinants (Shewchuk 1997,
 * "Adaptive precision floating-point arithmetic and fast robust geometric predicates").
 */
constexpr double UNIT = std::numeric_limits<double>::epsilon() / 2.0;
constexpr double PLANE_ERROR = (7.0 + 56.0 * UNIT) * UNIT;
constexpr double TURN_ERROR = (3.0 + 16.0 * UNIT) * UNIT;

/** \brief Outside these magnitudes products may have lost bits to underflow or are
 * infinite, so the error bounds do not hold. */
constexpr double LEAST_MAGNITUDE = 1e-250;
constexpr double MOST_MAGNITUDE = 1e300;

constexpr int UNDECIDED = 2;

/** \brief Sign of a determinant, or UNDECIDED when rounding may have changed it. */
int
filteredSign(double determinant, double magnitude, double relative_error)
{
  if (!(magnitude > LEAST_MAGNITUDE && magnitude < MOST_MAGNITUDE))
    return UNDECIDED;
  const double error = relative_error * magnitude;
  if (determinant > error)
    return 1;
  return determinant < -error ? -1 : UNDECIDED;
}

/** \brief Integers of fixed size need no allocation; short ones are the processor's,
 * where it has them. */
#ifdef BOOST_HAS_INT128
using ShortInteger = boost::int128_type;
#else
using ShortInteger = boost::multiprecision::int128_t;
#endif
using LongInteger = boost::multiprecision::int256_t;
using AnyInteger =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                  boost::multiprecision::et_off>;
/** Bits of coordinates whose determinants these hold: of four points, 6 products of
 * three differences of one bit more; of three points, 2 products of two. */
constexpr int SHORT_PLANE_BITS = 40;
constexpr int LONG_PLANE_BITS = 80;
constexpr int SHORT_TURN_BITS = 62;
constexpr int LONG_TURN_BITS = 126;

/** \brief A finite double as what it is: mantissa * 2^low, the mantissa odd or zero. */
struct BinaryNumber {
  std::int64_t mantissa = 0;
  int low = 0;
  int high = 0; /**< the number is smaller than 2^high */

  explicit BinaryNumber(double value)
  {
    static_assert(std::numeric_limits<double>::is_iec559, "binary64");
    if (value == 0.0)
      return;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    const int biased = static_cast<int>(bits >> 52 & 0x7ff);
    std::uint64_t digits = bits & ((1ULL << 52) - 1);
    if (biased > 0) // the smallest numbers lack the first digit
      digits |= 1ULL << 52;
    const int zeros = __builtin_ctzll(digits);
    low = std::max(biased, 1) - 1075;
    high = low + 53;
    low += zeros;
    mantissa = static_cast<std::int64_t>(digits >> zeros);
    if (value < 0.0)
      mantissa = -mantissa;
  }
};

/** \brief Powers of two that bound a set of coordinates, all of which are multiples of
 * 2^low and smaller than 2^high. */
struct BitRange {
  int low = std::numeric_limits<int>::max();
  int high = std::numeric_limits<int>::min();

  void
  extend(double value)
  {
    const BinaryNumber number(value);
    if (number.mantissa == 0)
      return;
    low = std::min(low, number.low);
    high = std::max(high, number.high);
  }

  int
  bits() const
  {
    return high - low;
  }
};

/** \brief A multiple of 2^low in multiples of it. */
template <typename Integer>
Integer
scaled(double value, int low)
{
  const BinaryNumber number(value);
  Integer result(number.mantissa);
  if (number.mantissa != 0)
    result *= Integer(1) << static_cast<unsigned int>(number.low - low);
  return result;
}

template <typename Integer>
int
signOf(const Integer& value)
{
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

template <typename Integer>
int
planeSign(const Position (&points)[4], int low)
{
  Integer row[3][3];
  for (int k = 0; k < 3; ++k) {
    const Integer last = scaled<Integer>(points[3][k], low);
    for (int i = 0; i < 3; ++i)
      row[i][k] = scaled<Integer>(points[i][k], low) - last;
  }
  const auto minor = [&](int i, int j) -> Integer {
    return row[i][0] * row[j][1] - row[i][1] * row[j][0];
  };
  const Integer determinant =
      row[0][2] * minor(1, 2) + row[1][2] * minor(2, 0) + row[2][2] * minor(0, 1);
  return signOf(determinant);
}

template <typename Integer>
int
turnSign(const Position (&points)[3], int u, int v, int low)
{
  const auto at = [&](int point, int axis) {
    return scaled<Integer>(points[point][axis], low);
  };
  const Integer last_u = at(2, u), last_v = at(2, v);
  const Integer determinant = (at(0, u) - last_u) * (at(1, v) - last_v) -
                              (at(0, v) - last_v) * (at(1, u) - last_u);
  return signOf(determinant);
}

/** \brief Whether equal coordinates alone make four points coplanar, as those of meshes
 * of axis-parallel planes and of depth frames all the time: all are equal in an axis,
 * or two of the six edges between them are parallel to the same axis. */
bool
areOnAxes(const Position (&points)[4])
{
  std::array<int, 3> in_plane{}, along{};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) {
      const auto same = [&](int k) { return points[i][k] == points[j][k]; };
      for (int k = 0; k < 3; ++k) {
        in_plane[static_cast<std::size_t>(k)] += same(k);
        along[static_cast<std::size_t>(k)] += same((k + 1) % 3) && same((k + 2) % 3);
      }
    }
  return *std::max_element(in_plane.begin(), in_plane.end()) == 6 ||
         *std::max_element(along.begin(), along.end()) > 1;
}

/** Out of line like exactTurn(): its integers would give the filter before it a frame
 * of a kilobyte. */
[[gnu::noinline]] int
exactSideOfPlane(const Position (&points)[4])
{
  BitRange bits;
  for (const Position& point : points)
    for (Eigen::Index k = 0; k < 3; ++k)
      bits.extend(point[k]);
  if (bits.low > bits.high)
    return 0;
  if (bits.bits() <= SHORT_PLANE_BITS)
    return -planeSign<ShortInteger>(points, bits.low);
  return bits.bits() <= LONG_PLANE_BITS ? -planeSign<LongInteger>(points, bits.low)
                                        : -planeSign<AnyInteger>(points, bits.low);
}

[[gnu::noinline]] int
exactTurn(const Position (&points)[3], int u, int v)
{
  BitRange bits;
  for (const Position& point : points) {
    bits.extend(point[u]);
    bits.extend(point[v]);
  }
  if (bits.low > bits.high)
    return 0;
  if (bits.bits() <= SHORT_TURN_BITS)
    return turnSign<ShortInteger>(points, u, v, bits.low);
  return bits.bits() <= LONG_TURN_BITS ? turnSign<LongInteger>(points, u, v, bits.low)
                                       : turnSign<AnyInteger>(points, u, v, bits.low);
}

} // namespace

ExactPlane::ExactPlane(const Position& a, const Position& b, const Position& c)
: a_(a), b_(b), c_(c)
{
  const Eigen::Vector3d u = b - a, v = c - a;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Index i = (k + 1) % 3, j = (k + 2) % 3;
    const double left = u[i] * v[j], right = u[j] * v[i];
    normal_[k] = left - right;
    magnitude_[k] = std::abs(left) + std::abs(right);
  }
}

int
ExactPlane::sideOf(const Position& p) const
{
  const Eigen::Vector3d w = p - a_;
  const int sign =
      filteredSign(normal_.dot(w), magnitude_.dot(w.cwiseAbs()), PLANE_ERROR);
  if (sign != UNDECIDED)
    return sign;
  const Position points[] = {a_, b_, c_, p};
  return areOnAxes(points) ? 0 : exactSideOfPlane(points);
}

int
sideOfPlane(const Position& a, const Position& b, const Position& c, const Position& d)
{
  return ExactPlane(a, b, c).sideOf(d);
}

int
turnInPlane(const Position& a, const Position& b, const Position& c, int dropped)
{
  const int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
  const double left = (a[u] - c[u]) * (b[v] - c[v]);
  const double right = (a[v] - c[v]) * (b[u] - c[u]);
  const int sign =
      filteredSign(left - right, std::abs(left) + std::abs(right), TURN_ERROR);
  if (sign != UNDECIDED)
    return sign;
  const bool both_are_zero =
      (a[u] == c[u] || b[v] == c[v]) && (a[v] == c[v] || b[u] == c[u]);
  return both_are_zero ? 0 : exactTurn({a, b, c}, u, v);
}

int
droppableAxis(const Position& a, const Position& b, const Position& c)
{
  // Start with the axis in which the triangle is thinnest: nearly always the answer.
  const Eigen::Vector3d normal =
      Eigen::Vector3d((b - a).y() * (c - a).z() - (b - a).z() * (c - a).y(),
                      (b - a).z() * (c - a).x() - (b - a).x() * (c - a).z(),
                      (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x())
          .cwiseAbs();
  const int first = normal.x() >= normal.y() && normal.x() >= normal.z() ? 0
                    : normal.y() >= normal.z()                           ? 1
                                                                         : 2;
  for (int i = 0; i < 3; ++i)
    if (turnInPlane(a, b, c, (first + i) % 3) != 0)
      return (first + i) % 3;
  return -1;
}

} // namespace pcl::ccaa
