// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: the tensor field whose force lines are the bridges (4.43).

#pragma once

#include <Eigen/Core>

#include "field/falloff.h"
#include "field/field_source.h"
#include "mesh/block_loop.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace pcl::repair {

class FreePointField;
class Shield;

/** \brief Tension H of the field at a point (ED4.43-1): the force on a unit normal n is
 * H n. */
using Tension = Eigen::Matrix3d;

/** \brief Effective charges inside one hole (4.5): sigma = -(tau_X . tau_O) h, and
 * sources within boundary length T of the origin are left out (4.7). */
struct EffectiveCharge {
  Direction tangent;      /**< tau_X: at the point, or at the origin of its line */
  double arc = 0.0;       /**< of the point or the origin, along the curve */
  double threshold = 0.0; /**< T, arc length */
  std::size_t curve = 0;  /**< the hole's curve in the source set: only it counts */
};

/** \brief What the field is asked for at one point. */
struct FieldQuery {
  Position position = Position::Zero();     /**< X */
  Falloff falloff;                          /**< q_1: L_1, L_2, chi */
  std::size_t silent_island = NONE;         /**< base island, whose boundaries are no
                                                 sources at step ICM3 -> ICM2 (4.7) */
  std::optional<EffectiveCharge> effective; /**< step ICM2 -> ICM1 */
};

/** \brief Field H of a set of sources.
 *
 * H = sum over the sources O within L_2 of h m d s^T, with d = unit(XO),
 * s = -d x tau_O, m = q_12 (1 + k_i q_4), q_4 = (1 + s . n_O) / 2 and q_12 =
 * q_1(effective length): Because s is perpendicular to d, this is E4.43-3 to E4.43-5
 * in full, B included. In light mode the effective length is the distance; in full mode
 * (with free points) it is E4.424-2, and a source beyond L_2 does not count however
 * short the way to it. Sources behind the surface do not count (with a shield, E4.43-6;
 * crossings within one source spacing of either end are none).
 *
 * Full mode looks at a few sources of each stretch of boundary and takes the passages
 * to those between from them: within some percent of the sum of weights of looking at
 * all of them, and exactly light mode where nothing is around.
 *
 * The sums run in an order fixed by the sources: the result is the same for any number
 * of threads and any processor, and a point alone gives the bits it gives in a batch.
 * Const methods may be called from several threads. Cost: see doc/concepts/field.md.
 */
class IndicatorField {
public:
  /** \brief \param[in] sources copied into flat arrays
   * \param[in] interpolation k_i, at least 0
   * \param[in] free_points full mode; null: light. Must outlive the field
   * \param[in] shield null: no shielding. Must outlive the field
   * \param[in] coarse_distance at least 0: in light mode eight sources that are further
   * away than so many radii of their stretch of boundary count as one, at its middle;
   * 0: all count for themselves */
  IndicatorField(const SourceSet& sources,
                 double interpolation = 0.0,
                 const FreePointField* free_points = nullptr,
                 const Shield* shield = nullptr,
                 double coarse_distance = 0.0);
  ~IndicatorField();
  IndicatorField(IndicatorField&&) noexcept;

  const SourceSet&
  sources() const;

  /** \brief Tension at one point: H n is h d Q (E4.427-8), and tensions of sources add
   * (E4.43-2). A source at the point itself does not count; the
   * tension is zero where the position is not finite or nothing reaches (L_2 = 0). */
  Tension
  tensionAt(const FieldQuery& query) const;

  /** \brief Tension at many points; much faster than one by one where neighbours in the
   * list lie close together. Zero for queries left out after cancelling. */
  std::vector<Tension>
  tensionAt(const std::vector<FieldQuery>& queries,
            const ccaa::LoopContext& context) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace pcl::repair
