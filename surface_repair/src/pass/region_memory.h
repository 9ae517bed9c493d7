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
 * that is in the way: until something goes from it where such a region has looked, it
 * fails again. */
class RegionMemory {
public:
  /** \brief What decides how a region is closed, but for the surface. */
  struct Key {
    std::vector<std::array<double, 3>> points; /**< of boundaries and samples */
    std::vector<std::size_t> numbers;          /**< how they belong together */

    bool
    operator<(const Key& other) const;
  };

  struct Failure {
    ccaa::Box seen; /**< all that it depends on */
    std::vector<HoleOutcome> holes;
  };

  static Key
  keyOf(const Region& region, const IncompleteModel& model);

  /** \brief How such a region failed; null: it did not. */
  const Failure*
  find(const Key& key) const;

  void
  remember(Key key, Failure failure)
  {
    failed_.emplace(std::move(key), std::move(failure));
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
  std::map<Key, Failure> failed_;
};

} // namespace pcl::repair
