// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: a neighborhood laid into its regression plane.
//
// Part of the kernel text, see edge_certificate_kernel_impl.h.
#pragma once

#include "greedy/edge_certificate_kernel.h"

namespace pcl::ccaa::certificate::PCL_KERNEL {

/** Partial sums are kept in this many lanes whatever the instruction set, so that every
 * machine adds in the same order. */
constexpr int SUM_LANES = 8;

/** Neighbors counted for the local spacing. */
constexpr int SPACING_NEIGHBORS = 6;

/** Over this ratio of thickness to width a neighborhood is thick: no plane is in sight
 * at the scale of the spacing. */
constexpr float THICK_RATIO = 0.2f;

/** A thick neighborhood with no gap of this share of its thickness is noise, not a pile
 * of sheets. */
constexpr float LAYER_GAP = 0.5f;

/** Sine of the steepest rise of a certified edge over the plane. */
constexpr float STEEPEST_EDGE = 0.85f;

/** Sine of the steepest rise over the plane at which a witness still counts as lying in
 * it, 44 degrees. */
constexpr float STEEPNESS = 0.75f;

inline float
magnitude(float value)
{
  return value < 0 ? -value : value;
}

/** A neighborhood relative to its point, in units of the local spacing, first along the
 * axes of the cloud, then along those of the regression plane (z = height). */
template <int LANES>
struct Neighborhood {
  alignas(64) float x[LANES];
  alignas(64) float y[LANES];
  alignas(64) float z[LANES];
  alignas(64) float squared[LANES]; /**< squared distance */
  int count;
};

template <int LANES>
inline void
gather(const CertificateInput& input, std::int32_t rank, Neighborhood<LANES>& hood)
{
  const std::int32_t* row = input.rows + std::size_t(rank) * input.k;
  const float* centre = input.coordinates + 3 * std::size_t(rank);
  hood.count = static_cast<int>(input.k);
  while (hood.count > 0 && row[hood.count - 1] < 0)
    --hood.count;
  for (int j = 0; j < LANES; ++j) {
    // Lanes past the end hold the point itself: it adds nothing to any sum.
    const std::int32_t other = j < hood.count ? row[j] : rank;
    const float* p = input.coordinates + 3 * std::size_t(other);
    hood.x[j] = p[0] - centre[0];
    hood.y[j] = p[1] - centre[1];
    hood.z[j] = p[2] - centre[2];
  }
}

/** Scale to units of the local spacing, so that nothing below can over- or underflow;
 * the spacing itself is found in double for the same reason.
 * \return the spacing */
template <int LANES>
inline double
normalise(Neighborhood<LANES>& hood)
{
  const int nearest = hood.count < SPACING_NEIGHBORS ? hood.count : SPACING_NEIGHBORS;
  double sum = 0;
  for (int j = 0; j < nearest; ++j) {
    const double x = hood.x[j], y = hood.y[j], z = hood.z[j];
    sum += x * x + y * y + z * z;
  }
  const double spacing = __builtin_sqrt(sum / nearest);
  const auto scale = static_cast<float>(1.0 / spacing);
  for (int j = 0; j < LANES; ++j) {
    hood.x[j] *= scale;
    hood.y[j] *= scale;
    hood.z[j] *= scale;
    hood.squared[j] =
        hood.x[j] * hood.x[j] + hood.y[j] * hood.y[j] + hood.z[j] * hood.z[j];
  }
  return spacing;
}

/** A symmetric 3 x 3 matrix. */
struct Symmetric {
  float xx, xy, xz, yy, yz, zz;
};

inline float
sumOfLanes(float (&lane)[SUM_LANES])
{
  for (int width = SUM_LANES / 2; width > 0; width /= 2)
    for (int l = 0; l < width; ++l)
      lane[l] += lane[l + width];
  return lane[0];
}

template <int LANES>
inline float
sumOfProducts(const float (&a)[LANES], const float (&b)[LANES])
{
  alignas(32) float lane[SUM_LANES] = {};
  for (int j = 0; j < LANES; j += SUM_LANES)
    for (int l = 0; l < SUM_LANES; ++l)
      lane[l] += a[j + l] * b[j + l];
  return sumOfLanes(lane);
}

template <int LANES>
inline float
sumOf(const float (&a)[LANES])
{
  alignas(32) float lane[SUM_LANES] = {};
  for (int j = 0; j < LANES; j += SUM_LANES)
    for (int l = 0; l < SUM_LANES; ++l)
      lane[l] += a[j + l];
  return sumOfLanes(lane);
}

/** Covariance of the neighborhood, its point included. */
template <int LANES>
inline Symmetric
covariance(const Neighborhood<LANES>& hood)
{
  const float share = 1.0f / static_cast<float>(hood.count + 1);
  const float x = sumOf(hood.x), y = sumOf(hood.y), z = sumOf(hood.z);
  const float mx = x * share, my = y * share, mz = z * share;
  return {(sumOfProducts(hood.x, hood.x) - mx * x) * share,
          (sumOfProducts(hood.x, hood.y) - mx * y) * share,
          (sumOfProducts(hood.x, hood.z) - mx * z) * share,
          (sumOfProducts(hood.y, hood.y) - my * y) * share,
          (sumOfProducts(hood.y, hood.z) - my * z) * share,
          (sumOfProducts(hood.z, hood.z) - mz * z) * share};
}

inline Symmetric
scaled(const Symmetric& m)
{
  const float trace = m.xx + m.yy + m.zz;
  const float s = trace > 0 ? 1.0f / trace : 0.0f;
  return {m.xx * s, m.xy * s, m.xz * s, m.yy * s, m.yz * s, m.zz * s};
}

inline Symmetric
adjugate(const Symmetric& m)
{
  return {m.yy * m.zz - m.yz * m.yz,
          m.xz * m.yz - m.xy * m.zz,
          m.xy * m.yz - m.xz * m.yy,
          m.xx * m.zz - m.xz * m.xz,
          m.xy * m.xz - m.xx * m.yz,
          m.xx * m.yy - m.xy * m.xy};
}

inline Symmetric
square(const Symmetric& m)
{
  return {m.xx * m.xx + m.xy * m.xy + m.xz * m.xz,
          m.xx * m.xy + m.xy * m.yy + m.xz * m.yz,
          m.xx * m.xz + m.xy * m.yz + m.xz * m.zz,
          m.xy * m.xy + m.yy * m.yy + m.yz * m.yz,
          m.xy * m.xz + m.yy * m.yz + m.yz * m.zz,
          m.xz * m.xz + m.yz * m.yz + m.zz * m.zz};
}

struct Direction {
  float x, y, z;
};

inline Direction
unit(float x, float y, float z)
{
  const float scale = 1.0f / __builtin_sqrtf(x * x + y * y + z * z);
  return {x * scale, y * scale, z * scale};
}

/** A direction that is not along the line on which all points lie. */
inline Direction
acrossLine(const Symmetric& c)
{
  if (c.zz <= c.xx && c.zz <= c.yy)
    return {0, 0, 1};
  return c.yy <= c.xx ? Direction{0, 1, 0} : Direction{1, 0, 0};
}

/** Normal of the regression plane. The adjugate has the eigenvectors of the covariance
 * with the products of the other two eigenvalues, so the normal dominates it; three
 * squarings are eight steps of power iteration. */
inline Direction
planeNormal(const Symmetric& covariance)
{
  // With trace 1 at the start the largest entry is still over 1e-4 at the end.
  const Symmetric power = square(square(square(scaled(adjugate(covariance)))));
  // The column with the largest diagonal is the longest multiple of the normal.
  if (!(power.xx + power.yy + power.zz > 0)) // collinear: any direction across will do
    return acrossLine(covariance);
  if (power.xx >= power.yy && power.xx >= power.zz)
    return unit(power.xx, power.xy, power.xz);
  if (power.yy >= power.zz)
    return unit(power.xy, power.yy, power.yz);
  return unit(power.xz, power.yz, power.zz);
}

/** Whether the neighborhood is thick for its width: sqrt(l0 / l1) over THICK_RATIO,
 * with the eigenvalue l0 along the normal and l1 the smaller root of the quadratic that
 * the trace and the adjugate give; solved for the sign, so without taking the root. */
inline bool
isThick(const Symmetric& c, const Direction& n)
{
  const auto along = [&n](const Symmetric& m) {
    return n.x * (m.xx * n.x + 2 * (m.xy * n.y + m.xz * n.z)) +
           n.y * (m.yy * n.y + 2 * m.yz * n.z) + n.z * n.z * m.zz;
  };
  const float thickness = along(c);
  const float sum = c.xx + c.yy + c.zz - thickness;
  const float product = along(adjugate(c));
  const float rest = sum - thickness * (2.0f / (THICK_RATIO * THICK_RATIO));
  return rest < 0 || sum * sum - 4 * product > rest * rest;
}

/** Turn the neighborhood so that z is the height over the regression plane. */
template <int LANES>
inline void
turnToPlane(Neighborhood<LANES>& hood, const Direction& n)
{
  // Any tangent will do, as long as it is made of components that are not both small.
  const bool along_x = magnitude(n.x) > 0.6f;
  const Direction u = along_x ? unit(-n.y, n.x, 0) : unit(0, -n.z, n.y);
  const Direction v{
      n.y * u.z - n.z * u.y, n.z * u.x - n.x * u.z, n.x * u.y - n.y * u.x};
  for (int j = 0; j < LANES; ++j) {
    const float x = hood.x[j], y = hood.y[j], z = hood.z[j];
    hood.x[j] = x * u.x + y * u.y + z * u.z;
    hood.y[j] = x * v.x + y * v.y + z * v.z;
    hood.z[j] = x * n.x + y * n.y + z * n.z;
  }
}

/** Whether the heights, the point's own among them, leave no gap that speaks of layers.
 */
template <int LANES>
inline bool
isUnlayered(const Neighborhood<LANES>& hood)
{
  float heights[LANES + 1] = {0.0f};
  for (int j = 0; j < hood.count; ++j) { // insertion sort: short, and no library inside
    int place = j + 1;
    for (; place > 0 && heights[place - 1] > hood.z[j]; --place)
      heights[place] = heights[place - 1];
    heights[place] = hood.z[j];
  }
  float gap = 0;
  for (int j = 0; j < hood.count; ++j)
    if (heights[j + 1] - heights[j] > gap)
      gap = heights[j + 1] - heights[j];
  return gap < LAYER_GAP * (heights[hood.count] - heights[0]);
}

/** The edges that lead along the surface: not steeper over the plane than
 * STEEPEST_EDGE. An edge that climbs out of it has no circle in the plane to be empty,
 * and would bridge the sheets of a thin wall. */
template <int LANES>
inline std::uint64_t
edgesAlongSurface(const Neighborhood<LANES>& hood)
{
  std::uint64_t along = 0;
  for (int j = 0; j < hood.count; ++j) {
    const bool flat =
        hood.z[j] * hood.z[j] <= STEEPEST_EDGE * STEEPEST_EDGE * hood.squared[j];
    along |= std::uint64_t(flat) << j;
  }
  return along;
}

/** Lay the neighbors into the plane, but for the steep ones. */
template <int LANES>
inline void
flatten(Neighborhood<LANES>& hood, bool all)
{
  const float steepest = all ? 2.0f : STEEPNESS * STEEPNESS;
  for (int j = 0; j < LANES; ++j)
    hood.z[j] = hood.z[j] * hood.z[j] > steepest * hood.squared[j] ? hood.z[j] : 0.0f;
}

} // namespace pcl::ccaa::certificate::PCL_KERNEL
