// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how field and trust fall off with distance (4.45).

#pragma once

#include <cmath>

namespace pcl::repair {

/** \brief 1 up to `near`, ((far - x) / (far - near))^exponent between, 0 from `far` on
 * (E4.45-1, E4.45-2 without the factor). Where near >= far it is a step at far.
 * Distances in the units of the cloud. */
struct Falloff {
  double near = 0.0;     /**< L_1 or R_1, at least 0 */
  double far = 0.0;      /**< L_2 or R_2; 0: nothing reaches anywhere */
  double exponent = 1.0; /**< chi or gamma, above 0 */

  double
  operator()(double distance) const
  {
    if (distance >= far)
      return 0.0;
    if (distance <= near)
      return 1.0;
    const double rest = (far - distance) / (far - near);
    return exponent == 1.0 ? rest : std::pow(rest, exponent);
  }
};

/** \brief G(0) = k_t / (1 - k_t) of a free point (E4.424-1c).
 * \param[in] trust k_t, in [0, 1) */
inline double
trustedTension(double trust)
{
  return trust / (1.0 - trust);
}

} // namespace pcl::repair
