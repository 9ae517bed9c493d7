// SPDX-License-Identifier: BSD-3-Clause
// Part of PclSurfaceRepair: which regions could not be closed where nothing has gone
// since.

#pragma once

#include "mesh/box_tree.h"
#include "region/region.h"

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace pcl::repair {

/** \brief Whether all holes of a region stayed open. */
bool
allFailed(const std::vector<HoleOutcome>& holes);

/** \brief Regions of which no hole could be closed. What comes to the surface is more
 * that is in the way: until something goes from it near such a region, it fails again.
 */
class RegionMemory {
public:
  /** \brief What decides how a region is closed, but for the surface. */
  struct Key {
    std::vector<std::array<double, 3>> points; /**< of boundaries and samples */
    std::vector<std::size_t> numbers;          /**< how they belong together */

    bool
    operator<(const Key& other) const;
  };

  static Key
  keyOf(const Region& region, const IncompleteModel& model);

  /** \brief How the holes of such a region failed; null: they did not. */
  const std::vector<HoleOutcome>*
  find(const Key& key) const;

  void
  remember(Key key, const ccaa::Box& place, const std::vector<HoleOutcome>& holes)
  {
    failed_.emplace(std::move(key), Failure{place, holes});
  }

  bool
  empty() const
  {
    return failed_.empty();
  }

  /** \brief To be told when triangles go from the surface. \param[in] gone their boxes
   */
  void
  forgetNear(const std::vector<ccaa::Box>& gone);

private:
  struct Failure {
    ccaa::Box place; /**< where the region is built */
    std::vector<HoleOutcome> holes;
  };

  std::map<Key, Failure> failed_;
};

} // namespace pcl::repair
