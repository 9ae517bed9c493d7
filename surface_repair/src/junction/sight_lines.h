// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: what sensors have seen to be empty.

#pragma once

#include "icadm/incomplete_model.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace pcl::repair {

/** \brief The nearest measured depth in every direction from every sensor.
 *
 * A sensor that has measured a point has seen the way to it empty, so a new surface
 * that crosses the way contradicts the measurement. Directions from a sensor fall into
 * cells of two median angular spacings. Of a cell and its neighbours the nearest depth
 * counts, so what is told is on the safe side. Const methods may be called from several
 * threads. Cost: one look-up for nine cells. */
class SightLines {
public:
  /** \brief Take in what the sensors of a model have measured. Models whose vertices
   * have no sensor position, or more than 256 different ones, have no sight lines. */
  explicit SightLines(const IncompleteModel& model);

  /** \brief No sensor is known. */
  bool
  empty() const
  {
    return views_.empty();
  }

  /** \brief The share of places, 0 to 1, that some sensor looked through at something
   * that lies more than two cells further away. */
  double
  seenEmpty(const Positions& places) const;

  /** \brief Cosine, 0 to 1, of the angle between a chord and the ray to its middle from
   * the sensor that is most across it: near 1 for a jump in depth. */
  double
  alongRay(const Position& begin, const Position& end) const;

private:
  /** Directions of one sensor: a cube around it, each side cut into squares. */
  struct View {
    Position sensor;
    double cell = 0.0; /**< side of a cell on the cube of half side 1 */
    std::unordered_map<std::uint64_t, double> nearest; /**< depth by cell */
  };

  /** Side of the cube that a ray meets, and where. */
  struct Place {
    std::uint64_t side = 0;
    std::int64_t row = 0;
    std::int64_t column = 0;

    std::uint64_t
    key() const;
  };

  static Place
  placeOf(const Position& ray, double cell);
  static bool
  looksThrough(const View& view, const Position& place);

  std::vector<View> views_;
};

} // namespace pcl::repair
