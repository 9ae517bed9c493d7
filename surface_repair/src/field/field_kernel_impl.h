// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the field of many sources, one text for all instruction
// sets.
//
// Included once per instruction set with PCL_REPAIR_KERNEL naming the namespace and
// PCL_REPAIR_REGISTER_BYTES the width of a vector register. Nothing of a library may be
// compiled in here: the linker could pick that copy for everybody. Every machine gets
// the same bits: no contraction, sums in fixed lanes.
#pragma once

#include "field_kernel.h"
#include "field_kernel_math.h"

namespace pcl {
namespace repair {
namespace field_kernel {
namespace PCL_REPAIR_KERNEL {

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

/** sigma = -(tau_X . tau_O) h (E4.5-1), and 0 within arc T of the origin (4.7). */
inline Lanes
effectiveCharge(const Task& task,
                const double* block,
                const Lanes (&tau)[3],
                const Lanes& charge)
{
  const Lanes along =
      task.tangent[0] * tau[0] + task.tangent[1] * tau[1] + task.tangent[2] * tau[2];
  const Lanes ahead = load(block + ARC * LANES) - task.arc;
  const Lanes way = ahead < 0.0 ? -ahead : ahead, back = task.length - way;
  const Lanes shorter = way < back ? way : back;
  return shorter > task.threshold ? -along * charge : all(0.0);
}

/** A block's sources seen from the point. */
struct View {
  Lanes d[3]; /**< unit(XO) */
  Lanes s[3]; /**< compatibility vector */
  Lanes m;    /**< h q_12 (1 + k_i q_4) */
};

template <Power POWER, bool FULL, bool EFFECTIVE, bool INTERPOLATION>
inline void
look(const Task& task, const double* block, std::size_t place, View& view)
{
  Lanes squared = all(0.0);
  for (int k = 0; k < 3; ++k) {
    view.d[k] = load(block + (X + k) * LANES) - task.position[k];
    squared = squared + view.d[k] * view.d[k];
  }
  const Lanes inverse = inverseRoot(squared);
  const Lanes tau[3] = {load(block + TANGENT_X * LANES),
                        load(block + TANGENT_Y * LANES),
                        load(block + TANGENT_Z * LANES)};
  for (int k = 0; k < 3; ++k)
    view.d[k] = view.d[k] * inverse;
  for (int k = 0; k < 3; ++k) { // ED4.421-3: s = -d x tau
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    view.s[k] = tau[a] * view.d[b] - tau[b] * view.d[a];
  }
  Lanes length = squared * inverse;
  if constexpr (FULL) // q_2 (E4.424-2)
    length = length * load(task.ratios + place);
  const Lanes rest = (task.far - length) * task.inverse_width;
  const Lanes not_negative = rest > 0.0 ? rest : all(0.0);
  const Lanes t = not_negative < 1.0 ? not_negative : all(1.0);
  Lanes charge = load(block + CHARGE * LANES);
  if constexpr (EFFECTIVE)
    charge = effectiveCharge(task, block, tau, charge);
  Lanes m = charge * raised<POWER>(t, task.exponent);
  if constexpr (INTERPOLATION) { // 1 + k_i (1 + s . n) / 2 (E4.426-1)
    const Lanes along = view.s[0] * load(block + NORMAL_X * LANES) +
                        view.s[1] * load(block + NORMAL_Y * LANES) +
                        view.s[2] * load(block + NORMAL_Z * LANES);
    m = m * (1.0 + task.half_interpolation * (1.0 + along));
  }
  if constexpr (FULL)
    m = m * load(task.deltas + place);
  view.m = squared > task.least_squared ? m : all(0.0);
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

/** H = sum of m d s^T (E4.43-3; B changes nothing because s is perpendicular to d). */
template <Power POWER, bool FULL, bool EFFECTIVE, bool INTERPOLATION>
void
sumOf(const Task& task, double* tension)
{
  alignas(64) double lanes[9][LANES];
  for (int pass = 0; pass < LANES; pass += WIDTH) {
    Lanes h[9] = {};
    for (std::size_t i = 0; i < task.count; ++i) {
      View view;
      look<POWER, FULL, EFFECTIVE, INTERPOLATION>(
          task,
          task.blocks + std::size_t(ROWS * LANES) * task.list[i] + pass,
          i * LANES + static_cast<std::size_t>(pass),
          view);
      for (int r = 0; r < 3; ++r) {
        const Lanes row = view.m * view.d[r];
        for (int c = 0; c < 3; ++c)
          h[3 * r + c] = h[3 * r + c] + row * view.s[c];
      }
    }
    for (int i = 0; i < 9; ++i)
      __builtin_memcpy(&lanes[i][pass], &h[i], sizeof(Lanes));
  }
  addLanes(lanes, tension);
}

template <Power POWER, bool FULL, bool EFFECTIVE>
void
sumByInterpolation(const Task& task, double* tension)
{
  if (task.half_interpolation != 0.0)
    sumOf<POWER, FULL, EFFECTIVE, true>(task, tension);
  else
    sumOf<POWER, FULL, EFFECTIVE, false>(task, tension);
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

} // namespace PCL_REPAIR_KERNEL
} // namespace field_kernel
} // namespace repair
} // namespace pcl
