// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: how fast the indicator field is, and what full mode costs.
#pragma once

#include "field/field_source.h"
#include "icadm/incomplete_model.h"

#include <cstddef>
#include <string>
#include <vector>

namespace bench {

/** \brief Sources, and the model and free points around them. */
struct FieldCase {
  std::string name;
  pcl::repair::IncompleteModel model; /**< empty: nothing for full mode */
  pcl::repair::SourceSet sources;
  double gap = 0.0;  /**< width of what is missing, units of the cloud */
  double reach = 0.; /**< L_2 */
};

/** \brief Two rings of a thousand sources each, some 300 of them within L_2. */
FieldCase
facingRings();

/** \brief A mesh with three slabs across y taken away, 7 %, 7 % and 5 % of its height,
 * so that it falls into islands; every `keep_every`-th of the lost points stays as a
 * free point, all others are gone. \return without sources when it cannot be read */
FieldCase
slabbedMesh(const std::string& path, std::size_t keep_every);

/** \brief Light mode: one row of the table. */
struct LightSpeed {
  double exponent = 2.5;
  double interpolation = 0.0;
  bool effective = false;
  double pairs_per_query = 0.0; /**< sources within L_2 that count */
  double pairs_per_second = 0.0;
};

/** \brief Several exponents, with and without k_i and effective charges, on one thread.
 */
std::vector<LightSpeed>
measureLightField(const FieldCase& field_case, int repeats = 5);

/** \brief Full mode against light mode: microseconds a query on one thread. */
struct FullSpeed {
  double light = 0.0;
  double free_points = 0.0; /**< with free points only */
  double shield = 0.0;      /**< with the surface only */
  double full = 0.0;        /**< with both */
  double build = 0.0;       /**< of both, milliseconds */
  double error = 0.0; /**< of both against every source looked at for itself, over all
                           points, by the sum of all weights */

  double
  ratio() const
  {
    return light > 0.0 ? full / light : 0.0;
  }
};

FullSpeed
measureFullField(const FieldCase& field_case, int repeats = 5);

/** \brief The tables of both measurements. */
void
printLightField(const FieldCase& field_case, const std::vector<LightSpeed>& rows);
void
printFullField(const FieldCase& field_case, const FullSpeed& speed);

} // namespace bench
