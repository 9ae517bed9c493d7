// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the field of many sources, one text for all instruction
// sets.
//
// Included once per instruction set, see run/registers.h, with PCL_FIELD_CHAINS the
// number of blocks side by side (what the registers can hold). Nothing of a library may
// be compiled in here: the linker could pick that copy for everybody. Every machine
// gets the same bits: no contraction, sums in fixed lanes.
#pragma once

#include "field/field_kernel.h"
#include "field/field_kernel_math.h"

namespace pcl::repair::field_kernel::PCL_KERNEL {

/** How (..)^chi is raised. */
enum class Power { WHOLE, HALF, ANY };

/** t^chi for t in [0, 1] (E4.45-1b); a multiple of one half by products and a root. */
template <Power POWER>
inline Lanes
raised(const Lanes& t, double exponent)
{
  if constexpr (POWER == Power::ANY) {
    const Lanes logarithm = binaryLogarithm(t > 1e-300 ? t : all(1e-300));
    const Lanes least = all(-1000.0), wanted = exponent * logarithm;
    const Lanes power = binaryExponential(wanted > least ? wanted : least);
    return t > 0.0 ? power : all(0.0);
  }
  else {
    Lanes power = POWER == Power::HALF ? squareRoot(t) : t;
    const int factors = static_cast<int>(exponent) - (POWER == Power::HALF ? 0 : 1);
    for (int i = 0; i < factors; ++i)
      power = power * t;
    return power;
  }
}

/** sigma / h = -(tau_X . tau_O) (E4.5-1), and 0 within arc T of the origin (4.7). */
inline Lanes
effectiveShare(const Task& task, const double* block, const Lanes (&tau)[3])
{
  const Lanes along =
      task.tangent[0] * tau[0] + task.tangent[1] * tau[1] + task.tangent[2] * tau[2];
  const Lanes ahead = load(block + ARC * LANES) - task.arc;
  const Lanes way = larger(ahead, -ahead);
  const Lanes shorter = smaller(way, task.length - way);
  const Lanes share = -along * load(block + INVERSE_CHARGE * LANES);
  return shorter > task.threshold ? share : all(0.0);
}

/** A block's sources seen from the point. */
struct View {
  const double* block; /**< its rows, from the lane on at which the register begins */
  Lanes u[3];          /**< XO = r d */
  Lanes squared;       /**< r^2 */
  Lanes inverse;       /**< 1 / r */
  Lanes s[3];          /**< h r s, s the compatibility vector */
  Lanes m;             /**< q_12 (1 + k_i q_4) / r^2 */
};

inline void
approach(const Task& task, View& view)
{
  for (int k = 0; k < 3; ++k)
    view.u[k] = load(view.block + (X + k) * LANES) - task.position[k];
  view.squared = view.u[0] * view.u[0] + view.u[1] * view.u[1] + view.u[2] * view.u[2];
  view.inverse = inverseRoot(larger(view.squared, all(task.least_squared)));
}

/** t of q_1 = t^chi (E4.45-1). \param[in] place of the block's lanes in full mode */
template <bool FULL>
inline Lanes
restOfReach(const Task& task, const View& view, std::size_t place)
{
  Lanes length = view.squared * view.inverse;
  if constexpr (FULL) // q_2 (E4.424-2)
    length = length * load(task.ratios + place);
  const Lanes rest = (task.far - length) * task.inverse_width;
  return smaller(larger(rest, all(0.0)), all(1.0));
}

/** All but q_1 of what a source weighs. */
template <bool FULL, bool EFFECTIVE, bool INTERPOLATION>
inline void
weigh(const Task& task, const Lanes& q_1, std::size_t place, View& view)
{
  const double* block = view.block;
  const Lanes tau[3] = {load(block + TANGENT_X * LANES), // all of them h tau
                        load(block + TANGENT_Y * LANES),
                        load(block + TANGENT_Z * LANES)};
  for (int k = 0; k < 3; ++k) { // ED4.421-3: s = -d x tau
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    view.s[k] = tau[a] * view.u[b] - tau[b] * view.u[a];
  }
  Lanes m = q_1 * (view.inverse * view.inverse);
  if constexpr (EFFECTIVE)
    m = m * effectiveShare(task, block, tau);
  if constexpr (INTERPOLATION) { // 1 + k_i (1 + s . n) / 2 (E4.427-2, E4.426-1)
    const Lanes along = view.s[0] * load(block + NORMAL_X * LANES) +
                        view.s[1] * load(block + NORMAL_Y * LANES) +
                        view.s[2] * load(block + NORMAL_Z * LANES); // of n / h
    m = m * (1.0 + task.half_interpolation * (1.0 + along * view.inverse));
  }
  if constexpr (FULL) { // a short way does not bring in what is beyond L_2
    m = m * load(task.deltas + place);
    m = task.far - view.squared * view.inverse > 0.0 ? m : all(0.0);
  }
  view.m = view.squared > task.least_squared ? m : all(0.0);
}

/** Add the lanes of each of the nine sums, in halves. */
inline void
addLanes(double (&lanes)[9][LANES], double* tension)
{
  for (int i = 0; i < 9; ++i) {
    for (int width = LANES / 2; width > 0; width /= 2)
      for (int l = 0; l < width; ++l)
        lanes[i][l] += lanes[i][l + width];
    tension[i] = lanes[i][0];
  }
}

/** Which sources are added up, and how. */
template <Power POWER_, bool FULL_, bool EFFECTIVE_, bool INTERPOLATION_>
struct Mode {
  static constexpr Power POWER = POWER_;
  static constexpr bool FULL = FULL_, EFFECTIVE = EFFECTIVE_;
  static constexpr bool INTERPOLATION = INTERPOLATION_;
};

/** Add SIDE_BY_SIDE blocks of the list to the nine sums, one after the other. What
 * leads to a weight is a long chain of operations that wait for each other; several
 * such chains keep the processor busy. */
template <typename M, int SIDE_BY_SIDE>
inline void
addBlocks(const Task& task, std::size_t first, int pass, Lanes (&h)[9])
{
  View views[SIDE_BY_SIDE];
  Lanes q_1[SIDE_BY_SIDE];
  const auto place = [&](int j) {
    return (first + static_cast<std::size_t>(j)) * LANES +
           static_cast<std::size_t>(pass);
  };
  for (int j = 0; j < SIDE_BY_SIDE; ++j) {
    const std::size_t block = task.list[first + static_cast<std::size_t>(j)];
    views[j].block = task.blocks + block * (ROWS * LANES) + pass;
    approach(task, views[j]);
  }
  for (int j = 0; j < SIDE_BY_SIDE; ++j)
    q_1[j] =
        raised<M::POWER>(restOfReach<M::FULL>(task, views[j], place(j)), task.exponent);
  for (int j = 0; j < SIDE_BY_SIDE; ++j)
    weigh<M::FULL, M::EFFECTIVE, M::INTERPOLATION>(task, q_1[j], place(j), views[j]);
  for (int j = 0; j < SIDE_BY_SIDE; ++j)
    for (int r = 0; r < 3; ++r) {
      const Lanes row = views[j].m * views[j].u[r];
      for (int c = 0; c < 3; ++c)
        h[3 * r + c] = h[3 * r + c] + row * views[j].s[c];
    }
}

/** H = sum of h m d s^T (E4.46-2; A of E4.43-3 is m d s^T as in E4.43-4, and B changes
 * nothing because s is perpendicular to d). */
template <typename M>
void
sumOf(const Task& task, double* tension)
{
  constexpr int CHAINS = PCL_FIELD_CHAINS;
  alignas(64) double lanes[9][LANES];
  for (int pass = 0; pass < LANES; pass += WIDTH) {
    Lanes h[9] = {};
    std::size_t i = 0;
    for (; i + CHAINS <= task.count; i += CHAINS)
      addBlocks<M, CHAINS>(task, i, pass, h);
    for (; i < task.count; ++i)
      addBlocks<M, 1>(task, i, pass, h);
    for (int k = 0; k < 9; ++k)
      __builtin_memcpy(&lanes[k][pass], &h[k], sizeof(Lanes));
  }
  addLanes(lanes, tension);
}

/** Which balls of a group's blocks meet the ball of L_2 around the point. \param[out]
 * list room for all of them \return how many */
inline std::size_t
selectBlocks(const Candidates& candidates,
             std::size_t begin,
             const Task& task,
             std::uint32_t* list)
{
  std::size_t count = 0;
  for (std::size_t first = begin; first < begin + LANES; first += WIDTH) {
    Lanes squared = all(0.0);
    for (int k = 0; k < 3; ++k) {
      const Lanes u = load(candidates.center[k] + first) - task.position[k];
      squared = squared + u * u;
    }
    const Lanes reach = load(candidates.radius + first) + task.far;
    const Bits meets = squared < reach * reach;
    for (int i = 0; i < WIDTH; ++i) {
      list[count] = candidates.blocks[first + static_cast<std::size_t>(i)];
      count -= static_cast<std::size_t>(meets[i]);
    }
  }
  return count;
}

inline std::size_t
select(const Candidates& candidates, const Task& task, std::uint32_t* list)
{
  std::size_t count = 0;
  for (std::size_t g = 0; g < candidates.count; ++g) {
    const CandidateGroup& group = candidates.groups[g];
    double squared = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double u = group.center[k] - task.position[k];
      squared = squared + u * u;
    }
    const double reach = group.radius + task.far;
    if (!(squared < reach * reach))
      continue;
    if (task.coarse && squared >= group.coarse_from * group.coarse_from)
      list[count++] = group.coarse;
    else
      count += selectBlocks(candidates, g * LANES, task, list + count);
  }
  return count;
}

template <Power POWER, bool FULL, bool EFFECTIVE>
void
sumByInterpolation(const Task& task, double* tension)
{
  if (task.half_interpolation != 0.0)
    sumOf<Mode<POWER, FULL, EFFECTIVE, true>>(task, tension);
  else
    sumOf<Mode<POWER, FULL, EFFECTIVE, false>>(task, tension);
}

template <Power POWER>
void
sumByMode(const Task& task, double* tension)
{
  const bool full = task.ratios != nullptr;
  if (full && task.effective)
    sumByInterpolation<POWER, true, true>(task, tension);
  else if (full)
    sumByInterpolation<POWER, true, false>(task, tension);
  else if (task.effective)
    sumByInterpolation<POWER, false, true>(task, tension);
  else
    sumByInterpolation<POWER, false, false>(task, tension);
}

inline void
sum(const Task& task, double* tension)
{
  const double twice = 2.0 * task.exponent;
  const bool is_short = twice >= 1.0 && twice <= 16.0;
  if (!is_short || twice != static_cast<int>(twice))
    sumByMode<Power::ANY>(task, tension);
  else if (static_cast<int>(twice) % 2 == 1)
    sumByMode<Power::HALF>(task, tension);
  else
    sumByMode<Power::WHOLE>(task, tension);
}

} // namespace pcl::repair::field_kernel::PCL_KERNEL
